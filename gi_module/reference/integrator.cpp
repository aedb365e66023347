#include "gi_module/reference/integrator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr int kMostLayers = 1000;  // see-through surfaces on one ray

}  // namespace

Integrator::Integrator(const TraceScene& scene, const MaterialTable& materials, const Emitters& emitters,
                       const PunctualLights& lights, const PathSettings& settings)
    : scene_(scene),
      materials_(materials),
      emitters_(emitters),
      lights_(lights),
      settings_(settings),
      blended_(settings.transport == Transport::full ? Blended::met : Blended::ignored) {
    if (settings.transport == Transport::full) {
        sees_through_ = std::ranges::any_of(scene.instances(), [&](const TraceInstance& instance) {
            return materials[instance.material].sees_through;
        });
    }
}

int Integrator::bounce_limit() const {
    return settings_.unlimited ? kMostReflections : settings_.bounces;
}

// Backs of single-sided surfaces end light: nobody is meant to see them. Those of glass do not.
bool Integrator::reflects(const SurfaceHit& hit) const {
    const MaterialConstants& material = materials_[scene_.instances()[hit.instance].material];
    return !material.unlit &&
           (hit.front || material.double_sided || (sees_through_ && material.sees_through));
}

SurfaceMaterial Integrator::material_at(const SurfaceHit& hit) const {
    return materials_.evaluate(scene_.instances()[hit.instance], hit.primitive, hit.barycentric);
}

Bsdf Integrator::bsdf_at(const SurfaceHit& hit, const SurfaceMaterial& material, const vec3& towards) const {
    const TraceInstance& instance = scene_.instances()[hit.instance];
    const MaterialConstants& constants = materials_[instance.material];
    // The rasteriser shows nothing through its surfaces yet, nor does the transport that is compared with it.
    const bool straight =
        settings_.transport == Transport::diffuse || (constants.sees_through && !constants.blend);
    return Bsdf(material, materials_.shading_normal(instance, hit), hit.normal, towards, straight);
}

vec3 Integrator::emission(const SurfaceHit& hit) const {
    const TraceInstance& instance = scene_.instances()[hit.instance];
    const MaterialConstants& material = materials_[instance.material];
    if (!material.emits || !(hit.front || material.double_sided)) {
        return vec3(0);
    }
    return materials_.emission(instance, hit.primitive, hit.barycentric);
}

std::optional<FirstSurface> Integrator::first_surface(const CameraRay& ray) const {
    SurfaceHit hit;
    if (!scene_.intersect(ray.origin, ray.direction, ray.nearest, ray.farthest, Blended::ignored, hit,
                          Sides::seen)) {
        return std::nullopt;
    }
    return FirstSurface{hit, -ray.direction};
}

bool Integrator::meets(const Ray& ray, float nearest, SurfaceHit& hit) const {
    if (!scene_.intersect(ray.origin, ray.direction, nearest, kInfinity, blended_, hit)) {
        return false;
    }
    if (!hit.front && !materials_[scene_.instances()[hit.instance].material].double_sided) {
        scene_.prefer_front(ray.origin, ray.direction, blended_, hit);
    }
    return true;
}

vec3 Integrator::transmittance(const vec3& from, const vec3& span, bool to_infinity) const {
    if (!sees_through_) {
        return scene_.occluded(from, span, to_infinity, blended_) ? vec3(0) : vec3(1);
    }
    vec3 result(1);
    const vec3 towards = -glm::normalize(span);
    const float end = to_infinity ? kInfinity : 1.0f;
    float nearest = 0;
    SurfaceHit hit;
    for (int layer = 0; layer < kMostLayers; ++layer) {
        if (!scene_.intersect(from, span, nearest, end, blended_, hit)) {
            return result;
        }
        if (!materials_[scene_.instances()[hit.instance].material].sees_through) {
            break;
        }
        result *= bsdf_at(hit, material_at(hit), towards).straight_through();
        if (is_black(result)) {
            break;
        }
        nearest = std::nextafter(hit.t, kInfinity);
    }
    return vec3(0);
}

bool Integrator::next_surface(const Ray& ray, const RandomNumbers& random, std::uint32_t dimension,
                              SurfaceHit& hit, float& distance, vec3& throughput) const {
    float nearest = 0;
    for (int layer = 0; layer < kMostLayers; ++layer) {
        if (!meets(ray, nearest, hit)) {
            return false;
        }
        distance = hit.t;
        if (!sees_through_ || !materials_[scene_.instances()[hit.instance].material].sees_through) {
            return true;
        }
        const vec3 straight = bsdf_at(hit, material_at(hit), -ray.direction).straight_through();
        const float chance = glm::clamp(largest(straight), 0.0f, 1.0f);
        const auto turn = std::min(static_cast<std::uint32_t>(layer), kStraightChoices - 1);
        const vec2 u = random.pair(dimension + kStraight + turn);
        if (u.x >= chance) {
            throughput /= 1 - chance;
            return true;
        }
        throughput *= straight / chance;
        nearest = std::nextafter(hit.t, kInfinity);
    }
    return false;
}

