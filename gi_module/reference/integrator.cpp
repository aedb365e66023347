#include "gi_module/reference/integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/scene/alpha_coverage.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr int kMostLayers = 1000;  // see-through surfaces on one ray

}  // namespace

Integrator::Integrator(const TraceScene& scene, const MaterialTable& materials, const Emitters& emitters,
                       const PunctualLights& lights, const SkyLight& sky, const PathSettings& settings)
    : scene_(scene),
      materials_(materials),
      emitters_(emitters),
      lights_(lights),
      sky_(sky),
      settings_(settings),
      blended_(settings.transport == Transport::full ? Blended::met : Blended::by_chance) {
    if (settings.transport == Transport::full) {
        sees_through_ = std::ranges::any_of(scene.instances(), [&](const TraceInstance& instance) {
            return materials[instance.material].sees_through;
        });
        volumes_ = std::ranges::any_of(scene.instances(), [&](const TraceInstance& instance) {
            return materials[instance.material].volume;
        });
    }
    if (volumes_) {
        camera_medium_ = medium_at(scene.frame().camera.position);
    }
}

int Integrator::bounce_limit() const {
    return settings_.unlimited ? kMostReflections : settings_.bounces;
}

// Backs of single-sided surfaces end light: nobody is meant to see them. Those of glass do not.
bool Integrator::reflects(const SurfaceHit& hit) const {
    const MaterialConstants& material = materials_[scene_.instances()[hit.instance].material];
    const bool full = settings_.transport == Transport::full;
    return !material.unlit && (hit.front || material.double_sided ||
                               (sees_through_ && material.sees_through) || (full && material.transmits));
}

SurfaceMaterial Integrator::material_at(const SurfaceHit& hit) const {
    const SurfaceMaterial whole =
        materials_.evaluate(scene_.instances()[hit.instance], hit.primitive, hit.barycentric);
    return volumes_ && bounds_volume(hit) ? whole.opaque_part() : whole;
}

Bsdf Integrator::bsdf_at(const SurfaceHit& hit, const SurfaceMaterial& material, const vec3& towards) const {
    const TraceInstance& instance = scene_.instances()[hit.instance];
    const MaterialConstants& constants = materials_[instance.material];
    // The rasteriser shows nothing through its surfaces yet, nor does the transport that is compared with it.
    const bool straight =
        settings_.transport != Transport::full || (constants.sees_through && !constants.blend);
    return Bsdf(material, materials_.shading_normal(instance, hit), hit.normal, towards, straight);
}

vec3 Integrator::emission(const SurfaceHit& hit) const {
    const TraceInstance& instance = scene_.instances()[hit.instance];
    const MaterialConstants& material = materials_[instance.material];
    if (!material.emits || !(hit.front || material.double_sided)) {
        return vec3(0);
    }
    if (material.blend && blended_ == Blended::by_chance) {  // of its alpha: where it is met it shines whole
        return material_at(hit).emissive;
    }
    return materials_.emission(instance, hit.primitive, hit.barycentric);
}

std::optional<FirstSurface> Integrator::first_surface(const CameraRay& ray) const {
    SurfaceHit hit;
    if (!scene_.intersect(ray.origin, ray.direction, ray.nearest, ray.farthest, Blended::solid, hit,
                          Sides::seen)) {
        return std::nullopt;
    }
    return FirstSurface{hit, -ray.direction};
}

bool Integrator::meets(const Ray& ray, float nearest, SurfaceHit& hit) const {
    do {
        if (!scene_.intersect(ray.origin, ray.direction, nearest, kInfinity, blended_, hit)) {
            return false;
        }
        nearest = std::nextafter(hit.t, kInfinity);
    } while (is_left_out(hit));
    if (!hit.front && !materials_[scene_.instances()[hit.instance].material].double_sided) {
        scene_.prefer_front(ray.origin, ray.direction, blended_, hit);
    }
    return true;
}

