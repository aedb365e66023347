#include "gi_module/shared/photons/photon_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gi_module/reference/dielectric.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/path_lanes.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
using reference::kLanes;
using reference::Lanes;

constexpr std::uint32_t kMostRays = 1000;  // of a walk: between mirrors, through glass
// The random numbers of the surface that a walk's n-th ray meets. leave_surfaces() draws kDirection itself,
// and of kLobe the first.
constexpr std::uint32_t kRayDimensions = 8;
enum Dimension : std::uint32_t {
    kDirection = reference::kDirection,
    kBoundary,
    kFacet,
    kLobe = reference::kLobe,
    kStraight
};
static_assert(kFacet < kLobe && kStraight < kRayDimensions);

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
    std::uint32_t dimension = 0;  // of the surface that its ray meets
    std::uint32_t medium = reference::kAir;
    std::uint32_t path = 0;
    float range = 1e30f;
    float way = 0;      // metres, until the first surface that light is scattered by
    float nearest = 0;  // where the ray begins, beyond a surface that it goes straight through
    std::uint16_t group = 0;
    std::uint8_t bounces = 0;
    bool bent = false, straight = false, sky = false;
    bool specular_only = true;  // so far
};

// Copied from here: a temporary of narrow fields is slow to copy.
const PhotonTracer::Flight PhotonTracer::kNew{};

// Walks side by side: what is arithmetic alone is done for all of them at once (path_lanes.h). All have met
// as many surfaces.
struct PhotonTracer::Batch {
    reference::PathLanes lanes{};
    reference::MaterialLanes materials{};
    Lanes<float> lobe, survival;         // random numbers at the surface that each meets
    std::array<Flight, kLanes> flights;  // by lanes.sample
    std::array<RTCRayHit, kLanes> queries;
    std::uint32_t rays = 0;            // of each so far
    std::vector<Photon> photons;       // as they were found
    std::vector<std::uint8_t> whose;   // flights
    std::vector<std::uint32_t> order;  // walk by walk
};

PhotonTracer::PhotonTracer(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                           const PhotonSources& sources, const PhotonSettings& settings)
    : scene_(scene),
      materials_(materials),
      sources_(sources),
      settings_(settings),
      blended_(settings.scattering == PhotonScattering::full ? reference::Blended::met
                                                             : reference::Blended::by_chance) {}

