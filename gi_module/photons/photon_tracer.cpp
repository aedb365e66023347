#include "lanthorn/photons/photon_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lanthorn/reference/dielectric.h"
#include "lanthorn/reference/path_lanes.h"
#include "lanthorn/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kLanes = 64;        // walks that go side by side
constexpr std::uint64_t kRun = 1024;      // walks that a thread takes at once
constexpr int kMostRays = 1000;           // of a walk: between mirrors, through glass
constexpr std::uint32_t kRayDimensions = 4;
enum Dimension : std::uint32_t { kLobe, kDirection, kBoundary, kFacet };

// KHR_lights_punctual's, at a share of a light's range.
float window(float s) {
    return glm::clamp(1 - s * s * s * s, 0.0f, 1.0f);
}

// What mirrors light or lets it through, at this point of it.
bool is_specular(const SurfaceMaterial& m) {
    return m.transmission * (1 - m.metallic) > 0 || (m.metallic > 0.5f && m.roughness < kRoughestMirror);
}

}  // namespace

struct PhotonTracer::Flight {
    vec3 origin, direction;
    vec3 flux;
    reference::RandomNumbers random;
    std::uint32_t dimension = 0;
    std::uint32_t medium = reference::kAir;
    std::uint32_t path = 0;
    float range = 1e30f;
    float way = 0;        // metres, until the first surface that light is scattered by
    float nearest = 0;    // where the ray begins, beyond a surface that it goes straight through
    int rays = 0;
    std::uint16_t group = 0;
    std::uint8_t bounces = 0;
    bool bent = false, straight = false, sky = false;
    bool specular_only = true;  // so far

    std::uint32_t next() {
        const std::uint32_t d = dimension;
        dimension += kRayDimensions;
        return d;
    }
};

PhotonTracer::PhotonTracer(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                           const PhotonSources& sources, const PhotonSettings& settings)
    : scene_(scene),
      materials_(materials),
      sources_(sources),
      settings_(settings),
      blended_(settings.scattering == PhotonScattering::full ? reference::Blended::met
                                                             : reference::Blended::ignored) {}

void PhotonTracer::begin(std::uint64_t number, Flight& flight) const {
    const PhotonSources::Place place = sources_.place(number);
    flight = {};
    flight.random = reference::RandomNumbers(settings_.seed, static_cast<std::uint32_t>(place.group),
                                             static_cast<std::uint32_t>(place.index));
    const PhotonStart start = sources_.start(place.group, flight.random);
    flight.origin = start.origin;
    flight.direction = start.direction;
    flight.flux = start.flux;
    flight.range = start.range;
    flight.group = static_cast<std::uint16_t>(place.group);
    flight.sky = sources_.groups()[place.group].sky;
    flight.path = static_cast<std::uint32_t>(number);
    flight.dimension = PhotonSources::kStartDimensions;
}

vec3 PhotonTracer::attenuation(std::uint32_t material, float metres) const {
    if (material == reference::kAir) {
        return vec3(1);
    }
    const vec3& a = materials_[material].absorption;
    return {a.x > 0 ? std::exp(-a.x * metres) : 1.0f, a.y > 0 ? std::exp(-a.y * metres) : 1.0f,
            a.z > 0 ? std::exp(-a.z * metres) : 1.0f};
}

// Goes on with what is left, by a chance that leaves the strongest channel's flux as it was.
bool PhotonTracer::survives(Flight& flight, const vec3& share, float choice) const {
    const float before = reference::largest(flight.flux);
    const vec3 left = flight.flux * share;
    const float chance = std::min(reference::largest(left) / before, 1.0f);
    if (!(choice < chance)) {
        return false;
    }
    flight.flux = left / chance;
    return true;
}

void PhotonTracer::store(const Flight& flight, const SurfaceHit& hit, bool diffuse, PhotonRun& run) const {
    if (!std::isfinite(flight.flux.x + flight.flux.y + flight.flux.z)) {
        ++run.bad;
        return;
    }
    Photon p;
    p.position = hit.position;
    p.instance = hit.instance;
    p.direction = flight.direction;
    p.primitive = hit.primitive;
    p.flux = flight.flux;
    p.group = flight.group;
    p.bounces = flight.bounces;
    p.front = hit.front;
    p.bent = flight.bent;
    p.straight = flight.straight;
    p.sky = flight.sky;
    p.caustic = flight.specular_only && (flight.bounces > 0 || flight.bent || flight.straight);
    p.diffuse = diffuse;
    p.normal = hit.normal;
    p.path = flight.path;
    run.photons.push_back(p);
}