vec3 Integrator::transmittance(const vec3& from, const vec3& span, bool to_infinity) const {
    if (!looks_through()) {
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
        if (is_left_out(hit)) {
            nearest = std::nextafter(hit.t, kInfinity);
            continue;
        }
        const MaterialConstants& material = materials_[scene_.instances()[hit.instance].material];
        if (!sees_through_ || !material.sees_through || (!settings_.caustics && !material.blend)) {
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

bool Integrator::next_surface(Flight& flight, const RandomNumbers& random, std::uint32_t dimension,
                              SurfaceHit& hit, float& distance) const {
    float nearest = 0;
    for (int layer = 0; layer < kMostLayers; ++layer) {
        const Ray& ray = flight.ray;
        if (!meets(ray, nearest, hit)) {
            return false;
        }
        distance = hit.t;
        if (volumes_) {
            if (bounds_volume(hit)) {
                if (!pass_boundary(flight, hit, random, dimension)) {
                    return true;
                }
                nearest = 0;
                continue;
            }
            if (!materials_[scene_.instances()[hit.instance].material].sees_through) {
                flight.throughput *= attenuation(flight.medium, hit.t);
                return true;
            }
        }
        if (!sees_through_ || !materials_[scene_.instances()[hit.instance].material].sees_through) {
            return true;
        }
        const vec3 straight = bsdf_at(hit, material_at(hit), -ray.direction).straight_through();
        const float chance = glm::clamp(largest(straight), 0.0f, 1.0f);
        const auto turn = std::min(static_cast<std::uint32_t>(layer), kStraightChoices - 1);
        const vec2 u = random.pair(dimension + kStraight + turn);
        if (u.x >= chance) {
            flight.throughput *= attenuation(flight.medium, hit.t);
            flight.throughput /= 1 - chance;
            return true;
        }
        flight.throughput *= straight / chance;
        flight.straight = flight.straight || !materials_[scene_.instances()[hit.instance].material].blend;
        nearest = std::nextafter(hit.t, kInfinity);
    }
    return false;
}

bool Integrator::makes_caustics(const Flight& flight, const SurfaceHit* hit) const {
    if (flight.bent || flight.straight || hit == nullptr) {
        return flight.bent || flight.straight;
    }
    const SurfaceMaterial material =
        materials_.evaluate(scene_.instances()[hit->instance], hit->primitive, hit->barycentric);
    return material.transmission * (1 - material.metallic) > 0 ||
           (material.metallic > 0.5f && material.roughness < kRoughestSpecular);
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
                             std::uint32_t dimension, std::uint32_t medium) const {
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
            const float metres = sample.infinite ? kInfinity : glm::length(span);
            sum += reflected * transmittance(from, span, sample.infinite) * attenuation(medium, metres);
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
                sum += scattered * weight * transmittance(from, shadow, false) *
                       attenuation(medium, glm::length(shadow));
            }
        }
    }
    // Diffuse transport counts the sky with the indirect light.
    if (!sky_.empty() && settings_.transport == Transport::full) {
        const SkyLight::Sample sample = sky_.draw(random.pair(dimension + kSky));
        const vec3 scattered = scattering.evaluate(sample.direction) * sample.radiance;
        if (!is_black(scattered)) {
            const float weight = power_heuristic(sample.density, scattering.density(sample.direction));
            sum += scattered * (weight / sample.density) *
                   transmittance(start(sample.direction), sample.direction, true) *
                   attenuation(medium, kInfinity);
        }
    }
    return sum;
}

Integrator::Shaded Integrator::shade(const SurfaceHit& hit, const vec3& towards,
                                     const SurfaceMaterial& material, std::uint32_t medium,
                                     const RandomNumbers& random) const {
    const std::uint32_t dimension =
        vertex_dimension(kRadiancePath, 0) + kVertexDimensions * (kMostReflections + 1);
    const Bsdf bsdf = bsdf_at(hit, material, towards);
    Shaded result;
    result.drawn = draw_lights(hit, bsdf, random, dimension, medium);
    const vec3 direction = bsdf.sample(random.pair(dimension + kLobe).x, random.pair(dimension + kDirection));
    result.density = bsdf.density(direction);
    if (result.density > 0) {
        result.weight = bsdf.evaluate(direction) / result.density;
        const vec3 side = glm::dot(hit.normal, direction) < 0 ? -hit.normal : hit.normal;
        result.ray = {off_surface(hit, side, scene_.triangles()[hit.triangle]), direction};
    }
    return result;
}

