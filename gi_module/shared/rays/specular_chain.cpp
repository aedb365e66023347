#include "gi_module/shared/rays/specular_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/dielectric.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

constexpr std::size_t kRaysARun = 256;  // rays that a thread takes at once
constexpr int kMostSurfaces = 16;
constexpr int kMostSplits = 4;             // reflections by glass that are followed beside a ray
constexpr float kLeastReflected = 0.004f;  // of what the ray brings: less is left out
constexpr float kGlossyMetal = 0.5f;       // roughness: narrower lobes are followed
constexpr float kLeastThrough = 0.5f;      // transmission of what is looked through

vec3 reflected(const vec3& d, const vec3& n) {
    return glm::normalize(d - 2 * glm::dot(d, n) * n);
}

// The i-th of Hammersley's set of 16, which a picture's squares of 4 x 4 pixels have whole.
vec2 lobe_number(std::uint32_t i) {
    const std::uint32_t back = (i & 1) << 3 | (i & 2) << 1 | (i & 4) >> 1 | (i & 8) >> 3;
    return (vec2(static_cast<float>(i), static_cast<float>(back)) + 0.5f) / 16.0f;
}

// A way of light, from where it has been followed to.
struct Way {
    vec3 origin{0}, direction{0};
    vec3 left{1};            // of what it brings
    vec3 absorption{0};      // of the volume that it is in
    bool enters = false;     // the next surface is the pixel's own
    std::uint32_t lobe = 0;  // 0 to 15: which direction of a rough surface's lobe is followed
    float spread = 0;        // 1: it has been one of a lobe's directions
    int surfaces = 0;        // met so far
};

class Chain {
  public:
    Chain(const FollowedScene& scene, const SpecularRay& ray)
        : scene_(scene),
          way_{.origin = ray.origin,
               .direction = ray.direction,
               .enters = (ray.through & 1) != 0,
               .lobe = ray.through >> 1} {}

    void run(std::vector<ChainEnd>& ends) {
        ends.push_back(followed());
        for (int i = 0; i < split_; ++i) {
            way_ = besides_[static_cast<std::size_t>(i)];
            ends.push_back(followed());
        }
    }

  private:
    // To where it ends.
    ChainEnd followed() {
        for (; way_.surfaces < kMostSurfaces; ++way_.surfaces) {
            SurfaceHit hit;
            if (!scene_.scene().intersect(way_.origin, way_.direction, 0,
                                          std::numeric_limits<float>::infinity(),
                                          reference::Blended::by_chance, hit)) {
                return {{.kind = kMetSky,
                         .normal = way_.direction,
                         .spread = way_.spread,
                         .reflectance = way_.left},
                        {}};
            }
            way_.left *= glm::exp(-way_.absorption * hit.t);
            if (!pass(hit)) {
                return {end(hit), {hit.instance, hit.primitive, hit.barycentric, hit.front}};
            }
            way_.enters = false;
        }
        return {};
    }

    // Whether the ray goes on from there.
    bool pass(const SurfaceHit& hit) {
        const reference::TraceInstance& instance = scene_.scene().instances()[hit.instance];
        const Material& material = scene_.scene().frame().assets->materials[instance.material];
        material_ = scene_.materials().evaluate(instance, hit.primitive, hit.barycentric);
        normal_ = scene_.materials().shading_normal(instance, hit);
        if (glm::dot(normal_, way_.direction) > -1e-3f) {
            normal_ = hit.normal;
        }
        const float through = material_.transmission * (1 - material_.metallic);
        if (through >= kLeastThrough) {
            refract(hit, material, through);
            return true;
        }
        if (material_.metallic >= 0.5f && material_.roughness < kGlossyMetal) {
            return mirror(hit);
        }
        return false;
    }

    // The normal that light is mirrored or bent about: a rough surface's is one of its lobe's, as seen from
    // where the ray comes from (bsdf.h).
    vec3 facet() {
        if (reference::is_smooth(material_.roughness)) {
            return normal_;
        }
        way_.spread = 1;
        const vec2 u = lobe_number(way_.lobe);
        way_.lobe = (5 * way_.lobe + 3) & 15;  // the next rough surface has another of the 16
        const reference::Basis basis(normal_);
        return basis.to_world(reference::visible_normal(basis.to_local(-way_.direction),
                                                        material_.roughness * material_.roughness, u));
    }

    // False: the lobe lies below the surface.
    bool mirror(const SurfaceHit& hit) {
        const vec3 h = facet();
        const vec3 d = reflected(way_.direction, h);
        const bool above = glm::dot(d, hit.normal) > 0;
        if (!above && way_.spread > 0) {
            return false;
        }
        const vec3 n = above ? h : hit.normal;
        way_.left *= material_.base_colour +
                     (1.0f - material_.base_colour) *
                         reference::fifth_power(1 - glm::clamp(-glm::dot(way_.direction, n), 0.0f, 1.0f));
        leave(hit, reflected(way_.direction, n));
        return true;
    }

