// A stranger's first minute: a house without a light is opened, lit, looked into, saved and played. The
// window starts without a file, as `lanthorn edit` does; LANTHORN_MINUTE_PICTURES=FOLDER keeps what each
// second shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "game/rules/components.h"
#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/replay/content_hash.h"
#include "tests/gpu/editor_window/hand.h"
#include "tests/support/repository.h"

namespace lanthorn::edit_window {
namespace first_minute_test {

namespace fs = std::filesystem;

// A room of 6 x 3 x 4 m without a ceiling, a lamp or a sky, and a camera in it.
void write_house(const fs::path& file) {
    editor::EditSession scene;
    scene.new_room();
    scene.run("delete /room/lamp");
    scene.run("delete /room/ceiling");
    GltfDocument house = scene.document();
    const std::size_t eye = house.add_node("eye");
    Transform at;
    at.translation = dvec3(-2.3, 1.6, 1.2);
    at.rotation = glm::angleAxis(glm::radians(-75.0f), vec3(0, 1, 0));
    house.set_transform(eye, at);
    Camera lens;
    lens.y_fov = 1.1f;
    house.set_node_camera(eye, static_cast<std::uint32_t>(house.add_camera(lens)));
    house.write(file);
}

class FirstMinute : public WindowTest {
  protected:
    FirstMinute() : house_(folder_.path("house.glb")) {
        write_house(house_);
        bytes_ = testing_tools::file_bytes(house_);
        EditorOptions options;
        options.size = {960, 540};
        options.text_scale = 1;
        options.preset = "low";
        options.refine = false;
        options.session.view.declare = game::declare_components;
        options.session.recovery = folder_.path("recovery");
        options.recent = folder_.path("recent-scenes");
        options.levels = {support::repository_file("assets/levels/red-wall.glb")};
        options.play = [](const editor::EditSession& session, const Settings&, const fs::path& level, ivec2) {
            session.document().write(level);
            return std::vector<std::string>{"/bin/sh", "-c", "grep -q lamp \"$0\"", level.string()};
        };
        window_ = std::make_unique<EditorWindow>(std::move(options));
    }
    // What the screen shows by now, for people.
    void look(const std::string& name) {
        const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
        RecordProperty("at_" + name, std::to_string(seconds));
        if (const char* pictures = std::getenv("LANTHORN_MINUTE_PICTURES")) {
            window_->wake();
            window_->turn();
            const std::string file = (fs::path(pictures) / (name + ".png")).string();
            ASSERT_EQ(std::system(("import -window root '" + file + "'").c_str()), 0);
        }
    }
    // Add > Lamp: the third word of the toolbar, and what comes first below it.
    bool asks_for_a_lamp() {
        for (float x = 84; x < 140; x += 8) {
            hand("mousemove " + at({x, 14}) + " click 1");
            turns(4);
            hand("mousemove " + at({x + 10, 34}) + " click 1");
            turns(4);
            if (state().places == "lamp") {
                return true;
            }
            hand("key Escape");
            turns(4);
        }
        return false;
    }
    void turns(int count) {
        for (int i = 0; i < count; ++i) {
            window_->wake();
            window_->turn();
        }
    }
    vec2 of_picture(float x, float y) const {
        const Box& box = state().layout.picture;
        return {box.x + x * box.width, box.y + y * box.height};
    }
    bool warns_of(const std::string& kind) const {
        return std::ranges::any_of(state().warnings,
                                   [&](const editor::EditWarning& warning) { return warning.kind == kind; });
    }

