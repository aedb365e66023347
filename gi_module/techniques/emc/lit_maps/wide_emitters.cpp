#include "gi_module/techniques/emc/lit_maps/wide_emitters.h"

#include <algorithm>
#include <span>
#include <utility>

namespace lanthorn::gi {

namespace {

// Of the faces of the box around the surroundings: what is wider has light of its own that falls off within a
// room, and lies nearer to some walls than its samples are to each other.
constexpr double kWide = 0.1;

double faces(const Aabb& box) {
    const dvec3 size(box.upper - box.lower);
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

}  // namespace

bool WideEmitters::follow(const render::LightInputs& inputs, const EnvironmentMaps& maps) {
    const Aabb& around = maps.surroundings().empty() ? inputs.scene.bounds : maps.surroundings();
    const double least = kWide * faces(around);
    const auto lights = inputs.light_maps.light_data();
    const auto triangles = inputs.emissive.triangles();
    std::vector<std::uint32_t> ids, flags(triangles.size(), 0);
    any_ = false;
    for (const render::EmissiveTriangles::Surface& surface : inputs.emissive.surfaces()) {
        const auto own = triangles.subspan(surface.first, surface.count);
        double area = 0;
        for (const render::EmissiveTriangleData& t : own) {
            area += static_cast<double>(t.radiance.w);
        }
        const bool sampled = std::ranges::any_of(lights, [&](const render::LightData& light) {
            return light.type == render::kLightAreaSample && light.id == surface.instance_id;
        });
        if (sampled && area < least) {
            continue;
        }
        any_ = true;
        std::fill_n(flags.begin() + surface.first, surface.count, 1u);
        if (sampled) {
            ids.push_back(surface.instance_id);
        }
    }
    // A few points for many surfaces are for the picture alone.
    if (std::ranges::any_of(lights, [](const render::LightData& light) {
            return light.type == render::kLightAreaSample && light.id == render::kMergedSurfaces;
        })) {
        ids.push_back(render::kMergedSurfaces);
    }
    if (flags != flags_) {
        flags_ = std::move(flags);
        triangles_ = gpu::Buffer::from(flags_);
    }
    const bool others = ids != ids_;
    ids_ = std::move(ids);
    return others;
}

bool WideEmitters::clear() {
    any_ = false;
    return !std::exchange(ids_, {}).empty();
}

void WideEmitters::bind_other_lights(const render::LightMaps& light_maps) {
    if (ids_.empty()) {
        return;
    }
    std::vector<render::LightData> lights = light_maps.shining().lights;
    for (render::LightData& light : lights) {
        const bool wide =
            light.type == render::kLightAreaSample && std::ranges::find(ids_, light.id) != ids_.end();
        light.intensity = wide ? vec3(0) : light.intensity;
    }
    const std::size_t bytes = light_maps.shining_buffer().bytes();
    if (lights_.bytes() != bytes) {
        lights_ = gpu::Buffer(bytes);
    }
    lights_.write(0, std::span<const render::LightData>(lights));
    if (lights.size() <= render::kMaxUniformLights) {
        lights_.bind_uniform(render::kLightsBinding);
    } else {
        lights_.bind_storage(render::kLightsBinding);
    }
}

}  // namespace lanthorn::gi
