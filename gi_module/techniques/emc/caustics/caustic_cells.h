// Irradiance by caustic photons for points that are not on the picture: what mirrors and glass show. It is
// known at some of the photons (Christensen 1999, "Faster Photon Map Global Illumination"), and a point takes
// the mean of those around it. They are found by a hash table of cells, of several sizes: a disc is in all
// those of its own size that it reaches, so that a point asks one cell a size (Teschner et al. 2003,
// "Optimized Spatial Hashing").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/techniques/emc/caustics/caustic_photons.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

// The table as caustic_cells.glsl reads it. Pure data, no GL.
struct CausticCellTable {
    std::uint32_t slots = 0;  // a power of two; 0: there are no photons
    float finest = 0;         // side of the smallest cells, metres; twice that of the next size
    int sizes = 0;
    // Two words a slot: where its list begins and how many photons it has (0: none); then the lists. Cells of
    // the same slot share its list.
    std::vector<std::uint32_t> words;

    // The smallest splats share the smallest cells. O(hits log hits).
    static CausticCellTable of(std::span<const PhotonHit> hits);
    // Calls `found` with the index of each photon whose splat may reach `place`, some of them twice.
    template <class Found>
    void near(const vec3& place, const Found& found) const {
        for (int size = 0; size < sizes; ++size) {
            const std::uint32_t slot = 2 * slot_of(place, size);
            for (std::uint32_t i = 0; i < words[slot + 1]; ++i) {
                found(words[words[slot] + i], size);
            }
        }
    }
    // Whether a splat of that radius is in cells of that size: its own.
    bool is_own(float radius, int size) const;

  private:
    std::uint32_t slot_of(const vec3& place, int size) const;
};

// Irradiance at every fourth of the hits, by all of them: power is that, in lux; the radius is that of the
// disc in which it is good for others. `thin`: a length that is nothing in the scene. O(hits).
std::vector<PhotonHit> caustic_samples(std::span<const PhotonHit> hits, float thin);

class CausticCells {
  public:
    // Of these photons from now on, of which those of a `version` that is known are not looked at again.
    // Light that has been scattered is another's than what has not: its discs are wider.
    void sort(const CausticPhotons& photons, float thin);
    // For caustic_cells.glsl: two texture units.
    void bind(const gpu::Program& program, GLuint first_unit);

  private:
    CausticCellTable table_;
    std::uint64_t version_ = 0;
    int straight_ = 0;  // of the samples: those of light that nothing has scattered
    gpu::Buffer words_, samples_;
    gpu::BufferTexture words_view_, samples_view_;
};

}  // namespace lanthorn::gi
