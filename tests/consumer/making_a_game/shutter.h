// A thing that can be used: a leaf that slides. Component, rule and plugin.
#pragma once

#include <algorithm>

#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/system.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/components.h"

namespace mine {

using namespace lanthorn;

// What the player does in this step (resource).
struct Hand {
    bool uses = false;
};

struct Shutter {
    dvec3 way{0, 1, 0};  // metres from where it is shut to where it is open
    double seconds = 1;  // that it takes
    double share = 0;    // of the way, 0 to 1
    bool open = false;   // where it is going
};

inline void slide_shutters(ecs::Res<Hand> hand,
                           ecs::Query<ecs::Mut<Shutter>, ecs::Mut<LocalTransform>> shutters) {
    shutters.each([&](ecs::MutRef<Shutter> state, ecs::MutRef<LocalTransform> local) {
        if (hand->uses) {
            state.write().open = !state->open;
        }
        const double most = kStepSeconds / state->seconds;
        const double step = std::clamp((state->open ? 1 : 0) - state->share, -most, most);
        if (step != 0) {
            state.write().share += step;
            local.write().value.translation += step * state->way;
        }
    });
}

class ShutterPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "shutters"; }
    void build(App& app) override {
        using ecs::field;
        app.registry().component<Shutter>(
            "shutter", "a leaf that slides",
            field("way", &Shutter::way).unit("m").words("to where it is open"),
            field("seconds", &Shutter::seconds).unit("s").more_than(0, 60).words("that it takes"),
            field("share", &Shutter::share).range(0, 1).runtime().words("of the way"),
            field("open", &Shutter::open).runtime().words("whether it is open, or on its way"));
        app.world().insert_resource(Hand());
        app.fixed_schedule().add("slide_shutters", slide_shutters).in("gameplay");
    }
};

}  // namespace mine