vec3 Integrator::direct(const SurfaceHit& hit, const vec3& towards, const SurfaceMaterial& material,
                        const RandomNumbers& random) const {
    const Shaded shaded = shade(hit, towards, material, kAir, random);
    SurfaceHit lamp;
    float distance = 0;
    Flight flight{shaded.ray};
    const bool full = settings_.transport == Transport::full;
    if ((emitters_.empty() && (sky_.empty() || !full)) || is_black(shaded.weight)) {
        return shaded.drawn;
    }
    const bool met = next_surface(flight, random, vertex_dimension(kRadiancePath, 0), lamp, distance);
    if (flight.bent) {
        return shaded.drawn;  // what volumes send here is indirect light
    }
    if (!met) {
        const vec3& direction = shaded.ray.direction;
        return full ? shaded.drawn + shaded.weight * flight.throughput * sky_.radiance(direction) *
                                         power_heuristic(shaded.density, sky_.density(direction))
                    : shaded.drawn;
    }
    const float other = emitters_.density(lamp, distance, -glm::dot(lamp.normal, shaded.ray.direction));
    return shaded.drawn +
           shaded.weight * flight.throughput * emission(lamp) * power_heuristic(shaded.density, other);
}

// Blended surfaces in front show themselves with the chance of their alpha.
Integrator::Shown Integrator::shown(const CameraRay& ray, const RandomNumbers& random) const {
    const bool full = settings_.transport == Transport::full;
    Shown result;
    Flight& flight = result.flight;
    flight.ray = {ray.origin, ray.direction};
    flight.medium = camera_medium_;
    if (camera_medium_ != kAir) {
        // What is shown is radiance over n^2, which is the same on both sides of a boundary.
        const float n = materials_[camera_medium_].ior;
        flight.throughput /= n * n;
    }
    float nearest = ray.nearest, farthest = ray.farthest;
    for (int layer = 0; layer < kMostLayers; ++layer) {
        SurfaceHit& hit = result.hit;
        if (!scene_.intersect(flight.ray.origin, flight.ray.direction, nearest, farthest, Blended::met, hit,
                              full ? Sides::both : Sides::seen)) {
            result.missed = true;
            return result;
        }
        if (volumes_ && bounds_volume(hit)) {
            if (!pass_boundary(flight, hit, random, kCameraDimension)) {
                result.layer = true;
                return result;
            }
            nearest = 0;
            farthest = kInfinity;
            continue;
        }
        nearest = std::nextafter(hit.t, kInfinity);
        const MaterialConstants& constants = materials_[scene_.instances()[hit.instance].material];
        const bool glass = full && constants.sees_through && !constants.blend;
        if (!hit.front && !constants.double_sided && !glass) {
            continue;
        }
        if (!constants.blend && !glass) {
            flight.throughput *= attenuation(flight.medium, hit.t);
            return result;
        }
        const SurfaceMaterial material = material_at(hit);
        if (!full && material.alpha >= kSolidAlpha) {
            return result;  // the first surface
        }
        const vec3 straight = full ? bsdf_at(hit, material, -flight.ray.direction).straight_through()
                                   : vec3(1 - material.alpha);
        const float chance = glm::clamp(largest(straight), 0.0f, 1.0f);
        const auto turn = std::min(static_cast<std::uint32_t>(layer), kVertexDimensions - 1);
        if (random.pair(kCameraDimension + turn).x < chance) {
            flight.throughput *= straight / chance;
            continue;
        }
        flight.throughput *= attenuation(flight.medium, hit.t);
        flight.throughput /= 1 - chance;
        result.layer = true;
        return result;
    }
    return result;
}

// Of diffuse transport: from its other two parts.
vec3 Integrator::composed_radiance(const SampleStart& start, const PathSample& so_far) const {
    const auto& [ray, first, random] = start;
    if (scene_.has_blended()) {
        const Shown seen = shown(ray, random);
        if (seen.missed) {
            return seen.flight.throughput * sky_.shown(ray.direction);
        }
        if (seen.layer) {
            const SurfaceMaterial material = material_at(seen.hit);
            if (materials_[scene_.instances()[seen.hit.instance].material].unlit) {
                return seen.flight.throughput * material.base_colour * material.alpha;
            }
            return seen.flight.throughput *
                   (direct(seen.hit, -ray.direction, material, random) + material.emissive * material.alpha);
        }
    }
    if (first == nullptr) {
        return sky_.shown(ray.direction);
    }
    const SurfaceMaterial material = material_at(first->hit);
    const TraceInstance& instance = scene_.instances()[first->hit.instance];
    if (materials_[instance.material].unlit) {
        return material.base_colour;
    }
    return so_far.direct + material.emissive +
           so_far.indirect * materials_.reflectance(instance, first->hit.primitive, first->hit.barycentric) *
               (material.occlusion / kPi);
}