    using Clock = std::chrono::steady_clock;
    Clock::time_point begun_ = Clock::now();
    fs::path house_;
    std::string bytes_;  // of the house before
};

TEST_F(FirstMinute, LightsAHouseAndSavesIt) {
    const editor::EditSession& session = state().session;
    ASSERT_TRUE(comes([&] { return state().figures.ui_frames > 2; }));
    EXPECT_EQ(state().sheet, Sheet::start);
    look("00-start");

    hand("key ctrl+o");
    ASSERT_TRUE(comes([&] { return state().sheet == Sheet::open; }));
    hand("mousemove 400 103 click 1 key ctrl+a");
    turns(4);
    hand("type --delay 2 '" + house_.string() + "'");
    turns(4);
    look("03-open");
    hand("key Return");
    ASSERT_TRUE(comes([&] { return session.is_open() && state().picture.frames() > 0; })) << state().problem;
    EXPECT_EQ(session.path(), house_);
    EXPECT_EQ(session.guests().size(), 2u);  // a clear day: its sky and its sun
    EXPECT_TRUE(warns_of("guest"));
    look("05-first-picture");

    ASSERT_TRUE(rests());
    hand("mousemove " + at(of_picture(0.6f, 0.8f)));
    ASSERT_TRUE(comes([&] { return state().lux_under_pointer.has_value(); }));
    EXPECT_GT(*state().lux_under_pointer, 100);  // by day
    look("10-lux");

    ASSERT_TRUE(asks_for_a_lamp());
    hand("mousemove " + at(of_picture(0.5f, 0.55f)) + " click 1");
    ASSERT_TRUE(comes([&] { return steps() == 1 && state().chosen.size() == 1; })) << state().problem;
    EXPECT_EQ(session.path_of(state().chosen.front()), "/lamp");
    EXPECT_TRUE(session.guests().empty());
    EXPECT_NE(state().toast.find("light of its own"), std::string::npos) << state().toast;
    const auto lamp = [&] { return session.model().node(session.node_at("/lamp")).local.translation; };
    const dvec3 put = lamp();
    const double off = std::min({3 - std::abs(put.x), 2 - std::abs(put.z), put.y});
    EXPECT_NEAR(off, 0.3, 1e-3);  // from the nearest surface
    ASSERT_TRUE(rests());
    look("15-lamp");

    drag_up(icon("lamp"));
    ASSERT_TRUE(comes([&] { return lamp().y > put.y && state().picture.facts().quality == Quality::drag; }));
    look("22-drag");
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 2; }));
    ASSERT_TRUE(rests());
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
    ASSERT_TRUE(comes([&] { return state().error && state().error_of_frame == state().picture.frames(); }));
    look("28-still");

    hand("key alt+8");
    ASSERT_TRUE(comes([&] { return state().error_shown; }));
    look("32-error");
    hand("key alt+8 key alt+6");
    ASSERT_TRUE(comes([&] { return !state().error_shown && state().picture.view() == "coverage"; }));
    ASSERT_TRUE(rests());
    look("36-coverage");
    hand("key alt+6");
    ASSERT_TRUE(comes([&] { return state().picture.view() == "final"; }));
    ASSERT_TRUE(rests());

    hand("mousemove " + at(of_picture(0.2f, 0.85f)) + " key i");
    ASSERT_TRUE(comes([&] { return state().why.has_value(); }));
    EXPECT_GE(state().why->answer.split.ways.size(), 1u);
    ASSERT_TRUE(rests());
    look("40-why");
    hand("key Escape");
    ASSERT_TRUE(comes([&] { return !state().why; }));

    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 1; }));
    EXPECT_NE(state().toast.find("undid: "), std::string::npos);
    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 0; }));
    EXPECT_EQ(session.guests().size(), 2u);  // lent again
    hand("key ctrl+y key ctrl+y");
    ASSERT_TRUE(comes([&] { return steps() == 2; }));
    look("48-redone");

    hand("key ctrl+s");
    ASSERT_TRUE(comes([&] { return state().sheet == Sheet::save && state().changes; }));
    EXPECT_LT(state().changes->changed_bytes, 400u);
    look("54-save");
    hand("key Return");
    ASSERT_TRUE(comes([&] { return !state().dirty && state().sheet == Sheet::none; }));
    // The steps as a script, on the file as it was, give the same bytes.
    const fs::path again = folder_.path("again.glb");
    std::ofstream(again, std::ios::binary) << bytes_;
    editor::EditSession replayed({session.view(), {}});
    replayed.open(again);
    for (const editor::EditStep& step : session.steps().steps()) {
        std::vector<std::string> lines;
        for (const editor::Command& command : step.commands) {
            lines.push_back(command.text);
        }
        replayed.run(step.text, lines);
    }
    replayed.save();
    EXPECT_EQ(replay::hash_file(house_.string()), replay::hash_file(again.string()));
    EXPECT_EQ(GltfDocument::open(house_).json_text().find("extras"), std::string::npos);

    const workbench::CameraPose pose = session.pose();
    hand("key F5");
    ASSERT_TRUE(comes([&] { return state().toast.find("back from playing") != std::string::npos; }))
        << state().toast << state().problem;
    EXPECT_EQ(session.pose(), pose);
    EXPECT_TRUE(session.can_undo());
    look("58-played");
}

}  // namespace first_minute_test
}  // namespace lanthorn::edit_window