    void refract(const SurfaceHit& hit, const Material& material, float through) {
        const bool volume = material.bounds_volume();
        const float eta = !volume ? 1.0f : hit.front ? material.ior : 1 / material.ior;
        const vec3 h = facet();
        const reference::Incidence at(glm::clamp(-glm::dot(h, way_.direction), 0.0f, 1.0f), eta);
        const float back = volume ? at.reflectance : reference::dielectric_fresnel(material_.f0, at.cosine);
        if (at.beyond <= 0) {  // total: it stays on its side
            leave(hit, reflected(way_.direction, h));
            return;
        }
        // What the surface of the pixel itself reflects is known to the pixel.
        if (!way_.enters) {
            split(hit, h, through * back);
        }
        way_.left *= material_.base_colour * (way_.enters ? 1.0f : through * (1 - back));
        // Radiance grows with the square of the index (Veach 1997, sec. 5.2): what lies in water is darker
        // from above.
        way_.left /= eta * eta;
        way_.absorption = volume && hit.front ? material.absorption() : vec3(0);
        vec3 on = glm::normalize(reference::refracted(-way_.direction, h, at, eta));
        if (!volume && h != normal_) {  // a thin wall's lobe is that of reflection, to the other side
            on = reflected(way_.direction, h);
            on -= normal_ * (2 * std::max(glm::dot(on, normal_), 0.0f));
        }
        if (!(glm::dot(on, hit.normal) < 0)) {
            on = way_.direction;
        }
        leave(hit, on);
    }

    // The way that is reflected about `h`, of which comes back that share.
    void split(const SurfaceHit& hit, const vec3& h, float share) {
        const vec3 d = reflected(way_.direction, h);
        if (split_ == kMostSplits || !(reference::largest(way_.left) * share >= kLeastReflected) ||
            !(glm::dot(d, hit.normal) > 0)) {
            return;
        }
        const Way on = way_;
        way_.left *= share;
        ++way_.surfaces;
        leave(hit, d);
        besides_[static_cast<std::size_t>(split_++)] = std::exchange(way_, on);
    }

    void leave(const SurfaceHit& hit, const vec3& direction) {
        const float side = glm::dot(direction, hit.normal) > 0 ? 1.0f : -1.0f;
        way_.origin =
            reference::off_surface(hit, side * hit.normal, scene_.scene().triangles()[hit.triangle]);
        way_.direction = direction;
    }

    // What is glossy there is taken to see what the hemisphere sends (diffuse_reflectance.h).
    SpecularHit end(const SurfaceHit& hit) const {
        const reference::TraceInstance& instance = scene_.scene().instances()[hit.instance];
        const reference::MaterialConstants& constants = scene_.materials()[instance.material];
        SpecularHit result{
            .position = hit.position, .kind = kMetSurface, .normal = normal_, .spread = way_.spread};
        if (!constants.unlit) {
            const float tinted = base_reflectance(material_.metallic, material_.transmission,
                                                  material_.roughness, constants.reflects.transmittance, 1);
            result.reflectance = way_.left * (material_.base_colour * tinted + constants.reflects.boundary);
        }
        if (constants.emits && (hit.front || constants.double_sided)) {
            result.emission =
                way_.left * material_.emissive;  // what is blended is met by chance of its alpha
            result.emitter = instance.id + 1;
        }
        return result;
    }

    const FollowedScene& scene_;
    Way way_;
    std::array<Way, kMostSplits> besides_;  // yet to be followed
    int split_ = 0;                         // of those
    vec3 normal_{0};
    SurfaceMaterial material_;
};

}  // namespace

void follow_chain(const FollowedScene& scene, const SpecularRay& ray, std::vector<ChainEnd>& ends) {
    Chain(scene, ray).run(ends);
}

std::vector<SpecularHit> follow_chains(const FollowedScene& scene, std::span<const SpecularRay> rays,
                                       reference::TileWorkers& workers, std::vector<ChainSurface>* surfaces) {
    std::vector<SpecularHit> ends(rays.size());
    if (surfaces != nullptr) {
        surfaces->resize(rays.size());
    }
    std::vector<std::vector<ChainEnd>> more((rays.size() + kRaysARun - 1) / kRaysARun);
    const auto each_of = [&](std::size_t run, const auto& what) {
        for (std::size_t i = run * kRaysARun; i < std::min((run + 1) * kRaysARun, rays.size()); ++i) {
            what(i);
        }
    };
    workers.run(more.size(), [&](std::size_t run) {
        std::vector<ChainEnd> found;
        each_of(run, [&](std::size_t i) {
            found.clear();
            follow_chain(scene, rays[i], found);
            ends[i] = found.front().hit;
            ends[i].next = static_cast<std::uint32_t>(found.size() - 1);  // how many more, at first
            if (surfaces != nullptr) {
                (*surfaces)[i] = found.front().surface;
            }
            more[run].insert(more[run].end(), found.begin() + 1, found.end());
        });
    });
    for (std::size_t run = 0; run < more.size(); ++run) {
        auto at = static_cast<std::uint32_t>(ends.size());
        for (const ChainEnd& end : more[run]) {
            ends.push_back(end.hit);
            if (surfaces != nullptr) {
                surfaces->push_back(end.surface);
            }
        }
        each_of(run, [&](std::size_t i) {
            std::size_t end = i;
            for (std::uint32_t count = std::exchange(ends[i].next, 0); count > 0; --count) {
                ends[end].next = at;
                end = at++;
            }
        });
    }
    return ends;
}

}  // namespace lanthorn::gi
