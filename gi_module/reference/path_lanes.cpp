#include "gi_module/reference/path_lanes.h"

#include <cmath>

#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

// Each of these functions is compiled for several widths of registers and the fitting one is chosen when the
// program starts. Sanitizers are not ready that early.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LANTHORN_ALL_WIDTHS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define LANTHORN_ALL_WIDTHS
#endif

namespace lanthorn::reference {

namespace {

// Without a jump, as loops over lanes need it.
vec3 select(bool condition, const vec3& a, const vec3& b) {
    return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

}  // namespace

void LightLanes::set(int i, const PunctualLight& light) {
    position.set(i, light.position);
    direction.set(i, light.direction);
    intensity.set(i, light.intensity);
    range[i] = light.range;
    cone_scale[i] = light.cone_scale;
    cone_offset[i] = light.cone_offset;
    weight[i] = light.weight;
    infinite[i] = light.type == LightType::directional ? 1.0f : 0.0f;
}

void EmitterLanes::set(int i, const EmitterTriangle& triangle) {
    corner.set(i, triangle.corner);
    edge1.set(i, triangle.edge1);
    edge2.set(i, triangle.edge2);
    normal.set(i, triangle.normal);
    radiance.set(i, triangle.radiance);
    density[i] = triangle.density;
    offset[i] = triangle.offset;
    two_sided[i] = triangle.two_sided ? 1.0f : 0.0f;
}

LANTHORN_ALL_WIDTHS void draw_pairs(const PathLanes& paths, std::uint32_t dimension, Lanes<float>& x,
                                    Lanes<float>& y) {
    const int n = paths.filled();
    for (int i = 0; i < n; ++i) {
        const vec2 u = RandomNumbers(paths.key[i], paths.index[i]).pair(dimension);
        x[i] = u.x;
        y[i] = u.y;
    }
}

LANTHORN_ALL_WIDTHS void leave_surfaces(PathLanes& paths, std::uint32_t dimension) {
    const int n = paths.filled();
    for (int i = 0; i < n; ++i) {
        const vec2 u = RandomNumbers(paths.key[i], paths.index[i]).pair(dimension + kDirection);
        const vec3 normal = paths.normal.at(i);
        paths.direction.set(i, cosine_direction(normal, u));
        paths.start.set(i, paths.position.at(i) + normal * paths.offset[i]);
    }
}

LANTHORN_ALL_WIDTHS void pass_surfaces(PathLanes& paths) {
    const int n = paths.filled();
    for (int i = 0; i < n; ++i) {
        paths.throughput.set(i, paths.throughput.at(i) * paths.albedo.at(i));
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const LightLanes& lights,
                                        ShadowLanes& shadows) {
    const int n = paths.filled();
    for (int i = 0; i < n; ++i) {
        const PunctualLight light{.position = lights.position.at(i),
                                  .direction = lights.direction.at(i),
                                  .intensity = lights.intensity.at(i),
                                  .range = lights.range[i],
                                  .cone_scale = lights.cone_scale[i],
                                  .cone_offset = lights.cone_offset[i]};
        const bool infinite = lights.infinite[i] != 0;
        vec3 towards;
        const vec3 near = local_illuminance(light, paths.position.at(i), towards);
        const vec3 to_light = select(infinite, -light.direction, towards);
        const vec3 illuminance = select(infinite, light.intensity, near);
        const Lambert lambert{paths.albedo.at(i), paths.normal.at(i)};
        shadows.light.set(i, illuminance * lambert.evaluate(to_light) * lights.weight[i]);
        shadows.span.set(i, select(infinite, to_light, light.position - paths.start.at(i)));
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const EmitterLanes& emitters,
                                        ShadowLanes& shadows) {
    const int n = paths.filled();
    for (int i = 0; i < n; ++i) {
        const vec3 b = triangle_point({emitters.u[i], emitters.v[i]});
        const vec3 point = emitters.corner.at(i) + emitters.edge1.at(i) * b.y + emitters.edge2.at(i) * b.z;
        const vec3 normal = emitters.normal.at(i);
        const vec3 span = point - paths.position.at(i);
        const float d2 = glm::dot(span, span);
        const vec3 l = span * (1 / std::sqrt(d2));
        const float facing = -glm::dot(normal, l);
        const float cosine = emitters.two_sided[i] != 0 ? std::abs(facing) : facing;
        const Lambert lambert{paths.albedo.at(i), paths.normal.at(i)};
        const vec3 scattered = lambert.evaluate(l) * emitters.radiance.at(i);
        // 1 / density per solid angle, and the power heuristic of it.
        const float inverse = cosine / (emitters.density[i] * d2);
        const float ratio = lambert.density(l) * inverse;
        const float weight = inverse / (1 + ratio * ratio);
        const vec3 side = select(facing < 0, -normal, normal);
        const bool seen = d2 > 0 && cosine > 0 && !is_black(scattered);
        shadows.light.set(i, select(seen, scattered * weight, vec3(0)));
        shadows.span.set(i, point + side * emitters.offset[i] - paths.start.at(i));
    }
}

}  // namespace lanthorn::reference
