// The code of CONTRIBUTING.md: a component, a system, an event and a plugin. style.docs compares the page
// with this file.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {
namespace {

using ecs::field;

struct Spin {
    double speed = 1;  // radians a second, about the node's +Y
    double angle = 0;  // radians so far
};

void declare_spin(ecs::Registry& registry) {
    registry.component<Spin>(
        "spin", "turns about its node's +Y",
        field("speed", &Spin::speed).unit("rad/s").range(-10, 10).words("how fast"),
        field("angle", &Spin::angle).unit("rad").runtime().words("how far it has turned"));
}

void turn(ecs::Query<ecs::Write<Spin>, ecs::Write<LocalTransform>> things) {
    things.each([](Spin& spin, LocalTransform& local) {
        spin.angle += spin.speed * kStepSeconds;
        local.value.rotation = glm::angleAxis(static_cast<float>(spin.angle), vec3(0, 1, 0));
    });
}

struct FullTurn {
    ecs::Entity thing;
};

void announce(ecs::Query<ecs::Read<Spin>> things, ecs::EventWriter<FullTurn> turns) {
    things.each([&](ecs::Entity thing, const Spin& spin) {
        if (std::fmod(spin.angle, 2 * std::numbers::pi) < spin.speed * kStepSeconds) {
            turns.send({thing});
        }
    });
}

struct TurnCount {
    int turns = 0;
};

void count_turns(ecs::EventReader<FullTurn> turns, ecs::ResMut<TurnCount> count) {
    turns.each([&](const FullTurn&) { ++count->turns; });
}

class SpinPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "spin"; }
    void build(App& app) override {
        declare_spin(app.registry());
        app.fixed_schedule().add("turn", turn).in("gameplay");
    }
};

TEST(Contributing, ASpinTurnsItsNodeByItsSpeed) {
    App app;
    add_scene_plugins(app);
    app.add<SpinPlugin>();
    const ecs::Entity e = app.world().create(LocalTransform{}, Spin{2, 0});
    for (int step = 0; step < 30; ++step) {
        app.step();
    }
    EXPECT_NEAR(app.world().get<Spin>(e).angle, 30 * 2 * kStepSeconds, 1e-12);
    const quat expected = glm::angleAxis(1.0f, vec3(0, 1, 0));
    EXPECT_GT(glm::dot(app.world().get<LocalTransform>(e).value.rotation, expected), 1 - 1e-6f);
    EXPECT_NE(app.registry().find("spin"), nullptr);
}

TEST(Contributing, AFullTurnIsAnnouncedOnce) {
    App app;
    add_scene_plugins(app);
    app.add<SpinPlugin>();
    app.world().insert_resource(TurnCount());
    app.fixed_schedule().add("announce", announce).after("turn").in("gameplay");
    app.fixed_schedule().add("count_turns", count_turns);
    app.world().create(LocalTransform{}, Spin{3, 0});
    for (int step = 0; step < 60 * 8; ++step) {
        app.frame(kStepSeconds);
    }
    EXPECT_EQ(app.world().resource<TurnCount>().turns, 3) << "8 s at 3 rad/s are 3.8 turns";
}

}  // namespace
}  // namespace lanthorn
