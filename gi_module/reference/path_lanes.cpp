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

// Of a loop: no lane reads what another has written.
#if defined(__GNUC__) && !defined(__clang__)
#define LANTHORN_EACH_ALONE _Pragma("GCC ivdep")
#else
#define LANTHORN_EACH_ALONE
#endif
#define LANTHORN_INLINE [[gnu::always_inline]] inline

namespace lanthorn::reference {

namespace {

LANTHORN_INLINE Lambert scattering(const PathLanes& paths, int i) {
    return {paths.albedo.at(i), paths.normal.at(i)};
}

LANTHORN_INLINE Bsdf scattering(const PathLanes& paths, const MaterialLanes& m, int i) {
    SurfaceMaterial material;
    material.base_colour = m.base_colour.at(i);
    material.alpha = m.alpha[i];
    material.metallic = m.metallic[i];
    material.roughness = m.roughness[i];
    material.f0 = m.f0[i];
    material.transmission = m.transmission[i];
    return Bsdf(material, m.shading.at(i), paths.normal.at(i), m.towards.at(i), m.straight[i] != 0);
}

// A ray's start on the side that it goes to: behind a thin wall, too.
LANTHORN_INLINE vec3 start(const PathLanes& paths, int i, const vec3& l) {
    const vec3 normal = paths.normal.at(i);
    const float offset = paths.offset[i];
    return paths.position.at(i) + normal * (glm::dot(normal, l) < 0 ? -offset : offset);
}

template <class Scattering>
LANTHORN_INLINE void light_surface(const PathLanes& paths, int i, const Scattering& surface,
                                   const LightLanes& lights, ShadowLanes& shadows) {
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
    const vec3 from = start(paths, i, to_light);
    shadows.light.set(i, illuminance * surface.evaluate(to_light) * lights.weight[i]);
    shadows.start.set(i, from);
    shadows.span.set(i, select(infinite, to_light, light.position - from));
}

template <class Scattering>
LANTHORN_INLINE void light_surface(const PathLanes& paths, int i, const Scattering& surface,
                                   const EmitterLanes& emitters, ShadowLanes& shadows) {
    const vec3 b = triangle_point({emitters.u[i], emitters.v[i]});
    const vec3 point = emitters.corner.at(i) + emitters.edge1.at(i) * b.y + emitters.edge2.at(i) * b.z;
    const vec3 normal = emitters.normal.at(i);
    const vec3 span = point - paths.position.at(i);
    const float d2 = glm::dot(span, span);
    const vec3 l = span * (1 / std::sqrt(d2));
    const float facing = -glm::dot(normal, l);
    const float cosine = emitters.two_sided[i] != 0 ? std::abs(facing) : facing;
    const vec3 scattered = surface.evaluate(l) * emitters.radiance.at(i);
    // 1 / density per solid angle, and the power heuristic of it.
    const float inverse = cosine / (emitters.density[i] * d2);
    const float ratio = surface.density(l) * inverse;
    const float weight = inverse / (1 + ratio * ratio);
    const vec3 side = select(facing < 0, -normal, normal);
    const vec3 nothing(0);
    const vec3 from = start(paths, i, l);
    // One after the other: the compiler makes no vectors of conditions joined.
    const vec3 light = select(d2 > 0, select(cosine > 0, scattered * weight, nothing), nothing);
    shadows.light.set(
        i, {scattered.x == 0 ? 0 : light.x, scattered.y == 0 ? 0 : light.y, scattered.z == 0 ? 0 : light.z});
    shadows.start.set(i, from);
    shadows.span.set(i, point + side * emitters.offset[i] - from);
}

}  // namespace

void MaterialLanes::set(int lane, const SurfaceMaterial& material, const vec3& n, const vec3& v,
                        bool goes_straight) {
    towards.set(lane, v);
    shading.set(lane, n);
    base_colour.set(lane, material.base_colour);
    alpha[lane] = material.alpha;
    metallic[lane] = material.metallic;
    roughness[lane] = material.roughness;
    f0[lane] = material.f0;
    transmission[lane] = material.transmission;
    straight[lane] = goes_straight ? 1.0f : 0.0f;
}

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
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        const vec2 u = RandomNumbers(paths.key[i], paths.index[i]).pair(dimension);
        x[i] = u.x;
        y[i] = u.y;
    }
}

LANTHORN_ALL_WIDTHS void leave_surfaces(PathLanes& paths, std::uint32_t dimension) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        const vec2 u = RandomNumbers(paths.key[i], paths.index[i]).pair(dimension + kDirection);
        const vec3 normal = paths.normal.at(i);
        const vec3 direction = cosine_direction(normal, u);
        paths.direction.set(i, direction);
        paths.density[i] = std::max(glm::dot(normal, direction), 0.0f) * (1 / kPi);
        paths.start.set(i, paths.position.at(i) + normal * paths.offset[i]);
    }
}

LANTHORN_ALL_WIDTHS void leave_surfaces(PathLanes& paths, const MaterialLanes& materials,
                                        std::uint32_t dimension) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        const RandomNumbers random(paths.key[i], paths.index[i]);
        const Bsdf bsdf = scattering(paths, materials, i);
        const vec3 direction =
            bsdf.sample(random.pair(dimension + kLobe).x, random.pair(dimension + kDirection));
        const float density = bsdf.density(direction);
        const vec3 share = bsdf.evaluate(direction) / density;
        paths.direction.set(i, direction);
        paths.density[i] = density;
        paths.throughput.set(i, paths.throughput.at(i) * select(density > 0, share, vec3(0)));
        paths.start.set(i, start(paths, i, direction));
    }
}

LANTHORN_ALL_WIDTHS void pass_surfaces(PathLanes& paths) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        paths.throughput.set(i, paths.throughput.at(i) * paths.albedo.at(i));
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const LightLanes& lights,
                                        ShadowLanes& shadows) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        light_surface(paths, i, scattering(paths, i), lights, shadows);
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const MaterialLanes& materials,
                                        const LightLanes& lights, ShadowLanes& shadows) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        light_surface(paths, i, scattering(paths, materials, i), lights, shadows);
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const EmitterLanes& emitters,
                                        ShadowLanes& shadows) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        light_surface(paths, i, scattering(paths, i), emitters, shadows);
    }
}

LANTHORN_ALL_WIDTHS void light_surfaces(const PathLanes& paths, const MaterialLanes& materials,
                                        const EmitterLanes& emitters, ShadowLanes& shadows) {
    const int n = paths.filled();
    LANTHORN_EACH_ALONE
    for (int i = 0; i < n; ++i) {
        light_surface(paths, i, scattering(paths, materials, i), emitters, shadows);
    }
}

}  // namespace lanthorn::reference
