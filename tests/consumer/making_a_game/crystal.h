// A thing that light wakes. Component, rules and plugin.
#pragma once

#include <algorithm>

#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/system.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"

namespace mine {

using namespace lanthorn;

struct Crystal {
    double lux = 1;      // that are enough, through the sensor's filter
    double seconds = 1;  // of them that wake it
    vec3 glow{0};        // cd/m^2 of its surface, awake
    double charge = 0;   // 0 to 1: how much has come together
    bool awake = false;
};

inline void wake_crystals(ecs::Query<ecs::Read<LightSensor>, ecs::Mut<Crystal>> crystals) {
    crystals.each([](const LightSensor& sensor, ecs::MutRef<Crystal> state) {
        if (state->awake || sensor.readings == 0) {
            return;
        }
        const double step = state->seconds > 0 ? kStepSeconds / state->seconds : 1;
        const bool lit = static_cast<double>(sensor.lux) >= state->lux;
        Crystal& crystal = state.write();
        crystal.charge = std::clamp(crystal.charge + (lit ? step : -step), 0.0, 1.0);
        crystal.awake = crystal.charge == 1;
    });
}

// Materials are assets: who edits them takes the whole world, and runs alone.
inline void show_glow(ecs::World& world) {
    AssetStore& store = asset_store(world);
    world.query<ecs::Read<Crystal>, ecs::Read<MeshInstances>>().each(
        [&](const Crystal& crystal, const MeshInstances& looks) {
            const MaterialHandle gem = store.material_of(looks.meshes.front());
            if (crystal.awake && store.get(gem).emissive != crystal.glow) {
                store.edit_material(gem, [&](Material& m) { m.emissive = crystal.glow; });
            }
        });
}

class CrystalPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "crystals"; }
    void build(App& app) override {
        using ecs::field;
        app.registry().component<Crystal>(
            "crystal", "wakes once the light sensor beside it has read enough",
            field("lux", &Crystal::lux).unit("lux").range(0, 1e9).words("that are enough"),
            field("seconds", &Crystal::seconds).unit("s").range(0, 60).words("of them that wake it"),
            field("glow", &Crystal::glow).unit("cd/m^2").range(0, 1e9).words("of its surface, awake"),
            field("charge", &Crystal::charge).range(0, 1).words("how much has come together"),
            field("awake", &Crystal::awake));
        ecs::Schedule& fixed = app.fixed_schedule();
        fixed.add("wake_crystals", wake_crystals).after("sensors.read").in("gameplay");
        fixed.add("show_glow", show_glow).after("wake_crystals").in("gameplay");
    }
};

}  // namespace mine