bool Integrator::survives(const RandomNumbers& random, std::uint32_t dimension, vec3& throughput,
                          int reflections) const {
    if (!settings_.unlimited || reflections < kRouletteFrom) {
        return true;
    }
    const float chance = std::min(largest(throughput), kMostSurvive);
    throughput /= std::max(chance, std::numeric_limits<float>::min());
    return random.pair(dimension + kLobe).y < chance;
}

vec3 Integrator::draw_lights(const SurfaceHit& hit, const Bsdf& scattering, const RandomNumbers& random,
                             std::uint32_t dimension) const {
    const TraceTriangle& triangle = scene_.triangles()[hit.triangle];
    const vec2 choices = lights_.several() || emitters_.many() ? random.pair(dimension + kChoices) : vec2(0);
    vec3 sum(0);
    // Starts on the side that the light comes from: behind a thin wall, too.
    const auto start = [&](const vec3& l) {
        return off_surface(hit, glm::dot(hit.normal, l) < 0 ? -hit.normal : hit.normal, triangle);
    };
    if (!lights_.empty()) {
        const PunctualLight& light = lights_.draw(choices.x);
        const LightSample sample = PunctualLights::illuminance(light, hit.position);
        const vec3 reflected = sample.illuminance * scattering.evaluate(sample.to_light) * light.weight;
        if (!is_black(reflected)) {
            const vec3 from = start(sample.to_light);
            const vec3 span = sample.infinite ? sample.to_light : light.position - from;
            sum += reflected * transmittance(from, span, sample.infinite);
        }
    }
    if (!emitters_.empty()) {
        const EmitterSample sample = emitters_.draw(choices.y, random.pair(dimension + kEmitter));
        const vec3 span = sample.position - hit.position;
        const float d2 = glm::dot(span, span);
        if (d2 > 0) {
            const vec3 l = span * (1 / std::sqrt(d2));
            const float facing = -glm::dot(sample.normal, l);
            const float cosine = sample.two_sided ? std::abs(facing) : facing;
            const vec3 scattered = scattering.evaluate(l) * sample.radiance;
            if (cosine > 0 && !is_black(scattered)) {
                // 1 / density per solid angle, and the power heuristic of it.
                const float inverse = cosine / (sample.density * d2);
                const float ratio = scattering.density(l) * inverse;
                const vec3 from = start(l);
                const vec3 side = facing < 0 ? -sample.normal : sample.normal;
                const vec3 shadow = sample.position + side * sample.offset - from;
                const float weight = inverse / (1 + ratio * ratio);
                sum += scattered * weight * transmittance(from, shadow, false);
            }
        }
    }
    return sum;
}

Integrator::Incoming Integrator::incoming(const Ray& first, const RandomNumbers& random,
                                          std::uint32_t path) const {
    Incoming result;
    SurfaceHit hit;
    Ray ray = first;
    vec3 throughput(1);
    float distance = 0;
    if (!next_surface(ray, random, vertex_dimension(path, 0), hit, distance, throughput)) {
        return result;
    }
    result.emitted = throughput * emission(hit);
    result.light_density = emitters_.density(hit, distance, -glm::dot(hit.normal, ray.direction));
    const int limit = bounce_limit();
    for (int reflections = 1; reflections <= limit && reflects(hit); ++reflections) {
        const std::uint32_t dimension = vertex_dimension(path, reflections);
        const Bsdf bsdf = bsdf_at(hit, material_at(hit), -ray.direction);
        result.reflected += throughput * draw_lights(hit, bsdf, random, dimension);
        if (reflections == limit && emitters_.empty()) {
            break;
        }
        const vec3 direction =
            bsdf.sample(random.pair(dimension + kLobe).x, random.pair(dimension + kDirection));
        const float density = bsdf.density(direction);
        if (!(density > 0)) {
            break;
        }
        throughput *= bsdf.evaluate(direction) / density;
        if (is_black(throughput) || !survives(random, dimension, throughput, reflections)) {
            break;
        }
        const vec3 side = glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal;
        ray = {off_surface(hit, side, scene_.triangles()[hit.triangle]), direction};
        if (!next_surface(ray, random, dimension, hit, distance, throughput)) {
            break;
        }
        const vec3 emitted = emission(hit);
        if (!is_black(emitted)) {
            const float other = emitters_.density(hit, distance, -glm::dot(hit.normal, direction));
            result.reflected += throughput * emitted * power_heuristic(density, other);
        }
    }
    return result;
}

