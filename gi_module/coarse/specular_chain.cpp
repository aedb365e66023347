#include "lanthorn/coarse/specular_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/reference/dielectric.h"

namespace lanthorn::gi {

namespace {

using reference::SurfaceHit;
using reference::SurfaceMaterial;

constexpr int kMostSurfaces = 8;
constexpr float kSmoothMetal = 0.3f;   // roughness
constexpr float kLeastThrough = 0.5f;  // transmission of what is looked through

vec3 reflected(const vec3& d, const vec3& n) {
    return glm::normalize(d - 2 * glm::dot(d, n) * n);
}

class Chain {
  public:
    Chain(const FollowedScene& scene, const SpecularRay& ray)
        : scene_(scene), origin_(ray.origin), direction_(ray.direction), enters_(ray.through != 0) {}

    SpecularHit run() {
        for (int surface = 0; surface < kMostSurfaces; ++surface) {
            SurfaceHit hit;
            if (!scene_.scene().intersect(origin_, direction_, 0, std::numeric_limits<float>::infinity(),
                                          reference::Blended::ignored, hit)) {
                return {.kind = 2, .normal = direction_, .reflectance = left_};
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
        if (material_.metallic >= 0.5f && material_.roughness < kSmoothMetal) {
            const vec3 d = reflected(direction_, normal_);
            const vec3 n = glm::dot(d, hit.normal) > 0 ? normal_ : hit.normal;
            left_ *= material_.base_colour +
                     (1.0f - material_.base_colour) *
                         reference::fifth_power(1 - glm::clamp(-glm::dot(direction_, n), 0.0f, 1.0f));
            leave(hit, reflected(direction_, n));
            return true;
        }
        return false;
    }

    void refract(const SurfaceHit& hit, const Material& material, float through) {
        const bool volume = material.bounds_volume();
        const float eta = !volume ? 1.0f : hit.front ? material.ior : 1 / material.ior;
        const reference::Incidence at(glm::clamp(-glm::dot(normal_, direction_), 0.0f, 1.0f), eta);
        const float back = volume ? at.reflectance : reference::dielectric_fresnel(material_.f0, at.cosine);
        if (at.beyond <= 0) {  // total: it stays on its side
            leave(hit, reflected(direction_, normal_));
            return;
        }
        // What the surface of the pixel itself reflects is known to the pixel.
        left_ *= material_.base_colour * (enters_ ? 1.0f : through * (1 - back));
        absorption_ = volume && hit.front ? material.absorption() : vec3(0);
        leave(hit, glm::normalize(reference::refracted(-direction_, normal_, at, eta)));
    }

    void leave(const SurfaceHit& hit, const vec3& direction) {
        const float side = glm::dot(direction, hit.normal) > 0 ? 1.0f : -1.0f;
        origin_ = reference::off_surface(hit, side * hit.normal, scene_.scene().triangles()[hit.triangle]);
        direction_ = direction;
    }

    // What is glossy there is taken to see what the hemisphere sends.
    SpecularHit end(const SurfaceHit& hit) const {
        const reference::TraceInstance& instance = scene_.scene().instances()[hit.instance];
        const reference::MaterialConstants& constants = scene_.materials()[instance.material];
        SpecularHit result{.position = hit.position, .kind = 1, .normal = normal_};
        if (!constants.unlit) {
            result.reflectance =
                left_ * (material_.diffuse_albedo() * (1 - material_.f0) +
                         glm::mix(vec3(material_.f0), material_.base_colour, material_.metallic));
        }
        if (constants.emits && (hit.front || constants.double_sided)) {
            result.emission = left_ * scene_.materials().emission(instance, hit.primitive, hit.barycentric);
        }
        return result;
    }

    const FollowedScene& scene_;
    vec3 origin_, direction_;
    bool enters_;  // the next surface is the pixel's own
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
