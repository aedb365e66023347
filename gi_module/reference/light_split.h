// Why a point is as bright as it is: the light that arrives there, split by lamp, number of reflections and
// first surface, and what stands in the way of more. By the reference's own paths (Kajiya 1986), so that the
// parts add up to what `path` finds there.
//
//   LightSplitter splitter(frame, settings);
//   if (const auto point = splitter.seen(frame.camera, size, pixel)) {
//       const LightSplit split = splitter.split(*point);
//   }
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gi_module/reference/light_source.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

// A place on a surface. Render space.
struct LitPoint {
    vec3 position{0}, normal{0};  // unit, on the side that is seen
    float offset = 0;             // metres a ray must start off it
    std::uint32_t entity = 0;     // Instance::id
};

// Light with its luminance's standard error, lux.
struct Lux {
    dvec3 rgb{0};
    double noise = 0;

    double value() const;  // luminance
};

// Why a lamp gives nothing straight to the point, or that it does.
enum class Straight { lit, hidden, behind, out_of_range, out_of_cone, no_light };

// One lamp's part. Emissive surfaces of one entity are one lamp, and the sky is one.
struct LampPart {
    LightSource source;
    std::uint32_t entity = 0;  // LightInstance::id, Instance::id; of the sky 0
    Straight straight = Straight::no_light;
    Lux direct;
    std::vector<Lux> reflected;  // by the number of reflections, from 1
    Lux sum;
};

// What a lamp would give if something were not there. The lux are exact for a punctual lamp's direct light.
struct HiddenPart {
    LightSource source;
    std::uint32_t entity = 0;              // the lamp's
    std::vector<std::uint32_t> occluders;  // entities, all of them in the way; up to kMostOccluders
    Lux direct, reflected;
    // Reflected light is that of the scene without them. Else it is what the paths of now would bring: no
    // more than a lower limit, as paths that go on through the gap bring more.
    bool whole = false;
};
inline constexpr std::size_t kMostOccluders = 3;
inline constexpr std::size_t kMostWithout =
    3;  // sets of occluders that are looked into so, the most promising

// Reflected light by the surface that the point has it from.
struct SurfacePart {
    std::uint32_t entity = 0;
    Lux reflected;
};

// Light along one way: a lamp, and entities from the one that the point sees to the one that the lamp lights.
struct LightWay {
    LightSource source;
    std::uint32_t entity = 0;  // the lamp's
    std::vector<std::uint32_t> entities;
    double lux = 0;  // luminance, of all paths that go so
    // The strongest of these paths, from the point to the lamp; the sky's last place is where the ray leaves
    // the scene.
    std::vector<vec3> places;
};

struct LightSplit {
    Lux direct, reflected,
        sky;  // straight from lamps; after 1 to gi.bounces reflections; straight from the sky
    std::vector<LampPart> lamps;        // by what they give, most first
    std::vector<SurfacePart> surfaces;  // likewise
    std::vector<HiddenPart> hidden;     // likewise, by both their lux
    std::vector<LightWay> ways;         // the eight strongest of reflected light
    int paths = 0;

    Lux indirect() const;  // what `path` calls so: reflected light and the sky's
};

class LightSplitter {
  public:
    // Keeps a copy of the scene. `settings`: gi.bounces, gi.seed and path.transport count. O(triangles log
    // triangles); throws InputError for what Embree cannot hold.
    LightSplitter(const FrameScene& scene, const PathSettings& settings);
    ~LightSplitter();

    // Becomes another frame's: where nothing but lamps, the sky and the camera differ only those are taken.
    // False, and nothing is changed, if surfaces differ: make it anew. O(instances).
    bool follow(const FrameScene& scene);

    // What the pixel's centre sees, blended surfaces passed over; rows from the top.
    std::optional<LitPoint> seen(const CameraView& camera, ivec2 size, ivec2 pixel) const;
    // The light there by so many paths, rounded up to a multiple of kBatches. The same for the same scene,
    // point and number. O(paths * bounces * log triangles).
    LightSplit split(const LitPoint& point, int paths = 4096) const;
    // Its lamps alone, faster.
    std::vector<LampPart> lamps(const LitPoint& point, int paths) const;

    // The sum alone, faster; the same numbers but for rounding.
    Lux light(const LitPoint& point, int paths) const;
    // Evenly spread over all surfaces that gather light within a box: `to_box` takes render space to one
    // whose corners are -0.5 and 0.5. Up to `count` points, none where there is no surface. The same for the
    // same scene.
    std::vector<LitPoint> points_within(const mat4& to_box, int count) const;
    // On the disc around a place, on the side of the unit normal: what stands on the surface there.
    std::vector<LitPoint> points_on_disc(const vec3& position, const vec3& normal, float radius,
                                         int count) const;

    // Each has random numbers of its own: noise is what they differ by.
    static constexpr int kBatches = 16;

  private:
    struct State;
    LightSplit split_parts(const LitPoint& point, int paths, bool with_hidden) const;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::reference