void Integrator::add_full_radiance(std::span<const SampleStart> starts, std::span<PathSample> results) const {
    PathLanes paths{};
    std::array<Incoming, kLanes> in{};
    std::array<vec3, kLanes> weights{};
    std::array<float, kLanes> densities{};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const auto& [ray, first, random] = starts[i];
        Shown seen;
        seen.flight.ray.direction = ray.direction;
        vec3 towards = -ray.direction;
        if (scene_.has_blended() || sees_through_ || volumes_) {
            seen = shown(ray, random);
            towards = -seen.flight.ray.direction;
        } else if (first != nullptr) {
            seen.hit = first->hit;
            towards = first->towards;
        } else {
            seen.missed = true;
        }
        if (seen.missed) {
            results[i].radiance = seen.flight.throughput * sky_.shown(seen.flight.ray.direction);
            continue;
        }
        const SurfaceMaterial material = material_at(seen.hit);
        if (materials_[scene_.instances()[seen.hit.instance].material].unlit) {
            results[i].radiance = seen.flight.throughput * material.base_colour * material.alpha;
            continue;
        }
        const Shaded shaded = shade(seen.hit, towards, material, seen.flight.medium, random);
        results[i].radiance = seen.flight.throughput * (shaded.drawn + material.emissive * material.alpha);
        if (is_black(shaded.weight)) {
            continue;
        }
        weights[i] = seen.flight.throughput * shaded.weight;
        densities[i] = shaded.density;
        const int lane = paths.add(random, static_cast<int>(i));
        paths.start.set(lane, shaded.ray.origin);
        paths.direction.set(lane, shaded.ray.direction);
        paths.density[lane] = shaded.density;
        paths.medium[lane] = seen.flight.medium;
    }
    incoming(paths, kRadiancePath, in);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        results[i].radiance +=
            weights[i] * (in[i].emitted * power_heuristic(densities[i], in[i].light_density) +
                          in[i].reflected + in[i].sky);
    }
}

void Integrator::add_indirect(std::span<const SampleStart> starts, std::span<PathSample> results) const {
    std::array<IrradianceStart, kLanes> points;
    std::array<std::size_t, kLanes> whose;
    std::size_t count = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (starts[i].first == nullptr) {
            continue;
        }
        const SurfaceHit& hit = starts[i].first->hit;
        points[count] = {hit.position, hit.normal, scene_.triangles()[hit.triangle].offset, starts[i].random};
        whose[count++] = i;
    }
    std::array<vec3, kLanes> light;
    irradiance(std::span(points).first(count), std::span(light).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        results[whose[i]].indirect = light[i];
    }
}

void Integrator::sample(std::span<const SampleStart> starts, const SampleParts& parts,
                        std::span<PathSample> results) const {
    const bool full = settings_.transport == Transport::full;
    const bool composed = parts.radiance && !full;  // radiance from the other two
    std::ranges::fill(results.first(starts.size()), PathSample{});
    for (std::size_t begin = 0; begin < starts.size(); begin += kLanes) {
        const std::size_t count = std::min(starts.size() - begin, std::size_t{kLanes});
        if (parts.indirect || composed) {
            add_indirect(starts.subspan(begin, count), results.subspan(begin, count));
        }
        if (parts.radiance && full) {
            add_full_radiance(starts.subspan(begin, count), results.subspan(begin, count));
        }
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const FirstSurface* first = starts[i].first;
        if ((parts.direct || composed) && first != nullptr &&
            !materials_[scene_.instances()[first->hit.instance].material].unlit) {
            results[i].direct = direct(first->hit, first->towards, material_at(first->hit), starts[i].random);
        }
        if (composed) {
            results[i].radiance = composed_radiance(starts[i], results[i]);
        }
    }
}

}  // namespace lanthorn::reference