void PhotonTracer::begin(std::uint64_t first, int count, Batch& batch) const {
    reference::PathLanes& lanes = batch.lanes;
    lanes.count = 0;
    batch.rays = 0;
    batch.photons.clear();
    batch.whose.clear();
    for (int i = 0; i < count; ++i) {
        Flight& flight = batch.flights[static_cast<std::size_t>(i)];
        const std::uint64_t number = first + static_cast<std::uint64_t>(i);
        const PhotonSources::Place place = sources_.place(number);
        flight = kNew;
        flight.random = reference::RandomNumbers(settings_.seed, static_cast<std::uint32_t>(place.group),
                                                 static_cast<std::uint32_t>(place.index));
        flight.group = static_cast<std::uint16_t>(place.group);
        flight.sky = sources_.groups()[place.group].sky;
        flight.path = static_cast<std::uint32_t>(number);
        lanes.add(flight.random, i);
    }
    std::array<Lanes<float>, PhotonSources::kStartPairs> x, y;
    for (std::uint32_t d = 0; d < PhotonSources::kStartPairs; ++d) {
        draw_pairs(lanes, d, x[d], y[d]);
    }
    for (int i = 0; i < count; ++i) {
        Flight& flight = batch.flights[static_cast<std::size_t>(i)];
        PhotonSources::Pairs pairs;
        for (std::uint32_t d = 0; d < PhotonSources::kStartPairs; ++d) {
            pairs[d] = {x[d][i], y[d][i]};
        }
        const PhotonStart start = sources_.start(flight.group, pairs);
        flight.flux = start.flux;
        flight.range = start.range;
        lanes.position.set(i, start.origin);
        lanes.normal.set(i, start.normal);
        lanes.offset[i] = start.offset;
        flight.direction = start.direction;
    }
    leave_surfaces(lanes, PhotonSources::kDirectionPair - kDirection);
    for (int i = 0; i < count; ++i) {
        if (lanes.normal.at(i) == vec3(0)) {
            lanes.start.set(i, lanes.position.at(i));
            lanes.direction.set(i, batch.flights[static_cast<std::size_t>(i)].direction);
        }
    }
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

void PhotonTracer::store(Batch& batch, int lane, const SurfaceHit& hit, bool diffuse, PhotonRun& run) const {
    const auto whose = static_cast<std::size_t>(batch.lanes.sample[lane]);
    const Flight& flight = batch.flights[whose];
    if (!std::isfinite(flight.flux.x + flight.flux.y + flight.flux.z)) {
        ++run.bad;
        return;
    }
    batch.whose.push_back(static_cast<std::uint8_t>(whose));
    Photon& p = batch.photons.emplace_back();
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
}

// On through the boundary of a volume, or reflected by it. `opaque`: it has met the part of the surface that
// lets no light through. Light's own power takes no change by n^2.
PhotonTracer::Next PhotonTracer::pass_boundary(Flight& flight, const SurfaceHit& hit,
                                               const SurfaceMaterial& material, float survival,
                                               bool& opaque) const {
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const vec2 choice = flight.random.pair(flight.dimension + kBoundary);
    const float hole = 1 - material.alpha;
    const float glass = material.alpha * material.transmission * (1 - material.metallic);
    opaque = choice.x >= hole + glass;
    if (opaque) {
        return Next::goes_on;
    }
    flight.bent = true;
    const reference::TraceTriangle& triangle = scene_.triangles()[hit.triangle];
    if (choice.x < hole) {
        flight.origin = off_surface(hit, -hit.normal, triangle);
        return Next::goes_on;
    }
    const float ior = materials_[instance.material].ior;
    const reference::BoundarySample sample = reference::sample_boundary(
        -flight.direction, materials_.shading_normal(instance, hit), hit.normal, hit.front ? ior : 1 / ior,
        material.roughness, choice.y, flight.random.pair(flight.dimension + kFacet));
    vec3 share(sample.weight);
    if (sample.through) {
        share *= material.base_colour;
        flight.medium = hit.front ? instance.material : reference::kAir;
    }
    if (!survives(flight, share, survival)) {
        return Next::ends;
    }
    flight.origin = off_surface(hit, sample.through ? -hit.normal : hit.normal, triangle);
    flight.direction = sample.direction;
    return Next::goes_on;
}

// Off the surface by the material's own BSDF, to where leave_surfaces() has drawn.
PhotonTracer::Next PhotonTracer::turn(Batch& batch, int lane) const {
    reference::PathLanes& lanes = batch.lanes;
    Flight& flight = batch.flights[static_cast<std::size_t>(lanes.sample[lane])];
    const vec3 v = batch.materials.towards.at(lane), n = batch.materials.shading.at(lane);
    const vec3 l = lanes.direction.at(lane), geometric = lanes.normal.at(lane);
    if (!(lanes.density[lane] > 0)) {
        return Next::ends;
    }
    // Light that goes the other way meets the interpolated normal's cosine at its other end (Veach 1997,
    // eq. 5.19).
    const float straight = std::abs(glm::dot(v, geometric) * glm::dot(l, n));
    const float turned = std::abs(glm::dot(v, n) * glm::dot(l, geometric));
    if (!(straight > 0) ||
        !survives(flight, lanes.throughput.at(lane) * (turned / straight), batch.survival[lane])) {
        return Next::ends;
    }
    const bool reflected = glm::dot(l, geometric) > 0;
    flight.straight = flight.straight || !reflected;
    flight.bounces += reflected ? 1 : 0;
    flight.origin = lanes.start.at(lane);
    flight.direction = l;
    return Next::goes_on;
}

PhotonTracer::Next PhotonTracer::arrive(Batch& batch, int lane, int kept, SurfaceHit& hit,
                                        PhotonRun& run) const {
    Flight& flight = batch.flights[static_cast<std::size_t>(batch.lanes.sample[lane])];
    if (!hit.front && !materials_[scene_.instances()[hit.instance].material].double_sided) {
        scene_.prefer_front(flight.origin, flight.direction, blended_, hit);
    }
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const reference::MaterialConstants& constants = materials_[instance.material];
    SurfaceMaterial own;
    const SurfaceMaterial* material = &constants.surface;
    if (!constants.untextured || instance.coloured) {
        own = materials_.evaluate(instance, hit.primitive, hit.barycentric);
        material = &own;
    }
    const bool full = settings_.scattering == PhotonScattering::full;
    if (constants.blend && !full) {  // met by chance of its alpha
        own = *material;
        own.alpha = 1;
        material = &own;
    }
    const float here = hit.t - flight.nearest;
    flight.nearest = 0;
    if (constants.volume || flight.medium != reference::kAir) {
        flight.flux *= attenuation(constants.volume && !hit.front ? instance.material : flight.medium, here);
    }
    flight.way += here;
    const bool lit = hit.front || constants.double_sided;
    const bool sees_through = constants.sees_through || (constants.volume && material->transmission > 0);
    // Backs end light, those of glass and of rough thin walls apart.
    const bool scatters = lit || (full && constants.transmits);
    // What rough thin walls transmit is scattered too, as Integrator::bsdf_at() has it.
    const bool straight = !full || (constants.sees_through && !constants.blend);
    if (constants.unlit || !(scatters || sees_through) || reference::is_black(flight.flux)) {
        return Next::ends;
    }
    if (constants.sees_through) {
        // Straight on, by chance.
        const reference::Bsdf bsdf(*material, materials_.shading_normal(instance, hit), hit.normal,
                                   -flight.direction, straight);
        const vec3 through = bsdf.straight_through();
        const float chance = glm::clamp(reference::largest(through), 0.0f, 1.0f);
        if (flight.random.pair(flight.dimension + kStraight).x < chance) {
            flight.straight = flight.straight || !constants.blend;
            flight.flux *= through / chance;
            flight.nearest = std::nextafter(hit.t, kInfinity);
            return reference::is_black(flight.flux) ? Next::ends : Next::goes_on;
        }
        flight.flux /= 1 - chance;
    }
    if (flight.range < 1e30f) {  // the lamp's window, where its light is first scattered
        flight.flux *= window(flight.way / flight.range);
        flight.range = 1e30f;
        if (reference::is_black(flight.flux)) {
            return Next::ends;
        }
    }
    if (lit) {
        store(batch, lane, hit, (1 - material->metallic) * (1 - material->transmission) > 0, run);
    }
    const bool specular = is_specular(*material);
    if (constants.volume) {
        bool opaque = false;
        const Next next = pass_boundary(flight, hit, *material, batch.survival[lane], opaque);
        if (!opaque) {
            return next;
        }
        own = material->opaque_part();
        material = &own;
    }
    if (!scatters || flight.bounces >= settings_.bounces) {
        return Next::ends;
    }
    batch.lanes.position.set(kept, hit.position);
    batch.lanes.normal.set(kept, hit.normal);
    batch.lanes.offset[kept] = scene_.triangles()[hit.triangle].offset;
    if (settings_.scattering == PhotonScattering::even && !specular) {
        flight.specular_only = false;
        ++flight.bounces;
        const vec3 share = materials_.reflectance(instance, hit.primitive, hit.barycentric);
        return survives(flight, share, batch.survival[lane]) ? Next::leaves_diffusely : Next::ends;
    }
    flight.specular_only = flight.specular_only && specular && is_specular(*material);
    batch.materials.set(kept, *material, materials_.shading_normal(instance, hit), -flight.direction,
                        straight);
    batch.survival[kept] = batch.survival[lane];
    return Next::leaves_by_material;
}

// Every walk to the next surface on its ray, and off it.
void PhotonTracer::step(Batch& batch, PhotonRun& run) const {
    reference::PathLanes& lanes = batch.lanes;
    const auto count = static_cast<std::size_t>(lanes.count);
    const std::uint32_t dimension = PhotonSources::kStartPairs + kRayDimensions * batch.rays;
    for (int lane = 0; lane < lanes.count; ++lane) {
        Flight& flight = batch.flights[static_cast<std::size_t>(lanes.sample[lane])];
        flight.dimension = dimension;
        const vec3 origin = lanes.start.at(lane), direction = lanes.direction.at(lane);
        flight.origin = origin;
        flight.direction = direction;
        batch.queries[static_cast<std::size_t>(lane)] =
            reference::TraceScene::query(origin, direction, flight.nearest, kInfinity, blended_);
    }
    scene_.intersect_all(std::span(batch.queries).first(count));
    run.rays += count;
    draw_pairs(lanes, dimension + kLobe, batch.lobe, batch.survival);
    std::array<Next, kLanes> nexts;
    int kept = 0;
    bool diffuse = false, by_material = false;
    for (int lane = 0; lane < lanes.count; ++lane) {
        SurfaceHit hit;
        if (!scene_.found(batch.queries[static_cast<std::size_t>(lane)], hit)) {
            continue;
        }
        const Next next = arrive(batch, lane, kept, hit, run);
        if (next != Next::ends) {
            lanes.keep(lane, kept);
            nexts[static_cast<std::size_t>(kept++)] = next;
            diffuse = diffuse || next == Next::leaves_diffusely;
            by_material = by_material || next == Next::leaves_by_material;
        }
    }
    lanes.count = ++batch.rays < kMostRays ? kept : 0;
    if (by_material) {
        leave_surfaces(lanes, batch.materials, dimension);
        for (int lane = 0; lane < lanes.count; ++lane) {
            Next& next = nexts[static_cast<std::size_t>(lane)];
            next = next == Next::leaves_by_material ? turn(batch, lane) : next;
            lanes.throughput.set(lane, vec3(1));
        }
    }
    if (diffuse) {
        leave_surfaces(lanes, dimension);
    }
    kept = 0;
    for (int lane = 0; lane < lanes.count; ++lane) {
        const Next next = nexts[static_cast<std::size_t>(lane)];
        if (next == Next::ends) {
            continue;
        }
        lanes.keep(lane, kept);
        const Flight& flight = batch.flights[static_cast<std::size_t>(lanes.sample[lane])];
        const bool drawn = next == Next::leaves_diffusely;
        lanes.start.set(kept, drawn ? lanes.start.at(lane) : flight.origin);
        lanes.direction.set(kept++, drawn ? lanes.direction.at(lane) : flight.direction);
    }
    lanes.count = kept;
}

// Adds them walk by walk.
void PhotonTracer::finish(Batch& batch, std::vector<Photon>& photons) const {
    std::array<std::uint32_t, kLanes + 1> places{};
    for (const std::uint8_t whose : batch.whose) {
        ++places[whose + 1u];
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        places[i + 1] += places[i];
    }
    batch.order.resize(batch.photons.size());
    for (std::uint32_t i = 0; i < batch.order.size(); ++i) {
        batch.order[places[batch.whose[i]]++] = i;
    }
    for (const std::uint32_t i : batch.order) {
        photons.push_back(batch.photons[i]);
    }
}

PhotonRun PhotonTracer::trace(std::uint64_t first, std::uint64_t count, reference::TileWorkers& workers,
                              const Take& take) const {
    PhotonRun all;
    if (sources_.empty() || count == 0) {
        return all;
    }
    struct Counts {
        std::uint64_t rays = 0, bad = 0;
    };
    std::vector<Counts> counts(static_cast<std::size_t>((count + kPart - 1) / kPart));
    workers.run(counts.size(), [&](std::size_t part) {
        static thread_local Batch batch;
        static thread_local PhotonRun run;
        run.photons.clear();
        run.rays = run.bad = 0;
        const std::uint64_t end = std::min(first + (part + 1) * kPart, first + count);
        for (std::uint64_t number = first + part * kPart; number < end; number += kLanes) {
            begin(number, static_cast<int>(std::min<std::uint64_t>(kLanes, end - number)), batch);
            while (batch.lanes.count > 0) {
                step(batch, run);
            }
            finish(batch, run.photons);
        }
        counts[part] = {run.rays, run.bad};
        take(part, run.photons);
    });
    for (const Counts& part : counts) {
        all.rays += part.rays;
        all.bad += part.bad;
    }
    return all;
}

PhotonRun PhotonTracer::trace(std::uint64_t first, std::uint64_t count,
                              reference::TileWorkers& workers) const {
    std::vector<std::vector<Photon>> parts(static_cast<std::size_t>((count + kPart - 1) / kPart));
    PhotonRun all = trace(first, count, workers, [&](std::size_t part, std::span<const Photon> photons) {
        parts[part].assign(photons.begin(), photons.end());
    });
    std::size_t size = 0;
    for (const std::vector<Photon>& part : parts) {
        size += part.size();
    }
    all.photons.reserve(size);
    for (const std::vector<Photon>& part : parts) {
        all.photons.insert(all.photons.end(), part.begin(), part.end());
    }
    return all;
}

}  // namespace lanthorn::gi
