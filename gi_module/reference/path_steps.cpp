// The integrator's paths in lanes, step by step. Rays are traced one by one and surfaces looked up one by
// one; all arithmetic in between is path_lanes.h's.
#include <array>
#include <limits>

#include "gi_module/reference/integrator.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

void Integrator::leave_out(std::vector<std::uint32_t> instances) {
    left_out_.assign(instances.empty() ? 0 : scene_.instances().size(), false);
    for (const std::uint32_t instance : instances) {
        left_out_[instance] = true;
    }
}

std::uint64_t Integrator::add_sky(const IrradianceStart& start, int number, vec3& result,
                                  PathListener* listener) const {
    const SkyLight::Sample sample = sky_.draw(start.random.pair(vertex_dimension(kIrradiancePath, 0) + kSky));
    const float density = glm::dot(start.normal, sample.direction) / kPi;  // of a ray that way
    if (!(density > 0) || is_black(sample.radiance)) {
        return 0;
    }
    const float weight = power_heuristic(sample.density, density);
    const vec3 from = start.position + start.normal * start.offset;
    const vec3 open = sample.radiance * (density / sample.density);
    const vec3 light =
        sample.radiance * (weight * density / sample.density) * transmittance(from, sample.direction, true);
    if (listener != nullptr) {
        const DrawnLight drawn{{LightKind::sky, 0}, from, sample.direction, true};
        is_black(light) ? listener->blocked(number, 0, drawn, open)
                        : listener->arrives(number, 0, drawn, light);
    }
    result += light;
    return 1;
}

std::uint64_t Integrator::irradiance(std::span<const IrradianceStart> starts, std::span<vec3> results,
                                     PathListener* listener) const {
    std::uint64_t rays = 0;
    for (std::size_t begin = 0; begin < starts.size(); begin += kLanes) {
        const std::size_t count = std::min(starts.size() - begin, std::size_t{kLanes});
        PathLanes paths{};
        std::array<Incoming, kLanes> in{};
        for (std::size_t i = 0; i < count; ++i) {
            const IrradianceStart& start = starts[begin + i];
            const int lane = paths.add(start.random, static_cast<int>(i));
            paths.position.set(lane, start.position);
            paths.normal.set(lane, start.normal);
            paths.offset[lane] = start.offset;
        }
        leave_surfaces(paths, vertex_dimension(kIrradiancePath, 0));
        if (listener != nullptr) {
            listener->begin(begin);
        }
        rays += incoming(paths, kIrradiancePath, in, listener);
        for (std::size_t i = 0; i < count; ++i) {
            vec3 light = in[i].reflected + in[i].sky;
            if (!sky_.empty()) {
                rays += add_sky(starts[begin + i], static_cast<int>(i), light, listener);
            }
            results[begin + i] = light * kPi;
        }
    }
    return rays;
}

std::uint64_t Integrator::incoming(PathLanes& paths, std::uint32_t path, std::span<Incoming> results,
                                   PathListener* listener) const {
    std::uint64_t rays = 0;
    const bool full = settings_.transport == Transport::full;
    LightLanes lights{};
    if (!lights_.empty() && !lights_.several()) {
        for (int lane = 0; lane < kLanes; ++lane) {
            lights.set(lane, lights_.draw(0));
        }
    }
    MaterialLanes materials;
    if (full) {
        materials = {};
    }
    const int limit = bounce_limit();
    for (int reflections = 1; paths.count > 0; ++reflections) {
        rays += static_cast<std::uint64_t>(paths.count);
        follow(paths, materials, path, reflections, results, listener);
        if (reflections > limit) {
            return rays;
        }
        const std::uint32_t dimension = vertex_dimension(path, reflections);
        rays += gather_lights(paths, materials, lights, path, reflections, results, listener);
        if (reflections == limit && emitters_.empty() && sky_.empty()) {
            return rays;
        }
        if (full) {
            leave_surfaces(paths, materials, dimension);
        } else {
            leave_surfaces(paths, dimension);
            pass_surfaces(paths);
        }
        end_paths(paths, dimension, reflections);
    }
    return rays;
}

