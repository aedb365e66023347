// A world and two schedules: steps, frames and what plugins may not do.
#include "lanthorn/runtime/app.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/runtime/scene_plugin.h"

namespace lanthorn {
namespace {

struct Counts {
    int steps = 0, frames = 0;
};

App& counting(App& app) {
    app.world().insert_resource(Counts{});
    app.fixed_schedule().add("count", [](ecs::ResMut<Counts> counts) { ++counts->steps; });
    app.frame_schedule().add("count", [](ecs::ResMut<Counts> counts) { ++counts->frames; });
    return app;
}

Counts counts(const App& app) {
    return app.world().resource<Counts>();
}

TEST(App, RunsTheStepsThatAFrameNeeds) {
    App app;
    counting(app);
    app.frame(0);
    EXPECT_EQ(counts(app).steps, 0);
    app.frame(1.0 / 120);
    EXPECT_EQ(counts(app).steps, 1);
    EXPECT_NEAR(app.time().blend, 0.5, 1e-12);
    app.frame(1.0 / 120);
    EXPECT_EQ(counts(app).steps, 1) << "its end is the frame";
    EXPECT_EQ(app.time().blend, 1);
    app.frame(2.25 / 60);
    EXPECT_EQ(counts(app).steps, 4);
    EXPECT_NEAR(app.time().blend, 0.25, 1e-9);
    EXPECT_NEAR(app.time().ahead(), 0.75 / 60, 1e-9);
    EXPECT_EQ(counts(app).frames, 4);
}

TEST(App, AThousandFramesAreAThousandSteps) {
    App app;
    counting(app);
    for (int i = 0; i < 1000; ++i) {
        app.frame(1.0 / 60);
        ASSERT_EQ(counts(app).steps, i + 1);
        ASSERT_EQ(app.time().blend, 1);
    }
}

TEST(App, SlowsDownWhereStepsCannotFollow) {
    App app;
    counting(app);
    app.frame(10, 3);
    EXPECT_EQ(counts(app).steps, 3);
    EXPECT_DOUBLE_EQ(app.time().moment, 3.0 / 60);
    app.frame(-1);
    EXPECT_EQ(counts(app).steps, 3) << "time does not run backwards";
}

TEST(App, StepsByHandAreShownAtTheirEnd) {
    App app;
    counting(app);
    app.step();
    app.step();
    EXPECT_EQ(counts(app).frames, 0);
    app.show();
    EXPECT_EQ(counts(app).frames, 1);
    EXPECT_DOUBLE_EQ(app.time().moment, 2.0 / 60);
}

TEST(App, SkipsWithoutSimulating) {
    App app;
    counting(app);
    app.skip_to(100);
    EXPECT_EQ(counts(app).steps, 0);
    EXPECT_EQ(app.time().steps, 6000u);
    app.show_at(100.5 / 60 * 60);
    EXPECT_EQ(counts(app).steps, 30);
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(App, RefusesInOneLine) {
    App app;
    counting(app);
    app.show_at(1);
    EXPECT_EQ(refusal([&] { app.show_at(0.5); }), "app: 0.5 s is asked for at 1 s, expected a later moment");
    app.add<ScenePlugin>();
    EXPECT_EQ(refusal([&] { app.add<ScenePlugin>(); }),
              "app: plugin 'scene' is added twice, expected it once");
}

TEST(App, NamesTheSystemThatLacksAResource) {
    App app;
    app.frame_schedule().add("count", [](ecs::ResMut<Counts> counts) { ++counts->frames; });
    EXPECT_EQ(refusal([&] { app.show(); }),
              "system 'count' needs a resource of type lanthorn::{anonymous}::Counts, but there is none");
}

}  // namespace
}  // namespace lanthorn