Integrator::Shaded Integrator::shade(const SurfaceHit& hit, const vec3& towards,
                                     const SurfaceMaterial& material, const RandomNumbers& random,
                                     bool with_indirect) const {
    constexpr std::uint32_t kPath = 1;
    const std::uint32_t dimension = vertex_dimension(kPath, 0) + kVertexDimensions * (kMostReflections + 1);
    const Bsdf bsdf = bsdf_at(hit, material, towards);
    Shaded result;
    result.direct = draw_lights(hit, bsdf, random, dimension);
    if (emitters_.empty() && !with_indirect) {
        return result;
    }
    const vec3 direction = bsdf.sample(random.pair(dimension + kLobe).x, random.pair(dimension + kDirection));
    const float density = bsdf.density(direction);
    if (!(density > 0)) {
        return result;
    }
    const vec3 weight = bsdf.evaluate(direction) / density;
    if (is_black(weight)) {
        return result;
    }
    const vec3 side = glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal;
    const Ray ray{off_surface(hit, side, scene_.triangles()[hit.triangle]), direction};
    if (with_indirect) {
        const Incoming in = incoming(ray, random, kPath);
        result.direct += weight * in.emitted * power_heuristic(density, in.light_density);
        result.indirect = weight * in.reflected;
        return result;
    }
    SurfaceHit lamp;
    float distance = 0;
    vec3 throughput(1);
    if (next_surface(ray, random, vertex_dimension(kPath, 0), lamp, distance, throughput)) {
        const float other = emitters_.density(lamp, distance, -glm::dot(lamp.normal, direction));
        result.direct += weight * throughput * emission(lamp) * power_heuristic(density, other);
    }
    return result;
}

// Blended surfaces in front show themselves with the chance of their alpha.
vec3 Integrator::radiance(const CameraRay& ray, const FirstSurface* first, const PathSample& so_far,
                          const RandomNumbers& random) const {
    const bool full = settings_.transport == Transport::full;
    if (scene_.has_blended() || (full && sees_through_)) {
        float nearest = ray.nearest;
        SurfaceHit hit;
        vec3 throughput(1);
        for (int layer = 0; layer < kMostLayers; ++layer) {
            if (!scene_.intersect(ray.origin, ray.direction, nearest, ray.farthest, Blended::met, hit,
                                  full ? Sides::both : Sides::seen)) {
                return vec3(0);
            }
            nearest = std::nextafter(hit.t, kInfinity);
            const MaterialConstants& constants = materials_[scene_.instances()[hit.instance].material];
            if (!hit.front && !constants.double_sided &&
                !(full && constants.sees_through && !constants.blend)) {
                continue;
            }
            const bool layered = constants.blend || (full && constants.sees_through);
            if (!layered) {
                break;
            }
            const SurfaceMaterial material = material_at(hit);
            const vec3 straight =
                full ? bsdf_at(hit, material, -ray.direction).straight_through() : vec3(1 - material.alpha);
            const float chance = glm::clamp(largest(straight), 0.0f, 1.0f);
            const auto turn = std::min(static_cast<std::uint32_t>(layer), kVertexDimensions - 1);
            if (random.pair(kCameraDimension + turn).x < chance) {
                throughput *= straight / chance;
                continue;
            }
            throughput /= 1 - chance;
            if (constants.unlit) {
                return throughput * material.base_colour * material.alpha;
            }
            const Shaded shaded = shade(hit, -ray.direction, material, random, full);
            return throughput * (shaded.direct + shaded.indirect + material.emissive * material.alpha);
        }
        if (full) {
            const SurfaceMaterial material = material_at(hit);
            if (materials_[scene_.instances()[hit.instance].material].unlit) {
                return throughput * material.base_colour;
            }
            const Shaded shaded = shade(hit, -ray.direction, material, random, true);
            return throughput * (shaded.direct + shaded.indirect + material.emissive);
        }
    }
    if (!first) {
        return vec3(0);
    }
    const SurfaceMaterial material = material_at(first->hit);
    if (materials_[scene_.instances()[first->hit.instance].material].unlit) {
        return material.base_colour;
    }
    if (full) {
        const Shaded shaded = shade(first->hit, first->towards, material, random, true);
        return shaded.direct + shaded.indirect + material.emissive;
    }
    return so_far.direct + material.emissive +
           so_far.indirect * material.diffuse_albedo() * (material.occlusion / kPi);
}

void Integrator::sample(std::span<const SampleStart> starts, const SampleParts& parts,
                        std::span<PathSample> results) const {
    const bool full = settings_.transport == Transport::full;
    const bool composed = parts.radiance && !full;  // radiance from the other two
    const bool indirect = parts.indirect || composed;
    std::ranges::fill(results.first(starts.size()), PathSample{});
    if (indirect && !full) {
        for (std::size_t begin = 0; begin < starts.size(); begin += kLanes) {
            const std::size_t count = std::min(starts.size() - begin, std::size_t{kLanes});
            diffuse_indirect(starts.subspan(begin, count), results.subspan(begin, count));
        }
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const auto& [ray, first, random] = starts[i];
        PathSample& result = results[i];
        if (first) {
            const SurfaceHit& hit = first->hit;
            if (indirect && full) {
                const vec3 direction =
                    cosine_direction(hit.normal, random.pair(vertex_dimension(0, 0) + kDirection));
                const Ray up{off_surface(hit, hit.normal, scene_.triangles()[hit.triangle]), direction};
                result.indirect = incoming(up, random, 0).reflected * kPi;
            }
            if (parts.direct || composed) {
                if (!materials_[scene_.instances()[hit.instance].material].unlit) {
                    result.direct = shade(hit, first->towards, material_at(hit), random, false).direct;
                }
            }
        }
        if (parts.radiance) {
            result.radiance = radiance(ray, first, result, random);
        }
    }
}

}  // namespace lanthorn::reference
