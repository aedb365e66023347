// Crystals that light wakes.
#include <algorithm>
#include <cmath>

#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::game {

namespace {

constexpr double kGlowSeconds = 1.2;  // from dark to all its glow
constexpr double kWaking = 0.25;      // of its glow, at most, while it is not awake yet
constexpr double kSteps = 16;         // that its light is altered in: every one costs shadows and photons

double shown(const Crystal& crystal) {
    return std::round(kSteps * crystal.glowing) / kSteps;
}

float brightest(const Material& material) {
    const vec4& colour = material.base_colour;
    return std::max({colour.r, colour.g, colour.b});
}

void shine(const Crystal& crystal, Commands& commands) {
    if (!crystal.lamp) {
        return;
    }
    const double share = shown(crystal);
    if (share > 0) {
        Light light = crystal.light;
        light.intensity *= static_cast<float>(share);
        commands.insert(crystal.lamp, LightComponent{light});
    } else {
        commands.remove<LightComponent>(crystal.lamp);
    }
}

}  // namespace

void wake_crystals(Query<Read<LightSensor>, Mut<Crystal>> crystals, Commands& commands) {
    crystals.each([&](const LightSensor& sensor, ecs::MutRef<Crystal> state) {
        const bool lit = sensor.readings > 0 && static_cast<double>(sensor.lux) >= state->lux;
        const double step = state->seconds > 0 ? kStepSeconds / state->seconds : 1;
        const double charge = state->awake ? 1 : std::clamp(state->charge + (lit ? step : -step), 0.0, 1.0);
        const bool awake = charge >= 1;
        const double target = awake ? 1 : kWaking * charge;
        constexpr double kMost = kStepSeconds / kGlowSeconds;
        const double glowing = state->glowing + std::clamp(target - state->glowing, -kMost, kMost);
        if (charge == state->charge && awake == state->awake && glowing == state->glowing) {
            return;
        }
        Crystal& crystal = state.write();
        const double before = shown(crystal);
        crystal.charge = charge;
        crystal.awake = awake;
        crystal.glowing = glowing;
        if (shown(crystal) != before) {
            shine(crystal, commands);
        }
    });
}

void show_glow(Query<Read<Crystal>, Read<MeshInstances>> crystals, ResMut<AssetStore> store) {
    crystals.each([&](const Crystal& crystal, const MeshInstances& looks) {
        if (crystal.glow == vec3(0) || looks.meshes.empty()) {
            return;
        }
        const float first = brightest(store->get(store->material_of(looks.meshes.front())));
        for (const MeshHandle mesh : looks.meshes) {
            const MaterialHandle material = store->material_of(mesh);
            const float share = first > 0 ? brightest(store->get(material)) / first : 1;
            const vec3 emissive = crystal.glow * (share * static_cast<float>(shown(crystal)));
            if (store->get(material).emissive != emissive) {
                store->edit_material(material, [&](Material& m) { m.emissive = emissive; });
            }
        }
    });
}

}  // namespace lanthorn::game