// On through the boundary of a volume, or reflected by it. `opaque`: it has met the part of the surface that
// lets no light through. Light's own power takes no change by n^2.
bool PhotonTracer::pass_boundary(Flight& flight, const SurfaceHit& hit, const SurfaceMaterial& material,
                                 bool& opaque) const {
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const std::uint32_t dimension = flight.next();
    const vec2 choice = flight.random.pair(dimension + kBoundary);
    const float hole = 1 - material.alpha;
    const float glass = material.alpha * material.transmission * (1 - material.metallic);
    opaque = choice.x >= hole + glass;
    if (opaque) {
        return true;
    }
    flight.bent = true;
    const reference::TraceTriangle& triangle = scene_.triangles()[hit.triangle];
    if (choice.x < hole) {
        flight.origin = off_surface(hit, -hit.normal, triangle);
        return true;
    }
    const float ior = materials_[instance.material].ior;
    const reference::BoundarySample sample = reference::sample_boundary(
        -flight.direction, materials_.shading_normal(instance, hit), hit.normal, hit.front ? ior : 1 / ior,
        material.roughness, choice.y, flight.random.pair(dimension + kFacet));
    vec3 share(sample.weight);
    if (sample.through) {
        share *= material.base_colour;
        flight.medium = hit.front ? instance.material : reference::kAir;
    }
    if (!survives(flight, share, flight.random.pair(dimension + kLobe).y)) {
        return false;
    }
    flight.origin = off_surface(hit, sample.through ? -hit.normal : hit.normal, triangle);
    flight.direction = sample.direction;
    return true;
}

bool PhotonTracer::scatter(Flight& flight, const SurfaceHit& hit, const SurfaceMaterial& material,
                           bool specular) const {
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const std::uint32_t dimension = flight.next();
    const vec2 chances = flight.random.pair(dimension + kLobe);
    const vec2 u = flight.random.pair(dimension + kDirection);
    vec3 direction;
    if (settings_.scattering == PhotonScattering::even && !specular) {
        if (!survives(flight, materials_.reflectance(instance, hit.primitive, hit.barycentric), chances.y)) {
            return false;
        }
        direction = reference::cosine_direction(hit.normal, u);
    } else {
        const vec3 v = -flight.direction;
        const vec3 n = materials_.shading_normal(instance, hit);
        const reference::Bsdf bsdf(material, n, hit.normal, v, true);
        direction = bsdf.sample(chances.x, u);
        const float density = bsdf.density(direction);
        if (!(density > 0)) {
            return false;
        }
        // Light that goes the other way meets the interpolated normal's cosine at its other end (Veach 1997,
        // eq. 5.19).
        const float straight = std::abs(glm::dot(v, hit.normal) * glm::dot(direction, n));
        const float turned = std::abs(glm::dot(v, n) * glm::dot(direction, hit.normal));
        if (!(straight > 0) ||
            !survives(flight, bsdf.evaluate(direction) * (turned / (straight * density)), chances.y)) {
            return false;
        }
    }
    const float side = glm::dot(direction, hit.normal) < 0 ? -1.0f : 1.0f;
    if (!(side > 0)) {
        flight.straight = true;
    }
    flight.origin = off_surface(hit, side * hit.normal, scene_.triangles()[hit.triangle]);
    flight.direction = direction;
    flight.bounces += side > 0 ? 1 : 0;
    flight.specular_only = flight.specular_only && specular;
    return true;
}

