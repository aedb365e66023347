// Where photons of the sky come from: directions by the sky's light and by how much of it the scene's box
// catches, so that all of them carry the same. The GLSL side: sky_photons.glsl.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

inline constexpr std::uint32_t kSkyPhotonRows = 64;  // of cells, even in longitude and angle from the zenith

// A cell of the sky: evenly bright.
struct SkyPhotonCell {
    float cumulative;  // probability of this one or one before it
    vec3 power;  // radiance * solid angle / probability, in lux: times the area seen from there it is lumen
};
static_assert(sizeof(SkyPhotonCell) == 16);

// The cells of a sky that shines on a box, in rows from the zenith; and what the box catches of it, in lumen.
// Empty for a black sky or a box without area. O(pixels of the image).
struct SkyPhotonCells {
    std::vector<SkyPhotonCell> cells;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    dvec3 flux{0};

    static SkyPhotonCells of(const SkyInstance& sky, const Aabb& bounds);
};

// Area of a box as seen along a direction: of its shadow on a plane across. m^2.
double area_across(const Aabb& box, const dvec3& direction);

class SkyPhotons {
  public:
    // O(pixels of the image) where sky or bounds are others than before.
    void follow(const FrameScene& scene);
    // Lumen that enter the scene's box; 0 without a sky.
    const dvec3& flux() const { return flux_; }
    // For a program with sky_photons.glsl, while flux() is not 0: the cells at that storage binding.
    void bind(const gpu::Program& program, GLuint binding) const;

  private:
    std::optional<SkyInstance> sky_;
    Aabb bounds_;
    ivec2 size_{0};
    dvec3 flux_{0};
    gpu::Buffer cells_;
};

}  // namespace lanthorn::gi