void Integrator::follow(PathLanes& paths, MaterialLanes& materials, std::uint32_t path, int reflections,
                        std::span<Incoming> results, PathListener* listener) const {
    const bool full = settings_.transport == Transport::full;
    const bool without_caustics = full && !settings_.caustics && path == kIrradiancePath;
    // Nobody can draw what lies behind the boundary of a volume.
    const auto density_of = [&](int lane, const Flight& flight) {
        return flight.bent ? std::numeric_limits<float>::infinity() : paths.density[lane];
    };
    const auto escape = [&](int lane, const Flight& flight) {
        if (sky_.empty() || (without_caustics && makes_caustics(flight, nullptr))) {
            return;
        }
        const vec3 direction = flight.ray.direction;
        const vec3 light = flight.throughput * sky_.radiance(direction) *
                           power_heuristic(density_of(lane, flight), sky_.density(direction));
        Incoming& result = results[static_cast<std::size_t>(paths.sample[lane])];
        (reflections == 1 ? result.sky : result.reflected) += light;
        if (listener != nullptr && !is_black(light)) {
            listener->arrives(paths.sample[lane], reflections - 1,
                              {{LightKind::sky, 0}, flight.ray.origin, direction, true}, light);
        }
    };
    std::array<RTCRayHit, kLanes> queries;
    const bool one_by_one = looks_through() || volumes_;
    if (!one_by_one) {
        for (int lane = 0; lane < paths.count; ++lane) {
            queries[static_cast<std::size_t>(lane)] =
                TraceScene::query(paths.start.at(lane), paths.direction.at(lane), 0,
                                  std::numeric_limits<float>::infinity(), blended_);
        }
        scene_.intersect_all(std::span(queries).first(static_cast<std::size_t>(paths.count)));
    }
    int kept = 0;
    for (int lane = 0; lane < paths.count; ++lane) {
        Flight flight{
            {paths.start.at(lane), paths.direction.at(lane)}, paths.throughput.at(lane), paths.medium[lane]};
        const Ray& ray = flight.ray;
        SurfaceHit hit;
        float distance = 0;
        if (one_by_one) {
            const RandomNumbers random(paths.key[lane], paths.index[lane]);
            if (!next_surface(flight, random, vertex_dimension(path, reflections - 1), hit, distance)) {
                escape(lane, flight);
                continue;
            }
        } else if (!scene_.found(queries[static_cast<std::size_t>(lane)], hit)) {
            escape(lane, flight);
            continue;
        } else {
            if (!hit.front && !materials_[scene_.instances()[hit.instance].material].double_sided) {
                scene_.prefer_front(ray.origin, ray.direction, blended_, hit);
            }
            distance = hit.t;
        }
        if (without_caustics && makes_caustics(flight, &hit)) {
            continue;
        }
        const vec3 emitted = emission(hit);
        if (!is_black(emitted)) {
            const float other = emitters_.density(hit, distance, -glm::dot(hit.normal, ray.direction));
            Incoming& result = results[static_cast<std::size_t>(paths.sample[lane])];
            const vec3 weighed =
                flight.throughput * emitted * power_heuristic(density_of(lane, flight), other);
            if (reflections == 1 && !flight.bent) {
                result.emitted = flight.throughput * emitted;
                result.light_density = other;
            } else {
                result.reflected += weighed;
            }
            if (listener != nullptr) {
                listener->arrives(
                    paths.sample[lane], reflections - 1,
                    {{LightKind::emitter, hit.instance}, ray.origin, hit.position - ray.origin, false},
                    weighed);
            }
        }
        if (listener != nullptr) {
            listener->meets(paths.sample[lane], reflections, hit);
        }
        if (reflections > bounce_limit() || !reflects(hit)) {
            continue;
        }
        const TraceInstance& instance = scene_.instances()[hit.instance];
        if (full) {
            const MaterialConstants& constants = materials_[instance.material];
            materials.set(kept, material_at(hit), materials_.shading_normal(instance, hit), -ray.direction,
                          constants.sees_through && !constants.blend);
        } else {
            const vec3 albedo = materials_.reflectance(instance, hit.primitive, hit.barycentric);
            if (is_black(albedo)) {
                continue;
            }
            paths.albedo.set(kept, albedo);
        }
        paths.keep(lane, kept);
        paths.throughput.set(kept, flight.throughput);
        paths.medium[kept] = flight.medium;
        paths.position.set(kept, hit.position);
        paths.normal.set(kept, hit.normal);
        paths.offset[kept] = scene_.triangles()[hit.triangle].offset;
        ++kept;
    }
    paths.count = kept;
}