bool PhotonTracer::arrive(Flight& flight, SurfaceHit& hit, PhotonRun& run) const {
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const reference::MaterialConstants& constants = materials_[instance.material];
    if (!hit.front && !constants.double_sided) {
        scene_.prefer_front(flight.origin, flight.direction, blended_, hit);
        if (hit.front) {
            return arrive(flight, hit, run);
        }
    }
    SurfaceMaterial material = materials_.evaluate(instance, hit.primitive, hit.barycentric);
    const float here = hit.t - flight.nearest;
    flight.nearest = 0;
    flight.flux *= attenuation(constants.volume && !hit.front ? instance.material : flight.medium, here);
    if (flight.range < 1e30f && flight.bounces == 0) {  // the lamp's window, once it is scattered
        flight.way += here;
    }
    const bool lit = hit.front || constants.double_sided;
    const bool sees_through = constants.sees_through || (constants.volume && material.transmission > 0);
    if (constants.unlit || !(lit || sees_through) || reference::is_black(flight.flux)) {
        return false;
    }
    if (constants.blend || constants.sees_through) {
        // Straight on, by chance.
        const vec3 v = -flight.direction;
        const reference::Bsdf bsdf(material, materials_.shading_normal(instance, hit), hit.normal, v, true);
        const vec3 through = bsdf.straight_through();
        const float chance = glm::clamp(reference::largest(through), 0.0f, 1.0f);
        const float choice = flight.random.pair(flight.next() + kBoundary).x;
        if (choice < chance) {
            flight.straight = flight.straight || !constants.blend;
            flight.flux *= through / chance;
            flight.nearest = std::nextafter(hit.t, kInfinity);
            return !reference::is_black(flight.flux);
        }
        flight.flux /= 1 - chance;
    }
    if (flight.range < 1e30f && flight.bounces == 0) {
        flight.flux *= window(flight.way / flight.range);
        flight.range = 1e30f;
        if (reference::is_black(flight.flux)) {
            return false;
        }
    }
    const bool specular = is_specular(material);
    if (lit) {
        store(flight, hit, (1 - material.metallic) * (1 - material.transmission) > 0, run);
    }
    if (constants.volume) {
        bool opaque = false;
        if (!pass_boundary(flight, hit, material, opaque)) {
            return false;
        }
        if (!opaque) {
            return true;
        }
        material = material.opaque_part();
    }
    return lit && flight.bounces < settings_.bounces && scatter(flight, hit, material, specular);
}

PhotonRun PhotonTracer::trace(std::uint64_t first, std::uint64_t count,
                              reference::TileWorkers& workers) const {
    PhotonRun all;
    if (sources_.empty() || count == 0) {
        return all;
    }
    std::vector<PhotonRun> runs(static_cast<std::size_t>((count + kRun - 1) / kRun));
    workers.run(runs.size(), [&](std::size_t r) {
        PhotonRun& run = runs[r];
        const std::uint64_t begin_at = first + r * kRun;
        const std::uint64_t end_at = std::min(begin_at + kRun, first + count);
        run.photons.reserve(static_cast<std::size_t>(end_at - begin_at) * 3);
        std::array<Flight, kLanes> flights;
        std::array<RTCRayHit, kLanes> queries;
        std::array<PhotonRun, kLanes> found;  // by walk of the batch
        for (std::uint64_t number = begin_at; number < end_at;) {
            std::array<std::size_t, kLanes> lanes{};
            std::size_t alive = 0;
            for (; alive < kLanes && number < end_at; ++number, ++alive) {
                begin(number, flights[alive]);
                found[alive].photons.clear();
                found[alive].bad = 0;
                lanes[alive] = alive;
            }
            const std::size_t batch = alive;
            while (alive > 0) {
                for (std::size_t i = 0; i < alive; ++i) {
                    const Flight& f = flights[lanes[i]];
                    queries[i] =
                        reference::TraceScene::query(f.origin, f.direction, f.nearest, kInfinity, blended_);
                }
                scene_.intersect_all(std::span(queries).first(alive));
                run.rays += alive;
                std::size_t kept = 0;
                for (std::size_t i = 0; i < alive; ++i) {
                    Flight& f = flights[lanes[i]];
                    SurfaceHit hit;
                    if (!reference::is_black(f.flux) && scene_.found(queries[i], hit) &&
                        ++f.rays < kMostRays && arrive(f, hit, found[lanes[i]])) {
                        lanes[kept++] = lanes[i];
                    }
                }
                alive = kept;
            }
            for (std::size_t i = 0; i < batch; ++i) {
                run.photons.insert(run.photons.end(), found[i].photons.begin(), found[i].photons.end());
                run.bad += found[i].bad;
            }
        }
    });
    std::size_t photons = 0;
    for (const PhotonRun& run : runs) {
        photons += run.photons.size();
    }
    all.photons.reserve(photons);
    for (const PhotonRun& run : runs) {
        all.photons.insert(all.photons.end(), run.photons.begin(), run.photons.end());
        all.rays += run.rays;
        all.bad += run.bad;
    }
    return all;
}

}  // namespace lanthorn::gi
