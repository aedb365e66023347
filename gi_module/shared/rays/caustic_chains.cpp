#include "gi_module/shared/rays/caustic_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/dielectric.h"
#include "gi_module/reference/sampling.h"
#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/rays/packed_normal.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

// That a photon meets on its way from what scatters it to where it lands, at most.
constexpr int kCausticSurfaces = 10;

// Smith's shadowing of light that leaves, given that it was not masked on its way in: what drawing visible
// normals leaves to weigh (Heitz 2018, eq. 19; height-correlated as bsdf.h has it).
float shadowing(float nl, float nv, float a) {
    const float a2 = a * a;
    const float v = std::sqrt(a2 + (1 - a2) * nv * nv);
    const float l = std::sqrt(a2 + (1 - a2) * nl * nl);
    return nl * (nv + v) / std::max(nl * v + nv * l, 1e-20f);
}

// Of photons that land straight from their lamp, one in so many is followed on.
constexpr float kShare = 4;
constexpr float kEverywhere = 1e30f;

// KHR_lights_punctual's, at a share of a light's range.
float window(float s) {
    return glm::clamp(1 - s * s * s * s, 0.0f, 1.0f);
}

// What mirrors light or lets it through, at this point of it.
bool goes_on(const SurfaceMaterial& surface) {
    return surface.transmission * (1 - surface.metallic) > 0 ||
           (surface.metallic > 0.5f && surface.roughness < kRoughestMirror);
}

}  // namespace

struct CausticChains::Flight {
    vec3 origin;
    vec3 direction;
    vec3 power;
    int reflections = 0;       // so far; boundaries of volumes are none, as in the reference
    int most_reflections = 0;  // of one that arrives
};

// Where light has arrived on what scatters it.
struct CausticChains::Landing {
    SurfaceHit hit;
    SurfaceMaterial surface;
    vec3 direction{0};  // of the light
    vec3 power{0};
    int reflections = 0;    // before
    bool specular = false;  // it has met a mirror or glass
};

// A photon's own, each used once.
struct CausticChains::Numbers {
    const reference::RandomNumbers& random;
    std::uint32_t dimension;

    vec2 next() { return random.pair(dimension++); }
    std::uint32_t skip(std::uint32_t count) { return std::exchange(dimension, dimension + count); }
};

bool CausticChains::meet(const Flight& flight, SurfaceHit& hit) const {
    constexpr auto kBlended = reference::Blended::by_chance;
    if (!scene_.intersect(flight.origin, flight.direction, 0, std::numeric_limits<float>::infinity(),
                          kBlended, hit)) {
        return false;
    }
    if (!hit.front && !materials_[scene_.instances()[hit.instance].material].double_sided) {
        scene_.prefer_front(flight.origin, flight.direction, kBlended, hit);
    }
    return true;
}

// On from a mirror or through glass. False: the photon ends here.
bool CausticChains::scatter(const SurfaceHit& hit, const SurfaceMaterial& surface,
                            const reference::RandomNumbers& random, std::uint32_t dimension,
                            Flight& flight) const {
    const reference::TraceInstance& instance = scene_.instances()[hit.instance];
    const Material& material = scene_.frame().assets->materials[instance.material];
    const vec3 v = -flight.direction;
    vec3 n = materials_.shading_normal(instance, hit);
    if (glm::dot(n, v) < 1e-3f) {  // interpolated beyond the horizon
        n = hit.normal;
    }
    const bool smooth = reference::is_smooth(surface.roughness);
    const float alpha = std::max(surface.roughness * surface.roughness, reference::kSmallestAlpha);
    vec3 h = n;
    if (!smooth) {
        const reference::Basis basis(n);
        h = basis.to_world(reference::visible_normal(basis.to_local(v), alpha, random.pair(dimension)));
    }
    const float vh = glm::clamp(glm::dot(v, h), 0.0f, 1.0f);

    // A thin wall's two sides are one border, as the reference has it; a volume's border is Fresnel's.
    const bool volume = material.bounds_volume();
    const float eta = hit.front ? material.ior : 1 / material.ior;
    const reference::Incidence at(vh, eta);
    float dielectric = reference::dielectric_fresnel(surface.f0, vh);
    if (volume) {
        const float plain = (material.ior - 1) / (material.ior + 1);
        const float strength = plain > 0 ? surface.f0 / (plain * plain) : 1.0f;  // KHR_materials_specular
        dielectric = at.beyond > 0 ? std::min(at.reflectance * strength, 1.0f) : at.reflectance;
    }
    const float metallic = surface.roughness < kRoughestMirror ? surface.metallic : 0.0f;
    const vec3 metal = surface.base_colour + (1.0f - surface.base_colour) * reference::fifth_power(1 - vh);
    const float glass = (1 - surface.metallic) * (surface.transmission > 0 ? 1.0f : 0.0f);
    const vec3 mirrored = metal * metallic + vec3(dielectric * glass);
    const vec3 passing =
        surface.base_colour * ((1 - surface.metallic) * surface.transmission * (1 - dielectric));

    const float r = reference::largest(mirrored);
    const float t = reference::largest(passing);
    // As likely as what is left, so that power stays the same; never more than certain.
    const float scale = 1 / std::max(r + t, 1.0f);
    const float choice = random.pair(dimension + 1).x;
    vec3 l;
    if (choice < r * scale) {
        l = h * (2 * vh) - v;
        flight.power *= mirrored / (r * scale);
        flight.reflections += volume ? 0 : 1;
    } else if (choice < (r + t) * scale) {
        if (volume) {
            l = reference::refracted(v, h, at, eta);
        } else if (smooth) {
            l = -v;
        } else {  // the lobe of reflection, to the other side
            l = h * (2 * vh) - v;
            l -= n * (2 * glm::dot(n, l));
        }
        flight.power *= passing / (t * scale);
    } else {
        return false;
    }
    const bool through = choice >= r * scale;
    const float side = through ? -1.0f : 1.0f;
    const float nl = side * glm::dot(n, l);
    if (!(nl > 0)) {
        return false;
    }
    if (!smooth) {
        flight.power *= shadowing(nl, std::max(glm::dot(n, v), 1e-4f), alpha);
    }
    if (!(side * glm::dot(hit.normal, l) > 0)) {  // through the triangle itself, not its smooth shape
        l -= hit.normal * ((1 + 1e-3f) * glm::dot(hit.normal, l));
    }
    flight.direction = reference::unit(l);
    flight.origin = reference::off_surface(hit, side * hit.normal, scene_.triangles()[hit.triangle]);
    return true;
}

