#include "lanthorn/gi/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/scene/emissive_pieces.h"
#include "gi_module/carried_light.h"

namespace lanthorn::gi {

namespace {

// A bound on what the scene's surfaces reflect of even light, over the materials in use.
float largest_albedo(const FrameScene& scene) {
    float largest = 0;
    for (const Instance& instance : scene.instances) {
        const Material& m = scene.material(instance);
        largest = m.unlit ? largest : std::max(largest, albedo_of(m));
    }
    return largest;
}

// Whether light leaves any surface otherwise than diffusely: metal, or what is transparent.
bool any_mirror(const FrameScene& scene) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Material& m = scene.material(instance);
        const vec3 base(m.base_colour);
        return !m.unlit && m.alpha_mode != AlphaMode::blend && std::max({base.x, base.y, base.z}) > 0 &&
               (m.metallic > 0 || m.transmission > 0);
    });
}

bool any_lamp(const FrameScene& scene) {
    const bool punctual = std::ranges::any_of(scene.lights, [](const LightInstance& l) {
        return l.light.intensity > 0 && std::max({l.light.colour.x, l.light.colour.y, l.light.colour.z}) > 0;
    });
    return punctual || std::ranges::any_of(scene.instances, [&](const Instance& instance) {
               return gives_light(scene.material(instance));
           });
}

}  // namespace

bool GiPlan::on(std::string_view pass) const {
    return std::ranges::any_of(entries, [&](const PlanEntry& e) { return e.pass == pass && e.on; });
}

std::string plan_table(const GiPlan& plan) {
    std::string text;
    for (const PlanEntry& e : plan.entries) {
        text += fmt::format("{:<20} {:<4} {:<40} {}\n", e.pass, e.on ? "on" : "off", e.size, e.why);
    }
    return text;
}

std::string plan_json(const GiPlan& plan) {
    nlohmann::json list = nlohmann::json::array();
    for (const PlanEntry& e : plan.entries) {
        list.push_back({{"pass", e.pass}, {"on", e.on}, {"size", e.size}, {"why", e.why}});
    }
    return list.dump();
}

LightBounds light_bounds(const FrameScene& scene) {
    if (scene.instances.empty()) {
        return {Unlit::no_geometry, 0, false, {}};
    }
    const float albedo = largest_albedo(scene);
    const bool lamps = any_lamp(scene);
    if (!lamps && !scene.sky) {
        return {Unlit::no_light, albedo, lamps, {}};
    }
    if (!(albedo > 0) && !any_mirror(scene)) {
        return {Unlit::nothing_reflects, albedo, lamps, {}};
    }
    return {Unlit::no, albedo, lamps, carried_light(scene, albedo)};
}

std::string_view words(Unlit unlit) {
    switch (unlit) {
        case Unlit::no_geometry:
            return "the scene has no geometry: nothing reflects light";
        case Unlit::no_light:
            return "the scene has no light: nothing to reflect";
        case Unlit::nothing_reflects:
            return "no surface reflects light: every photon would end at its first hit";
        case Unlit::no:
            break;
    }
    return "the scene has indirect light";
}

int useful_bounces(const CarriedLight& carried, int limit, int before) {
    // Below 1/500 light is under the image's own noise.
    constexpr float kNegligible = 1.0f / 500.0f;
    int bounces = 1;
    while (bounces < limit && bounces < static_cast<int>(carried.size())) {
        const float least = bounces < before ? 0.5f * kNegligible : kNegligible;
        if (!(carried[static_cast<std::size_t>(bounces)] > least)) {
            break;
        }
        ++bounces;
    }
    return bounces;
}

}  // namespace lanthorn::gi
