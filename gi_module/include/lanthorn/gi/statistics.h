// What a technique says of a frame. What it counts are types of its own, beside it (emc/emc_statistics.h).
#pragma once

#include <any>
#include <cstdint>
#include <utility>
#include <vector>

#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

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
