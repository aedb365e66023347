// Diffuse transport: the integrator's paths in lanes. Rays are traced one by one and surfaces looked up one
// by one; all arithmetic in between is path_lanes.h's.
#include <array>
#include <limits>

#include "gi_module/reference/integrator.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

constexpr std::uint32_t kPath = 0;

}  // namespace

void Integrator::diffuse_indirect(std::span<const SampleStart> starts, std::span<PathSample> results) const {
    PathLanes paths{};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (starts[i].first == nullptr) {
            continue;
        }
        const SurfaceHit& hit = starts[i].first->hit;
        const int lane = paths.count++;
        paths.key[lane] = starts[i].random.key();
        paths.index[lane] = starts[i].random.index();
        paths.sample[lane] = static_cast<int>(i);
        paths.throughput.set(lane, vec3(1));
        paths.position.set(lane, hit.position);
        paths.normal.set(lane, hit.normal);
        paths.offset[lane] = scene_.triangles()[hit.triangle].offset;
    }
    LightLanes lights{};
    if (!lights_.empty() && !lights_.several()) {
        for (int lane = 0; lane < kLanes; ++lane) {
            lights.set(lane, lights_.draw(0));
        }
    }
    leave_surfaces(paths, vertex_dimension(kPath, 0));
    const int limit = bounce_limit();
    for (int reflections = 1; paths.count > 0; ++reflections) {
        follow(paths, reflections, results);
        if (reflections > limit) {
            break;
        }
        const std::uint32_t dimension = vertex_dimension(kPath, reflections);
        leave_surfaces(paths, dimension);
        gather_lights(paths, dimension, lights, results);
        if (reflections == limit && emitters_.empty()) {
            break;
        }
        pass_surfaces(paths);
    }
    for (PathSample& result : results) {
        result.indirect *= kPi;
    }
}

void Integrator::follow(PathLanes& paths, int reflections, std::span<PathSample> results) const {
    if (reflections > 1) {
        end_by_chance(paths, reflections - 1);
    }
    std::array<RTCRayHit, kLanes> queries;
    const auto count = static_cast<std::size_t>(paths.count);
    for (int lane = 0; lane < paths.count; ++lane) {
        queries[static_cast<std::size_t>(lane)] =
            TraceScene::query(paths.start.at(lane), paths.direction.at(lane), 0,
                              std::numeric_limits<float>::infinity(), blended_);
    }
    scene_.intersect_all(std::span(queries).first(count));
    const bool ends = reflections > bounce_limit();
    int kept = 0;
    for (int lane = 0; lane < paths.count; ++lane) {
        SurfaceHit hit;
        if (!scene_.found(queries[static_cast<std::size_t>(lane)], hit)) {
            continue;
        }
        const vec3 direction = paths.direction.at(lane);
        const MaterialConstants& material = materials_[scene_.instances()[hit.instance].material];
        if (!hit.front && !material.double_sided) {
            scene_.prefer_front(paths.start.at(lane), direction, blended_, hit);
        }
        if (reflections > 1) {
            const vec3 emitted = emission(hit);
            if (!is_black(emitted)) {
                const Lambert lambert{vec3(0), paths.normal.at(lane)};
                const float other = emitters_.density(hit, hit.t, -glm::dot(hit.normal, direction));
                results[static_cast<std::size_t>(paths.sample[lane])].indirect +=
                    paths.throughput.at(lane) * emitted * power_heuristic(lambert.density(direction), other);
            }
        }
        if (ends || !reflects(hit)) {
            continue;
        }
        const vec3 albedo =
            materials_.diffuse_albedo(scene_.instances()[hit.instance], hit.primitive, hit.barycentric);
        if (is_black(albedo)) {
            continue;
        }
        paths.keep(lane, kept);
        paths.position.set(kept, hit.position);
        paths.normal.set(kept, hit.normal);
        paths.albedo.set(kept, albedo);
        paths.offset[kept] = scene_.triangles()[hit.triangle].offset;
        ++kept;
    }
    paths.count = kept;
}

void Integrator::end_by_chance(PathLanes& paths, int reflections) const {
    if (!settings_.unlimited || reflections < kRouletteFrom) {
        return;
    }
    int kept = 0;
    for (int lane = 0; lane < paths.count; ++lane) {
        const RandomNumbers random(paths.key[lane], paths.index[lane]);
        vec3 throughput = paths.throughput.at(lane);
        if (!survives(random, vertex_dimension(kPath, reflections), throughput, reflections)) {
            continue;
        }
        paths.keep(lane, kept);
        paths.throughput.set(kept, throughput);
        paths.normal.set(kept, paths.normal.at(lane));
        paths.start.set(kept, paths.start.at(lane));
        paths.direction.set(kept, paths.direction.at(lane));
        ++kept;
    }
    paths.count = kept;
}

void Integrator::gather_lights(const PathLanes& paths, std::uint32_t dimension, LightLanes& lights,
                               std::span<PathSample> results) const {
    Lanes<float> light_choice{};
    EmitterLanes drawn;
    if (lights_.several() || emitters_.many()) {
        draw_pairs(paths, dimension + kChoices, light_choice, drawn.choice);
    }
    ShadowLanes shadows[2];
    if (!lights_.empty()) {
        if (lights_.several()) {
            for (int lane = 0; lane < paths.count; ++lane) {
                lights.set(lane, lights_.draw(light_choice[lane]));
            }
        }
        light_surfaces(paths, lights, shadows[0]);
    }
    if (!emitters_.empty()) {
        draw_pairs(paths, dimension + kEmitter, drawn.u, drawn.v);
        for (int lane = 0; lane < paths.count; ++lane) {
            vec2 u(drawn.u[lane], drawn.v[lane]);
            const EmitterTriangle& triangle = emitters_.draw_triangle(drawn.choice[lane], u);
            drawn.u[lane] = u.x;
            drawn.set(lane, triangle);
            if (!triangle.uniform) {
                const vec3 b = triangle_point(u);
                drawn.radiance.set(lane, emitters_.radiance(triangle, {b.y, b.z}));
            }
        }
        light_surfaces(paths, drawn, shadows[1]);
    }
    // The lights' rays, then the emitters', of each path.
    std::array<RTCRay, std::size_t{2} * kLanes> rays;
    std::array<vec3, std::size_t{2} * kLanes> carried;
    std::array<int, std::size_t{2} * kLanes> lanes;
    std::size_t count = 0;
    const auto look = [&](int lane, const ShadowLanes& shadow, bool to_infinity) {
        carried[count] = shadow.light.at(lane);
        lanes[count] = lane;
        rays[count] =
            TraceScene::shadow_ray(paths.start.at(lane), shadow.span.at(lane), to_infinity, blended_);
        count += is_black(carried[count]) ? 0 : 1;
    };
    for (int lane = 0; lane < paths.count; ++lane) {
        if (!lights_.empty()) {
            look(lane, shadows[0], lights.infinite[lane] != 0);
        }
        if (!emitters_.empty()) {
            look(lane, shadows[1], false);
        }
    }
    scene_.occlude_all(std::span(rays).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 seen = TraceScene::is_occluded(rays[i]) ? vec3(0) : carried[i];
        results[static_cast<std::size_t>(paths.sample[lanes[i]])].indirect +=
            paths.throughput.at(lanes[i]) * seen;
    }
}

}  // namespace lanthorn::reference
