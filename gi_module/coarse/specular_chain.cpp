#include "lanthorn/coarse/specular_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/reference/bsdf.h"
#include "lanthorn/reference/dielectric.h"
#include "lanthorn/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

constexpr int kMostSurfaces = 16;
constexpr float kGlossyMetal = 0.5f;   // roughness: narrower lobes are followed
constexpr float kLeastThrough = 0.5f;  // transmission of what is looked through

vec3 reflected(const vec3& d, const vec3& n) {
    return glm::normalize(d - 2 * glm::dot(d, n) * n);
}

// The i-th of Hammersley's set of 16, which a picture's squares of 4 x 4 pixels have whole.
vec2 lobe_number(std::uint32_t i) {
    const std::uint32_t back = (i & 1) << 3 | (i & 2) << 1 | (i & 4) >> 1 | (i & 8) >> 3;
    return (vec2(static_cast<float>(i), static_cast<float>(back)) + 0.5f) / 16.0f;
}

class Chain {
  public:
    Chain(const FollowedScene& scene, const SpecularRay& ray)
        : scene_(scene),
          origin_(ray.origin),
          direction_(ray.direction),
          enters_((ray.through & 1) != 0),
          lobe_(ray.through >> 1) {}

    SpecularHit run() {
        for (int surface = 0; surface < kMostSurfaces; ++surface) {
            SurfaceHit hit;
            if (!scene_.scene().intersect(origin_, direction_, 0, std::numeric_limits<float>::infinity(),
                                          reference::Blended::ignored, hit)) {
                return {.kind = 2, .normal = direction_, .spread = spread_, .reflectance = left_};
            }
            left_ *= glm::exp(-absorption_ * hit.t);
            if (!pass(hit)) {
                return end(hit);
            }
            enters_ = false;
        }
        return {};
    }

  private:
    // Whether the ray goes on from there.
    bool pass(const SurfaceHit& hit) {
        const reference::TraceInstance& instance = scene_.scene().instances()[hit.instance];
        const Material& material = scene_.scene().frame().assets->materials[instance.material];
        material_ = scene_.materials().evaluate(instance, hit.primitive, hit.barycentric);
        normal_ = scene_.materials().shading_normal(instance, hit);
        if (glm::dot(normal_, direction_) > -1e-3f) {
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
        spread_ = 1;
        const vec2 u = lobe_number(lobe_);
        lobe_ = (5 * lobe_ + 3) & 15;  // the next rough surface has another of the 16
        const reference::Basis basis(normal_);
        return basis.to_world(reference::visible_normal(basis.to_local(-direction_),
                                                        material_.roughness * material_.roughness, u));
    }

    // False: the lobe lies below the surface.
    bool mirror(const SurfaceHit& hit) {
        const vec3 h = facet();
        const vec3 d = reflected(direction_, h);
        const bool above = glm::dot(d, hit.normal) > 0;
        if (!above && spread_ > 0) {
            return false;
        }
        const vec3 n = above ? h : hit.normal;
        left_ *= material_.base_colour +
                 (1.0f - material_.base_colour) *
                     reference::fifth_power(1 - glm::clamp(-glm::dot(direction_, n), 0.0f, 1.0f));
        leave(hit, reflected(direction_, n));
        return true;
    }

    void refract(const SurfaceHit& hit, const Material& material, float through) {
        const bool volume = material.bounds_volume();
        const float eta = !volume ? 1.0f : hit.front ? material.ior : 1 / material.ior;
        const vec3 h = facet();
        const reference::Incidence at(glm::clamp(-glm::dot(h, direction_), 0.0f, 1.0f), eta);
        const float back = volume ? at.reflectance : reference::dielectric_fresnel(material_.f0, at.cosine);
        if (at.beyond <= 0) {  // total: it stays on its side
            leave(hit, reflected(direction_, h));
            return;
        }
        // What the surface of the pixel itself reflects is known to the pixel.
        left_ *= material_.base_colour * (enters_ ? 1.0f : through * (1 - back));
        // Radiance grows with the square of the index (Veach 1997, sec. 5.2): what lies in water is darker
        // from above.
        left_ /= eta * eta;
        absorption_ = volume && hit.front ? material.absorption() : vec3(0);
        vec3 on = glm::normalize(reference::refracted(-direction_, h, at, eta));
        if (!volume && h != normal_) {  // a thin wall's lobe is that of reflection, to the other side
            on = reflected(direction_, h);
            on -= normal_ * (2 * std::max(glm::dot(on, normal_), 0.0f));
        }
        if (!(glm::dot(on, hit.normal) < 0)) {
            on = direction_;
        }
        leave(hit, on);
    }

    void leave(const SurfaceHit& hit, const vec3& direction) {
        const float side = glm::dot(direction, hit.normal) > 0 ? 1.0f : -1.0f;
        origin_ = reference::off_surface(hit, side * hit.normal, scene_.scene().triangles()[hit.triangle]);
        direction_ = direction;
    }

    // What is glossy there is taken to see what the hemisphere sends (diffuse_reflectance.h).
    SpecularHit end(const SurfaceHit& hit) const {
        const reference::TraceInstance& instance = scene_.scene().instances()[hit.instance];
        const reference::MaterialConstants& constants = scene_.materials()[instance.material];
        SpecularHit result{.position = hit.position, .kind = 1, .normal = normal_, .spread = spread_};
        if (!constants.unlit) {
            const float tinted = base_reflectance(material_.metallic, material_.transmission,
                                                  material_.roughness, constants.reflects.transmittance, 1);
            result.reflectance = left_ * (material_.base_colour * tinted + constants.reflects.boundary);
        }
        if (constants.emits && (hit.front || constants.double_sided)) {
            result.emission = left_ * scene_.materials().emission(instance, hit.primitive, hit.barycentric);
            result.emitter = instance.id + 1;
        }
        return result;
    }

    const FollowedScene& scene_;
    vec3 origin_, direction_;
    bool enters_;         // the next surface is the pixel's own
    std::uint32_t lobe_;  // 0 to 15: which direction of a rough surface's lobe is followed
    float spread_ = 0;    // 1: it has been one of a lobe's directions
    vec3 left_{1};
    vec3 absorption_{0};  // of the volume that it is in
    vec3 normal_{0};
    SurfaceMaterial material_;
};

}  // namespace

SpecularHit follow_chain(const FollowedScene& scene, const SpecularRay& ray) {
    return Chain(scene, ray).run();
}

}  // namespace lanthorn::gi
