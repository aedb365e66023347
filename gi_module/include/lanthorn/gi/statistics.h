// What a technique says of a frame. What it counts are types of its own, beside it (emc/emc_statistics.h).
#pragma once

#include <any>
#include <cstdint>
#include <utility>
#include <vector>

#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

// What is known of how far the indirect light of a picture lies off the truth, without a reference
// (docs/error-estimate.md). Squares, relative: of light over the picture's mean for `relrmse`; for `local`
// of luminance, each place over the root of its square and a hundredth of the mean's.
struct ErrorParts {
    double noise = 0;     // of the rays, after the filter: by the two halves of what each point knows
    double blur = 0;      // what the filter has moved, noise taken off
    double bend = 0;      // of light from point to point of the grid, beside a straight line, noise taken off
    double contrast = 0;  // variance of what single rays bring
    double unknown = 0;   // rays that met what no map shows

    // All of them times `factor`.
    ErrorParts operator*(double factor) const {
        return {noise * factor, blur * factor, bend * factor, contrast * factor, unknown * factor};
    }
};

// An error that is estimated: four pictures in five have one between `low` and `high`.
struct EstimatedError {
    double value = 0, low = 0, high = 0;
};

// Of the picture of one frame: indirect relRMSE and local error, as `lanthorn measure` has them.
struct ErrorEstimate {
    bool known = false;  // false: the technique does not say, or shows no light
    EstimatedError relrmse, local;
    // What they are made of.
    ErrorParts relrmse_parts, local_parts;
    double photons = 0;  // behind the light on the maps; 0: no photon lights them
    double texels = 0;   // a side of a lit map's face
};

// How far a picture has come that is the mean of samples, of which each frame adds some while nothing
// changes.
struct SampleProgress {
    int done = 0, wanted = 0;  // samples a pixel; wanted 0: it is no such picture, or has no light
    bool ended = false;  // no frame adds more: all are taken, or the noise that was asked for is reached

    bool operator==(const SampleProgress&) const = default;
};

// Statistics of one frame: its plan, how many values were NaN or infinite and therefore left out, and parts
// of the technique's own types.
class GiStatistics {
  public:
    GiPlan plan;
    std::uint64_t nan_count = 0;

    // At most one part of a type: a later one takes its place.
    template <typename Part>
    void add(Part part) {
        for (std::any& p : parts_) {
            if (std::any_cast<Part>(&p) != nullptr) {
                p = std::move(part);
                return;
            }
        }
        parts_.emplace_back(std::move(part));
    }

    // The part of a type; one of an idle technique where there is none. O(parts).
    template <typename Part>
    const Part& of() const {
        for (const std::any& p : parts_) {
            if (const Part* part = std::any_cast<Part>(&p)) {
                return *part;
            }
        }
        static const Part kIdle;
        return kIdle;
    }

  private:
    std::vector<std::any> parts_;
};

}  // namespace lanthorn::gi
