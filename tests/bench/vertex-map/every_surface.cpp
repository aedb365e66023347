#include "tests/bench/vertex-map/every_surface.h"

#include <cmath>
#include <limits>

namespace lanthorn::bench {

namespace {
constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Metres that a ray begins beyond where it starts; a hit may be off by as much.
constexpr float kOff = 1e-4f;
}  // namespace

EverySurface::EverySurface(const FrameScene& scene) {
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.assets->meshes[instance.mesh];
        for (std::size_t i = 0; i + 3 < mesh.vertices.size(); i += 4) {
            const vec3 corner = mesh.vertices[i].position;
            const vec3 u = mesh.vertices[i + 1].position - corner;
            const vec3 v = mesh.vertices[i + 3].position - corner;
            const vec3 n = glm::cross(u, v);
            const float n2 = glm::dot(n, n);
            surfaces_.push_back({corner, n, glm::cross(v, n) / n2, glm::cross(n, u) / n2});
        }
    }
}

float EverySurface::nearest(const vec3& origin, const vec3& direction) const {
    float nearest = kInfinity;
    for (const Parallelogram& s : surfaces_) {
        const vec3 from = origin - s.corner;
        const float t = -glm::dot(from, s.normal) / glm::dot(direction, s.normal);
        if (!(t > kOff && t < nearest)) {
            continue;
        }
        const vec3 at = from + t * direction;
        const float u = glm::dot(at, s.along_u), v = glm::dot(at, s.along_v);
        if (u >= 0 && u <= 1 && v >= 0 && v <= 1) {
            nearest = t;
        }
    }
    return nearest;
}

EverySurface::Asked EverySurface::ask(const gi::PhotonStore& store, const vec3& lamp) const {
    Asked asked;
    for (const std::uint32_t place : store.changed()) {
        const gi::StoredPhoton& photon = store[place];
        if (!photon.used) {
            continue;
        }
        const vec3 origin = place < store.total() ? lamp : store[place - store.total()].position;
        const float distance = glm::distance(origin, photon.position);
        const float met = nearest(origin, (photon.position - origin) / distance);
        ++asked.rays;
        asked.agree += std::abs(met - distance) < 10 * kOff ? 1 : 0;
    }
    return asked;
}

}  // namespace lanthorn::bench
