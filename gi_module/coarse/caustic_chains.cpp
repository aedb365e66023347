#include "lanthorn/coarse/caustic_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/coarse/packed_normal.h"
#include "lanthorn/gi/emc/caustic_aim.h"
#include "lanthorn/gi/emc/exact_rays.h"
#include "lanthorn/reference/bsdf.h"
#include "lanthorn/reference/dielectric.h"
#include "lanthorn/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

// Smith's shadowing of light that leaves, given that it was not masked on its way in: what drawing visible
// normals leaves to weigh (Heitz 2018, eq. 19; height-correlated as bsdf.h has it).
float shadowing(float nl, float nv, float a) {
    const float a2 = a * a;
    const float v = std::sqrt(a2 + (1 - a2) * nv * nv);
    const float l = std::sqrt(a2 + (1 - a2) * nl * nl);
    return nl * (nv + v) / std::max(nl * v + nv * l, 1e-20f);
}

}  // namespace

struct CausticChains::Flight {
    vec3 origin;
    vec3 direction;
    vec3 power;
};

bool CausticChains::meet(const Flight& flight, SurfaceHit& hit) const {
    constexpr auto kBlended = reference::Blended::ignored;
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

void CausticChains::follow(const CausticPhoton& photon, std::vector<PhotonHit>& arrivals) const {
    const reference::RandomNumbers random(seed_, photon.key, photon.number);
    Flight flight{photon.origin, photon.direction, photon.power};
    for (int surfaces = 0; surfaces < kCausticSurfaces; ++surfaces) {
        SurfaceHit hit;
        if (reference::is_black(flight.power) || !meet(flight, hit)) {
            return;
        }
        if (surfaces == 0) {
            if (target_of_[hit.instance] != photon.target) {
                return;
            }
            const float s = hit.t / photon.range;  // KHR_lights_punctual's window
            flight.power *= glm::clamp(1 - s * s * s * s, 0.0f, 1.0f);
        }
        const reference::TraceInstance& instance = scene_.instances()[hit.instance];
        const Material& material = scene_.frame().assets->materials[instance.material];
        const SurfaceMaterial surface = materials_.evaluate(instance, hit.primitive, hit.barycentric);
        const bool glass = material.transmission > 0;
        if (material.unlit || !(hit.front || material.double_sided || glass)) {
            return;
        }
        if (!hit.front && material.bounds_volume()) {
            flight.power *= glm::exp(-material.absorption() * hit.t);
        }
        const bool goes_on = surface.transmission * (1 - surface.metallic) > 0 ||
                             (surface.metallic > 0.5f && surface.roughness < kRoughestMirror);
        const float diffuse = (1 - surface.metallic) * (1 - surface.transmission);
        if (surfaces > 0 && (!goes_on || diffuse > 0)) {
            arrivals.push_back({hit.position, 0, flight.power, pack_normal(hit.normal)});
        }
        if (!goes_on || !scatter(hit, surface, random, 2 * static_cast<std::uint32_t>(surfaces), flight)) {
            return;
        }
    }
}

}  // namespace lanthorn::gi
