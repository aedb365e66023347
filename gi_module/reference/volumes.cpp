// The integrator's way through volumes: glass and water that light enters, is bent by and absorbed in.
#include <cmath>
#include <limits>

#include "gi_module/reference/integrator.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kMostAbove = 64;  // surfaces looked at for where the camera is

}  // namespace

bool Integrator::bounds_volume(const SurfaceHit& hit) const {
    return materials_[scene_.instances()[hit.instance].material].volume;
}

vec3 Integrator::attenuation(std::uint32_t medium, float metres) const {
    if (medium == kAir) {
        return vec3(1);
    }
    const vec3& absorption = materials_[medium].absorption;
    // Not by 0 times infinity.
    return select(absorption.x + absorption.y + absorption.z > 0,
                  {absorption.x > 0 ? std::exp(-absorption.x * metres) : 1.0f,
                   absorption.y > 0 ? std::exp(-absorption.y * metres) : 1.0f,
                   absorption.z > 0 ? std::exp(-absorption.z * metres) : 1.0f},
                  vec3(1));
}

bool Integrator::pass_boundary(Flight& flight, const SurfaceHit& hit, const RandomNumbers& random,
                               std::uint32_t vertex) const {
    const TraceInstance& instance = scene_.instances()[hit.instance];
    const MaterialConstants& constants = materials_[instance.material];
    const SurfaceMaterial material = materials_.evaluate(instance, hit.primitive, hit.barycentric);
    // What is met from behind was inside, wherever it came from.
    flight.throughput *= attenuation(hit.front ? flight.medium : instance.material, hit.t);
    if (flight.boundaries >= kMostBoundaries || is_black(flight.throughput)) {
        flight.throughput = vec3(0);
        return false;
    }
    const std::uint32_t dimension = boundary_dimension(vertex, flight.boundaries++);
    const vec2 choice = random.pair(dimension);
    const float hole = 1 - material.alpha;
    const float glass = material.alpha * material.transmission * (1 - material.metallic);
    if (choice.x >= hole + glass) {
        return false;
    }
    flight.bent = true;
    const TraceTriangle& triangle = scene_.triangles()[hit.triangle];
    if (choice.x < hole) {
        flight.ray.origin = off_surface(hit, -hit.normal, triangle);
        return true;
    }
    const float eta = hit.front ? constants.ior : 1 / constants.ior;
    const BoundarySample sample =
        sample_boundary(-flight.ray.direction, materials_.shading_normal(instance, hit), hit.normal, eta,
                        material.roughness, choice.y, random.pair(dimension + 1));
    flight.throughput *= sample.weight;
    if (sample.through) {
        // Radiance grows with the square of the index (Veach 1997, sec. 5.2).
        flight.throughput *= material.base_colour / (eta * eta);
        flight.medium = hit.front ? instance.material : kAir;
    }
    flight.ray = {off_surface(hit, sample.through ? -hit.normal : hit.normal, triangle), sample.direction};
    return true;
}

std::uint32_t Integrator::medium_at(const vec3& point) const {
    float nearest = 0;
    SurfaceHit hit;
    for (int layer = 0; layer < kMostAbove; ++layer) {
        if (!scene_.intersect(point, vec3(0, 1, 0), nearest, kInfinity, blended_, hit)) {
            break;
        }
        if (bounds_volume(hit)) {
            return hit.front ? kAir : scene_.instances()[hit.instance].material;
        }
        nearest = std::nextafter(hit.t, kInfinity);
    }
    return kAir;
}

}  // namespace lanthorn::reference