void Integrator::end_paths(PathLanes& paths, std::uint32_t dimension, int reflections) const {
    if (settings_.transport != Transport::full && !settings_.unlimited) {
        return;
    }
    int kept = 0;
    for (int lane = 0; lane < paths.count; ++lane) {
        const RandomNumbers random(paths.key[lane], paths.index[lane]);
        vec3 throughput = paths.throughput.at(lane);
        if (is_black(throughput) || !survives(random, dimension, throughput, reflections)) {
            continue;
        }
        paths.keep(lane, kept);
        paths.throughput.set(kept, throughput);
        paths.start.set(kept, paths.start.at(lane));
        paths.direction.set(kept, paths.direction.at(lane));
        paths.density[kept] = paths.density[lane];
        ++kept;
    }
    paths.count = kept;
}

// As emitters of no size, so far away that the way there is the same from everywhere.
void Integrator::draw_sky(const PathLanes& paths, std::uint32_t dimension, EmitterLanes& drawn) const {
    const float far = 1e3f * scene_.frame().diagonal();
    Lanes<float> u, v;
    draw_pairs(paths, dimension + kSky, u, v);
    for (int lane = 0; lane < paths.count; ++lane) {
        const SkyLight::Sample sample = sky_.draw({u[lane], v[lane]});
        EmitterTriangle point;
        point.corner = paths.position.at(lane) + sample.direction * far;
        point.normal = -sample.direction;
        point.radiance = sample.radiance;
        point.density = sample.density / (far * far);
        drawn.set(lane, point);
        drawn.u[lane] = drawn.v[lane] = 0;
    }
}

