// A window with an App in it, on an X server of its own. xdotool presses its keys.
#include "lanthorn/shell/window.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::shell {
namespace {

enum class Act { jump, leave };
constexpr input::Action kActs[] = {{"jump", "jump", "J"}, {"leave", "leave", "L", input::Kind::menu}};

WindowOptions small(Loop loop = Loop::continuous) {
    return {
        .title = "shell", .size = {320, 180}, .vsync = false, .loop = loop, .actions = kActs, .frame_ms = 0};
}

void fill(App& app, Window& window) {
    add_scene_plugins(app);
    app.add<RenderPlugin>().add<WindowPlugin>(window);
    spawn(app.world(), import_gltf(support::repository_file("assets/cornell.glb")));
}

void press(const char* key) {
    ASSERT_EQ(std::system((std::string("xdotool key ") + key).c_str()), 0);
}

TEST(Window, ShowsTheAppAndHandsItsStepsWhatIsPressed) {
    Window window(small());
    App app;
    fill(app, window);
    int jumps = 0;
    app.fixed_schedule()
        .add("count", [&](ecs::Res<input::Step> step) { jumps += step->begins(Act::jump) ? 1 : 0; })
        .in("gameplay");

    ASSERT_TRUE(window.next_frame());
    EXPECT_EQ(window.seconds(), 0);
    window.draw(app, 1.0 / 60);
    const ImageF seen = window.read();
    ASSERT_EQ(ivec2(seen.width, seen.height), window.framebuffer_size());
    const ImageF picture = app.world().resource<Renderer>().frame->read(render::Aov::final);
    ASSERT_EQ(ivec2(picture.width, picture.height), ivec2(320, 180));
    double most = 0;
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            most = std::max(most, std::abs(static_cast<double>(seen.at(x, y, 1) - picture.at(x, y, 1))));
        }
    }
    EXPECT_LE(most, 0.51 / 255);  // eight bits
    window.draw(app, 1.0 / 60);
    EXPECT_EQ(jumps, 0);

    press("j");
    press("j");
    press("l");
    bool left = false;
    for (int frame = 0; frame < 1000 && !left; ++frame) {
        ASSERT_TRUE(window.next_frame());
        left = window.devices().asked(Act::leave);
        window.draw(app, 4.0 / 60);
    }
    EXPECT_TRUE(left);
    EXPECT_EQ(jumps, 2);
    window.close();
    EXPECT_FALSE(window.next_frame());
}

TEST(Window, WhatDoesNotPlayGetsNoKeys) {
    Window window(small());
    App app;
    fill(app, window);
    bool jumped = false;
    app.fixed_schedule()
        .add("watch", [&](ecs::Res<input::Step> step) { jumped = jumped || step->is_down(Act::jump); })
        .in("gameplay");
    window.set_playing(false);
    ASSERT_TRUE(window.next_frame());
    press("j");
    press("l");
    bool asked = false;
    for (int frame = 0; frame < 1000 && !asked; ++frame) {
        ASSERT_TRUE(window.next_frame());
        asked = window.devices().asked(Act::leave);
        window.draw(app, 1.0 / 60);
    }
    EXPECT_TRUE(asked);
    EXPECT_FALSE(jumped);
}

// The frame after the last event is the one in which the next key is pressed, however long that takes.
TEST(Window, OnEventsItWaitsUntilAFrameIsAskedForOrAKeyIsPressed) {
    Window window(small(Loop::on_events));
    ASSERT_TRUE(window.next_frame());  // the first is due
    press("j");
    bool settled = false;
    for (int frame = 0; frame < 100 && !settled; ++frame) {
        ASSERT_TRUE(window.next_frame());
        for (const input::Event& event : window.devices().controls().events()) {
            settled = settled || !event.down;
        }
    }
    ASSERT_TRUE(settled);
    window.request_frame();
    ASSERT_TRUE(window.next_frame());

    const std::jthread later([] { press("l"); });
    int frames = 0;
    do {
        ASSERT_TRUE(window.next_frame());
        ++frames;
    } while (!window.devices().asked(Act::leave) && frames < 1000);
    EXPECT_LE(frames, 3);
}

TEST(Window, FollowsTheBudgetBySizeAndTellsThePreset) {
    WindowOptions options = small();
    options.frame_ms = 1e-3;  // nothing keeps that
    options.preset = "medium";
    Window window(options);
    App app;
    fill(app, window);
    std::vector<std::string> told;
    window.on_spending([&](const Spending& spending) { told.push_back(spending.preset); });
    for (int frame = 0; frame < 60; ++frame) {
        ASSERT_TRUE(window.next_frame());
        window.draw(app, 1.0 / 60);
    }
    ASSERT_GE(told.size(), 2u);
    EXPECT_EQ(told.front(), "medium");
    EXPECT_EQ(told.back(), "low");
    EXPECT_LT(window.picture_size().x, 200);
    EXPECT_EQ(app.view().size, window.picture_size());
}

TEST(Window, APictureThatStandsStillSpendsWhatItMay) {
    WindowOptions options = small();
    options.frame_ms = 1e-3;
    Window window(options);
    App app;
    fill(app, window);
    for (int frame = 0; frame < 60; ++frame) {
        ASSERT_TRUE(window.next_frame());
        window.draw(app, 0);
    }
    EXPECT_EQ(window.spending().scale, 1);
    EXPECT_EQ(app.time().steps, 0u);
}

TEST(Window, OnACpuThePictureIsNoLargerThanUsual) {
    WindowOptions options = small();
    options.size = {1200, 900};
    Window window(options);
    ASSERT_TRUE(window.info().software);
    const ivec2 size = window.picture_size();
    EXPECT_NEAR(static_cast<double>(size.x) * size.y, 640 * 360, 1000);
    EXPECT_NEAR(static_cast<double>(size.x) / size.y, 4.0 / 3, 0.01);
    // As many pixels as asked for, in the window's shape: nothing is stretched.
    window.set_picture_size({100, 50});
    EXPECT_EQ(window.picture_size(), ivec2(82, 61));
    window.set_picture_size({1, 1});
    EXPECT_EQ(window.picture_size(), ivec2(16, 16));
}

TEST(Window, KeepsScreenshotsUnderNamesOfTheirOwn) {
    const testing_tools::TemporaryFolder folder;
    ::setenv("XDG_DATA_HOME", folder.path("").c_str(), 1);
    Window window(small());
    ASSERT_TRUE(window.next_frame());
    window.clear({1, 0.5, 0});
    const std::filesystem::path first = window.keep_screenshot("shell test");
    const std::filesystem::path second = window.keep_screenshot("shell test");
    EXPECT_NE(first, second);
    const ImageF image = read_image(first);
    EXPECT_EQ(ivec2(image.width, image.height), window.framebuffer_size());
    EXPECT_NEAR(image.at(10, 10, 1), 0.5, 0.003);
    EXPECT_EQ(read_image(second).pixels, image.pixels);

    ::setenv("XDG_DATA_HOME", "/proc/none", 1);
    EXPECT_THROW(window.keep_screenshot("shell test"), InputError);
    ::unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace lanthorn::shell