bool CausticChains::chain(Flight flight, std::uint32_t target, float range,
                          const reference::RandomNumbers& random, std::uint32_t dimension,
                          std::vector<PhotonHit>& arrivals, Landing& landing) const {
    for (int surfaces = 0; surfaces < kCausticSurfaces; ++surfaces) {
        SurfaceHit hit;
        if (reference::is_black(flight.power) || !meet(flight, hit)) {
            return false;
        }
        if (surfaces == 0) {
            if (targets_.of_instance[hit.instance] != target) {
                return false;
            }
            flight.power *= window(hit.t / range);
        }
        const reference::TraceInstance& instance = scene_.instances()[hit.instance];
        const Material& material = scene_.frame().assets->materials[instance.material];
        const SurfaceMaterial surface = materials_.evaluate(instance, hit.primitive, hit.barycentric);
        const bool glass = material.transmission > 0;
        if (material.unlit || !(hit.front || material.double_sided || glass)) {
            return false;
        }
        if (!hit.front && material.bounds_volume()) {
            flight.power *= glm::exp(-material.absorption() * hit.t);
        }
        const bool on = goes_on(surface);
        const float diffuse = (1 - surface.metallic) * (1 - surface.transmission);
        if (surfaces > 0 && flight.reflections <= flight.most_reflections && (!on || diffuse > 0)) {
            arrivals.push_back({hit.position, 0, flight.power, pack_normal(hit.normal)});
            if (!on) {
                landing = {hit, surface, flight.direction, flight.power, flight.reflections, true};
                return true;
            }
        }
        if (!on ||
            !scatter(hit, surface, random, dimension + 2 * static_cast<std::uint32_t>(surfaces), flight)) {
            return false;
        }
    }
    return false;
}

// Of many targets a few are asked; the one to aim at is drawn by how large it is as seen from there
// (resampling: Talbot et al. 2005).
float CausticChains::aim(const Landing& at, Numbers& numbers, vec3& direction, std::uint32_t& target) const {
    constexpr std::size_t kAsked = 8;
    const std::size_t count = targets_.targets.size();
    const std::size_t asked = std::min(count, kAsked);
    std::array<CausticAim, kAsked> aims;
    std::array<std::uint32_t, kAsked> indices{};
    std::array<double, kAsked> sizes{};
    const dvec3 from(at.hit.position);
    double sum = 0;
    for (std::size_t i = 0; i < asked; ++i) {
        indices[i] = static_cast<std::uint32_t>(
            count <= kAsked ? i
                            : std::min(static_cast<std::size_t>(numbers.next().x * static_cast<float>(count)),
                                       count - 1));
        aims[i] = aim_at(targets_.targets[indices[i]].bounds, from);
        sizes[i] = std::min(aims[i].one_less_cosine, 1.0);
        // All of it below the horizon.
        const double up = glm::dot(aims[i].axis, dvec3(at.hit.normal));
        if (up < 0 && aims[i].one_less_cosine < 1 &&
            up * up > aims[i].one_less_cosine * (2 - aims[i].one_less_cosine)) {
            sizes[i] = 0;
        }
        sum += sizes[i];
    }
    if (!(sum > 0)) {
        return 0;
    }
    double choice = static_cast<double>(numbers.next().x) * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < asked && (choice >= sizes[chosen] || !(sizes[chosen] > 0))) {
        choice -= sizes[chosen++];
    }
    if (!(sizes[chosen] > 0)) {
        return 0;
    }
    target = indices[chosen];
    const double weight = sum / sizes[chosen] * static_cast<double>(count) / static_cast<double>(asked);
    if (aims[chosen].one_less_cosine < 1) {
        direction = vec3(in_cone(aims[chosen], glm::dvec2(numbers.next())));
        return static_cast<float>(aims[chosen].solid_angle() * weight);
    }
    direction = reference::cosine_direction(at.hit.normal, numbers.next());
    return static_cast<float>(weight) * kPi / std::max(glm::dot(direction, at.hit.normal), 1e-6f);
}