std::size_t Integrator::gather_lights(const PathLanes& paths, const MaterialLanes& materials,
                                      LightLanes& lights, std::uint32_t path, int reflections,
                                      std::span<Incoming> results, PathListener* listener) const {
    const std::uint32_t dimension = vertex_dimension(path, reflections);
    std::array<LightSource, std::size_t{3} * kLanes> sources;  // by lane: a light, an emitter, the sky
    const auto drawn_from = [&](int kind, int lane, LightKind what, std::uint32_t index) {
        sources[static_cast<std::size_t>(kind) * kLanes + static_cast<std::size_t>(lane)] = {what, index};
    };
    const bool full = settings_.transport == Transport::full;
    Lanes<float> light_choice{};
    EmitterLanes drawn;
    if (lights_.several() || emitters_.many()) {
        draw_pairs(paths, dimension + kChoices, light_choice, drawn.choice);
    }
    ShadowLanes shadows[3];
    if (!lights_.empty()) {
        if (lights_.several()) {
            for (int lane = 0; lane < paths.count; ++lane) {
                lights.set(lane, lights_.draw(light_choice[lane]));
            }
        }
        for (int lane = 0; lane < paths.count && listener != nullptr; ++lane) {
            drawn_from(0, lane, LightKind::punctual, lights_.draw(light_choice[lane]).index);
        }
        full ? light_surfaces(paths, materials, lights, shadows[0])
             : light_surfaces(paths, lights, shadows[0]);
    }
    if (!emitters_.empty()) {
        draw_pairs(paths, dimension + kEmitter, drawn.u, drawn.v);
        for (int lane = 0; lane < paths.count; ++lane) {
            vec2 u(drawn.u[lane], drawn.v[lane]);
            const EmitterTriangle& triangle = emitters_.draw_triangle(drawn.choice[lane], u);
            drawn.u[lane] = u.x;
            drawn.set(lane, triangle);
            drawn_from(1, lane, LightKind::emitter, triangle.instance);
            if (!triangle.uniform) {
                const vec3 b = triangle_point(u);
                drawn.radiance.set(lane, emitters_.radiance(triangle, {b.y, b.z}));
            }
        }
        full ? light_surfaces(paths, materials, drawn, shadows[1]) : light_surfaces(paths, drawn, shadows[1]);
    }
    if (!sky_.empty()) {
        draw_sky(paths, dimension, drawn);
        for (int lane = 0; lane < paths.count; ++lane) {
            drawn_from(2, lane, LightKind::sky, 0);
        }
        full ? light_surfaces(paths, materials, drawn, shadows[2]) : light_surfaces(paths, drawn, shadows[2]);
    }
    // The lights' rays, then the emitters', then the sky's, of each path.
    std::array<RTCRay, std::size_t{3} * kLanes> rays;
    std::array<vec3, std::size_t{3} * kLanes> carried;
    std::array<int, std::size_t{3} * kLanes> lanes;
    std::array<DrawnLight, std::size_t{3} * kLanes> told;  // written for a listener alone
    std::size_t count = 0;
    const auto look = [&](int lane, int kind, bool to_infinity) {
        const ShadowLanes& shadow = shadows[kind];
        const vec3 from = shadow.start.at(lane), span = shadow.span.at(lane);
        carried[count] = shadow.light.at(lane);
        lanes[count] = lane;
        if (listener != nullptr) {
            told[count] = {sources[static_cast<std::size_t>(kind) * kLanes + static_cast<std::size_t>(lane)],
                           from, span, to_infinity};
        }
        if (looks_through() && !is_black(carried[count])) {
            const vec3 open = carried[count];
            carried[count] *= transmittance(from, span, to_infinity);
            if (listener != nullptr && is_black(carried[count])) {
                listener->blocked(paths.sample[lane], reflections, told[count],
                                  paths.throughput.at(lane) * open);
            }
        }
        if (paths.medium[lane] != kAir) {
            carried[count] *= attenuation(
                paths.medium[lane], to_infinity ? std::numeric_limits<float>::infinity() : glm::length(span));
        }
        rays[count] = TraceScene::shadow_ray(from, span, to_infinity, blended_);
        count += is_black(carried[count]) ? 0 : 1;
    };
    for (int lane = 0; lane < paths.count; ++lane) {
        if (!lights_.empty()) {
            look(lane, 0, lights.infinite[lane] != 0);
        }
        if (!emitters_.empty()) {
            look(lane, 1, false);
        }
        if (!sky_.empty()) {
            look(lane, 2, true);
        }
    }
    if (!looks_through()) {
        scene_.occlude_all(std::span(rays).first(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 light = paths.throughput.at(lanes[i]) * carried[i];
        const bool open = looks_through() || !TraceScene::is_occluded(rays[i]);
        if (open) {
            results[static_cast<std::size_t>(paths.sample[lanes[i]])].reflected += light;
        }
        if (listener != nullptr) {
            const int sample = paths.sample[lanes[i]];
            open ? listener->arrives(sample, reflections, told[i], light)
                 : listener->blocked(sample, reflections, told[i], light);
        }
    }
    return count;
}

}  // namespace lanthorn::reference
