// Scenes whose light is known on paper, made in memory.
#pragma once

#include <vector>

#include "engine/scene/frame_scene.h"
#include "gi_module/reference/path_tracer.h"

namespace lanthorn::reference::test {

// Diffuse, no specular lobe.
Material lambertian(const vec3& albedo);
// Black, emitting `nits` from its front.
Material lamp(const vec3& nits);

// A parallelogram with corner `p` and edges `u`, `v`; its front is the side that u x v points to.
Mesh quad(const vec3& p, const vec3& u, const vec3& v, std::uint32_t material);
// A subdivided icosahedron about `centre` with smooth normals, 20 * 4^levels triangles; `inward`: fronts face
// the inside.
Mesh sphere(const vec3& centre, float radius, int levels, bool inward, std::uint32_t material);

LightInstance point_light(const vec3& position, float candela);
LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float inner,
                         float outer);
LightInstance directional_light(const vec3& direction, float lux);

// All meshes placed untransformed; seen from `eye`, 60 degrees high.
FrameScene scene_of(std::vector<Mesh> meshes, std::vector<Material> materials,
                    std::vector<LightInstance> lights, const vec3& eye, const vec3& target);

// An orthographic camera that looks at `target` from `eye` and sees `half_width` to each side: all its pixels
// see nearly the same point.
void look_closely(FrameScene& scene, const vec3& eye, const vec3& target, float half_width);

// Mean over all pixels and channels of one AOV after settings.spp samples, in double precision.
double mean_of(const FrameScene& scene, const PathSettings& settings, PathAov aov, ivec2 size = ivec2(16));

}  // namespace lanthorn::reference::test
