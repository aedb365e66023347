// Small scenes made in memory, and a frame rendered of them with a technique: what the tests of the indirect
// light share.
#pragma once

#include <memory>
#include <vector>

#include "engine/gpu/context.h"
#include "engine/render/frame.h"
#include "engine/scene/frame_scene.h"
#include "gi_module/technique.h"

namespace lanthorn::gi::test {

// Diffuse, no specular lobe.
Material lambertian(const vec3& albedo);

// A parallelogram with corner `p` and edges `u`, `v`; its front is the side that u x v points to.
Mesh quad(const vec3& p, const vec3& u, const vec3& v, std::uint32_t material);

// A closed box; `inward`: its fronts face the inside.
Mesh box(const vec3& lower, const vec3& upper, bool inward, std::uint32_t material);

// A subdivided icosahedron of `radius` with smooth normals, 20 * 4^levels triangles, fronts facing the
// inside.
Mesh inward_sphere(float radius, int levels, std::uint32_t material);

// All meshes placed untransformed, everything marked changed.
FrameScene scene_of(std::vector<Mesh> meshes, std::vector<Material> materials,
                    std::vector<LightInstance> lights, const vec3& eye, const vec3& target);

// Marks nothing as changed, for a second frame.
void hold_still(FrameScene& scene);

LightInstance point_light(const vec3& position, float candela);
LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float outer_cone);

// The one context of a test program; made at the first call.
gpu::Context& context();

// One renderer, one technique.
class Bench {
  public:
    explicit Bench(TechniqueKind kind = TechniqueKind::emc);
    // Renders and returns the indirect irradiance, three floats a pixel, rows from the top.
    render::FloatImage frame(const FrameScene& scene, ivec2 size, bool timed = false);

    const bool software = context().info().software;  // first: the rest needs a current context
    GiSettings settings;
    render::FrameRenderer renderer;
    std::unique_ptr<Technique> technique;
    std::vector<gpu::PassTimer::Span> spans;  // of the last timed frame
};

}  // namespace lanthorn::gi::test