void CausticChains::walk(Landing at, Numbers& numbers, std::vector<PhotonHit>& arrivals) const {
    const float whole = reference::largest(at.power);
    while (at.reflections < bounces_) {
        const reference::TraceInstance& instance = scene_.instances()[at.hit.instance];
        const Material& material = scene_.frame().assets->materials[instance.material];
        if (material.unlit || !(at.hit.front || material.double_sided)) {
            return;
        }
        const vec3 v = -at.direction;
        const reference::Bsdf bsdf(at.surface, materials_.shading_normal(instance, at.hit), at.hit.normal, v,
                                   true);
        const auto leave = [&](const vec3& l, const vec3& power) {
            return Flight{reference::off_surface(at.hit, at.hit.normal, scene_.triangles()[at.hit.triangle]),
                          l, power, at.reflections + 1, bounces_};
        };
        vec3 l;
        std::uint32_t target = 0;
        const float weight = aim(at, numbers, l, target);
        if (weight > 0 && glm::dot(l, at.hit.normal) > 0) {
            Landing landing;
            const vec3 power = at.power * bsdf.evaluate(l) * weight;
            const std::uint32_t dimension = numbers.skip(2 * kCausticSurfaces);
            if (!reference::is_black(power) &&
                chain(leave(l, power), target, kEverywhere, numbers.random, dimension, arrivals, landing)) {
                const float chance = std::min(reference::largest(landing.power) / whole, 1.0f);
                if (numbers.next().x < chance) {
                    landing.power /= chance;
                    walk(landing, numbers, arrivals);
                }
            }
        }
        const vec2 u = numbers.next(), chances = numbers.next();
        l = bsdf.sample(chances.x, u);
        const float density = bsdf.density(l);
        if (!(density > 0) || !(glm::dot(l, at.hit.normal) > 0)) {
            return;
        }
        const vec3 share = bsdf.evaluate(l) / density;
        const float chance = std::min(reference::largest(share), 1.0f);
        if (!(chances.y < chance)) {
            return;
        }
        const Flight flight = leave(l, at.power * share / chance);
        SurfaceHit hit;
        if (!meet(flight, hit)) {
            return;
        }
        const reference::TraceInstance& met = scene_.instances()[hit.instance];
        const SurfaceMaterial surface = materials_.evaluate(met, hit.primitive, hit.barycentric);
        if (goes_on(surface)) {
            return;  // it has been aimed at
        }
        at = {hit, surface, l, flight.power, flight.reflections, at.specular};
        if (at.specular) {
            arrivals.push_back({hit.position, 0, at.power, pack_normal(hit.normal)});
        }
    }
}

void CausticChains::follow(const CausticPhoton& photon, CausticArrivals& arrivals) const {
    const reference::RandomNumbers random(seed_, photon.key, photon.number);
    Numbers numbers{random, 2 * kCausticSurfaces};
    Flight flight{photon.origin, photon.direction, photon.power, 0, kCausticSurfaces};
    Landing landing;
    if (photon.target != CausticPhoton::kAround) {
        const bool landed = chain(flight, photon.target, photon.range, random, 0, arrivals.straight, landing);
        if (landed && numbers.next().x < 1.0f / kShare) {
            landing.power *= kShare;
            walk(landing, numbers, arrivals.scattered);
        }
        return;
    }
    SurfaceHit hit;
    if (!meet(flight, hit)) {
        return;
    }
    const SurfaceMaterial surface =
        materials_.evaluate(scene_.instances()[hit.instance], hit.primitive, hit.barycentric);
    if (!goes_on(surface)) {
        walk({hit, surface, flight.direction, flight.power * window(hit.t / photon.range), 0, false}, numbers,
             arrivals.scattered);
    }
}

}  // namespace lanthorn::gi
