// The editor as a person uses it: a mouse and a keyboard that xdotool moves, on an X server of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "game/rules/components.h"
#include "gi_module/techniques/path/path.h"
#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/core/error.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tests/gpu/editor_window/hand.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/text_changes.h"

namespace lanthorn::edit_window {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLamp = "/lantern/lantern-light";
const gi::TechniqueKind kPath = gi::add_path();  // beside emc, before any window asks which there are

class Hand : public WindowTest {
  protected:
    Hand() : Hand(false) {}
    // A small window: a picture of half the pixels takes half the time, and shows the same.
    explicit Hand(bool refines, ivec2 size = {640, 400}) {
        file_ = folder_.path("level.glb");
        fs::copy_file(support::repository_file("assets/levels/shutter.glb"), file_);
        EditorOptions options;
        options.scene = file_;
        options.size = size;
        options.preset = "low";
        options.refine = refines;
        options.session.view.declare = game::declare_components;
        options.session.recovery = folder_.path("recovery");
        // A game that looks at its level and ends.
        options.play = [](const editor::EditSession& session, const Settings&, const fs::path& level, ivec2) {
            session.document().write(level);
            return std::vector<std::string>{"/bin/sh", "-c", "grep -q lantern-light \"$0\"", level.string()};
        };
        // There the lamp has gone up by a metre.
        editor::EditSession scene({options.session.view, {}});
        scene.open(file_);
        const std::uint32_t lamp = scene.node_at(kLamp);
        PlayedScene played;
        played.before[lamp].to_world = played.after[lamp].to_world = scene.model().world_matrix(lamp);
        played.after[lamp].to_world[3].y += 1;
        // Somebody who finds a level solvable whose lamp has its name; or never comes to an end.
        options.solve = [this](const editor::EditSession& session, const fs::path& folder) {
            session.document().write(folder / "level.glb");
            return std::vector<std::string>{"/bin/sh", "-c",
                                            slow_ ? "sleep 60" : "grep -c lantern-light \"$0\" >\"$1\"",
                                            (folder / "level.glb").string(), (folder / "found").string()};
        };
        options.solve_found = [](const fs::path& folder) {
            SolveShown found;
            if (fs::exists(folder / "found")) {
                found.solved = true;
                found.words = "solved at step 3";
            }
            return found;
        };
        options.played = [played](const fs::path& level) {
            EXPECT_TRUE(fs::exists(level / "level.glb"));
            return played;
        };
        window_ = std::make_unique<EditorWindow>(std::move(options));
    }
    // Clicks from left to right, so many units below the drawer's upper edge, until that holds.
    bool click_along(float below, const std::function<bool()>& holds) {
        const Box box = state().layout.drawer;
        for (float x = box.x + 8; x < box.x + box.width; x += 22) {
            hand("mousemove " + at({x, state().layout.drawer.y + below}) + " click 1");
            for (int turns = 0; turns < 6; ++turns) {
                window_->wake();
                window_->turn();
                if (holds()) {
                    return true;
                }
            }
        }
        return false;
    }
    vec2 lamp() const { return icon("lantern-light"); }
    double height() const {
        return state().session.model().node(state().session.node_at(kLamp)).local.translation.y;
    }
    // Chooses the lamp and takes the arrow that points up.
    void take_the_lamp() {
        ASSERT_TRUE(rests());
        hand("mousemove " + at(lamp()) + " click 1");
        ASSERT_TRUE(comes([&] { return state().chosen.size() == 1; }));
        ASSERT_EQ(state().session.path_of(state().chosen.front()), kLamp);
        ASSERT_TRUE(rests());
        drag_up(lamp());
    }

    fs::path file_;
    bool slow_ = false;
};

TEST_F(Hand, ClicksDragsUndoesAndSavesOneLamp) {
    const std::string before = GltfDocument::open(file_).json_text();
    ASSERT_TRUE(rests());
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
    const int frames = state().picture.frames();
    window_->wake();
    ASSERT_TRUE(window_->turn());
    EXPECT_EQ(state().picture.frames(), frames);  // what is still is not drawn again

    // Views by number, and back: no edit.
    const workbench::CameraPose view = state().session.pose();
    hand("key ctrl+2 key shift+f");
    ASSERT_TRUE(comes([&] { return !(state().session.pose() == view); }));
    const workbench::CameraPose all = state().session.pose();
    hand("key 2");
    ASSERT_TRUE(comes([&] { return state().session.pose() == view; }));
    hand("key alt+Left");
    ASSERT_TRUE(comes([&] { return state().session.pose() == all; }));
    hand("key alt+Left");
    ASSERT_TRUE(comes([&] { return state().session.pose() == view; }));
    EXPECT_FALSE(state().dirty);
    EXPECT_EQ(steps(), 0u);

    const double low = height();
    take_the_lamp();
    ASSERT_TRUE(comes([&] { return height() > low && state().picture.facts().quality == Quality::drag; }));
    EXPECT_GT(state().picture.facts().changed, 0);
    const auto texels = [&] {
        return state().session.world().resource<render::RenderSettings>().shadow_resolution;
    };
    const int chosen = state().settings.get<int>("render.shadow.resolution");
    EXPECT_EQ(texels(), chosen / 2);  // of lamps' maps
    EXPECT_EQ(steps(), 0u);           // a gesture is no step before it ends
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 1; }));
    ASSERT_TRUE(rests());
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
    EXPECT_EQ(texels(), chosen);
    EXPECT_TRUE(state().dirty);
    const double high = height();

    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 0; }));
    EXPECT_EQ(height(), low);
    EXPECT_NE(state().toast.find("undid: move lantern-light"), std::string::npos);
    hand("key ctrl+y");
    ASSERT_TRUE(comes([&] { return steps() == 1; }));
    EXPECT_EQ(height(), high);

    hand("key ctrl+s");
    ASSERT_TRUE(comes([&] { return state().sheet == Sheet::save && state().changes; }));
    EXPECT_EQ(state().changes->changed_lines, 1u);
    hand("key Return");
    ASSERT_TRUE(comes([&] { return !state().dirty && state().sheet == Sheet::none; }));
    // Binary files fill their JSON up with blanks.
    const auto text_of = [](std::string text) { return text.substr(0, text.find_last_not_of(' ') + 1); };
    const editor::TextChanges saved =
        editor::text_changes(text_of(before), text_of(GltfDocument::open(file_).json_text()));
    EXPECT_EQ(saved.changed_lines, 1u);
    ASSERT_FALSE(saved.lines.empty());
    EXPECT_NE(saved.lines.back().text.find("translation"), std::string::npos);
}

TEST_F(Hand, LetsGoOfADragByEscapeAndTypesANumberInstead) {
    const double low = height();
    take_the_lamp();
    ASSERT_TRUE(comes([&] { return height() > low; }));
    hand("key Escape mouseup 1");
    ASSERT_TRUE(comes([&] { return height() == low && !state().desk.gesture(); }));
    EXPECT_EQ(steps(), 0u);

    ASSERT_TRUE(rests());
    const vec2 arrow = lamp() - vec2(2, 55);
    hand("mousemove " + at(arrow) + " mousedown 1 mousemove " + at(arrow - vec2(0, 12)) +
         " key 2 key period key 5");
    ASSERT_TRUE(comes([&] { return std::abs(height() - low - 2.5) < 1e-5; })) << height();
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 1; }));
    EXPECT_NEAR(height(), low + 2.5, 1e-5);
}

TEST_F(Hand, AFileThatChangesOnDiskIsReadAgainAndABrokenOneIsNot) {
    ASSERT_TRUE(rests());
    const std::string good = testing_tools::file_bytes(file_);
    const std::size_t nodes = state().nodes;
    const auto put = [&](const std::string& bytes) {
        std::ofstream(file_.string() + ".new", std::ios::binary) << bytes;
        fs::rename(file_.string() + ".new", file_);
    };
    put(good.substr(0, good.size() / 2));
    ASSERT_TRUE(comes([&] { return !state().problem.empty(); }));
    EXPECT_NE(state().problem.find("the last good scene is kept"), std::string::npos) << state().problem;
    EXPECT_TRUE(state().session.is_open());
    EXPECT_EQ(state().nodes, nodes);
    GltfDocument other = GltfDocument::open(support::repository_file("assets/levels/shutter.glb"));
    other.add_node("added-elsewhere");
    put(other.glb_bytes());
    ASSERT_TRUE(comes([&] { return state().nodes == nodes + 1; }));
    EXPECT_TRUE(state().problem.empty());
}

// Key I over the wall: the card, its ways in the picture, the same place again after an edit, and gone by
// Esc.
TEST_F(Hand, AsksWhyTheLightIsThereAndHowWrongItIs) {
    ASSERT_TRUE(rests());
    const Box& box = state().layout.picture;
    const vec2 place(box.x + 0.5f * box.width, box.y + 0.5f * box.height);
    hand("mousemove " + at(place) + " key i");
    ASSERT_TRUE(comes([&] { return state().why.has_value(); }));
    EXPECT_EQ(state().drawer_tab, kWhyTab);
    EXPECT_TRUE(state().splits.drawer_open);
    const reference::LightSplit first = state().why->answer.split;
    EXPECT_GT(first.direct.value() + first.indirect().value(), 0);
    EXPECT_FALSE(first.lamps.empty());
    EXPECT_FALSE(first.ways.empty());
    EXPECT_GE(state().why->shown, 0);
    take_the_lamp();
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 1; }));
    ASSERT_TRUE(comes([&] { return state().why && state().why->version == state().session.version(); }));
    EXPECT_NE(state().why->answer.split.direct.value(), first.direct.value());
    EXPECT_EQ(steps(), 1u);  // to ask is no edit
    ASSERT_TRUE(comes([&] { return state().error && state().error_of_frame == state().picture.frames(); }));
    EXPECT_GT(state().error->local + state().error->uncertainty, 0);
    EXPECT_GE(state().error->spp, 4);
    ASSERT_TRUE(comes([&] { return !state().gains.empty(); }));
    double shares = 0;
    for (const auto& [node, gain] : state().gains) {
        shares += gain.share;
    }
    EXPECT_NEAR(shares, 1, 1e-6);
    hand("mousemove " + at(place) + " key Escape");
    ASSERT_TRUE(comes([&] { return !state().why; }));
}

// Where the drawer's tabs and buttons all have room.
class HandAtTheDrawer : public Hand {
  protected:
    HandAtTheDrawer() : Hand(false, {800, 450}) {}
};

TEST_F(HandAtTheDrawer, ComparesWithAPictureThatWasKeptAndPlaysFromHere) {
    ASSERT_TRUE(rests());
    hand("key b");
    ASSERT_TRUE(comes([&] { return state().kept_picture() != nullptr; }));
    const Box& box = state().layout.picture;
    const vec2 middle(box.x + 0.5f * box.width, box.y + 0.6f * box.height);
    hand("mousemove " + at(middle) + " mousedown 1 mousemove " + at(middle - vec2(0.25f * box.width, 0)) +
         " mouseup 1");
    ASSERT_TRUE(comes([&] { return std::abs(state().divider - 0.25f) < 0.02f; })) << state().divider;
    EXPECT_TRUE(state().chosen.empty());  // the divider's drag chooses nothing
    hand("key b");
    ASSERT_TRUE(comes([&] { return !state().other_side; }));
    hand("key F5");
    ASSERT_TRUE(comes([&] { return state().toast.find("back from playing") != std::string::npos; }))
        << state().toast << state().problem;
    EXPECT_FALSE(state().playing);
    // What was changed there is offered, and not taken.
    ASSERT_TRUE(comes([&] { return state().played.size() == 1; }));
    EXPECT_FALSE(state().dirty);
    EXPECT_EQ(steps(), 0u);
    EXPECT_EQ(state().played.front().change.title, "lantern-light: 1 m away");
    const double low = height();
    ASSERT_TRUE(
        click_along(11, [&] { return state().splits.drawer_open && state().drawer_tab == kPlayedTab; }));
    ASSERT_TRUE(click_along(55, [&] { return state().played.front().keep; }));
    ASSERT_TRUE(click_along(33, [&] { return steps() == 1; }));
    EXPECT_NEAR(height(), low + 1, 1e-6);
    EXPECT_TRUE(state().played.empty());
    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 0; }));
    EXPECT_EQ(height(), low);
}

// Two techniques at once: each with its own milliseconds, A frozen under the hand, off without a trace, and a
// step of the history of views.
TEST_F(Hand, ComparesTwoTechniquesOfTheSameMoment) {
    ASSERT_TRUE(rests());
    EXPECT_EQ(state().picture.other_texture(), 0u);
    hand("key shift+b");
    ASSERT_TRUE(comes([&] { return state().picture.other_is_new(); }));
    ASSERT_TRUE(rests());
    const PictureFacts& a = state().picture.other_facts();
    const PictureFacts& b = state().picture.facts();
    EXPECT_EQ(a.technique, "none");  // this program has no coarse-path
    EXPECT_EQ(b.technique, "emc");
    EXPECT_EQ(a.size, b.size);
    EXPECT_GT(a.ms, 0);
    EXPECT_GT(b.ms, 0);
    EXPECT_EQ(steps(), 0u);
    EXPECT_FALSE(state().dirty);

    const int frames = state().picture.frames();
    const Box& box = state().layout.picture;
    const vec2 middle(box.x + 0.5f * box.width, box.y + 0.7f * box.height);
    hand("mousemove " + at(middle) + " mousedown 1 mousemove " + at(middle + vec2(0.2f * box.width, 0)) +
         " mouseup 1");
    ASSERT_TRUE(comes([&] { return std::abs(state().divider - 0.7f) < 0.02f; })) << state().divider;
    EXPECT_EQ(state().picture.frames(), frames);  // both pictures were there

    take_the_lamp();
    ASSERT_TRUE(comes([&] { return state().picture.facts().quality == Quality::drag; }));
    EXPECT_FALSE(state().picture.other_is_new());
    EXPECT_NE(state().picture.other_texture(), 0u);
    const Renderer& renderer = std::as_const(state().session.world()).resource<Renderer>();
    EXPECT_EQ(renderer.resting.size(), 1u);
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 1 && state().picture.other_is_new(); }));
    ASSERT_EQ(renderer.views.size(), 2u);
    EXPECT_FALSE(renderer.views[1]->restarted);  // A goes on
    EXPECT_EQ(renderer.views[1]->frame->exposure(), renderer.frame->exposure());
    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 0; }));

    hand("key shift+b");
    ASSERT_TRUE(comes([&] { return !state().other_side && state().picture.other_texture() == 0; }));
    hand("key alt+Left");
    ASSERT_TRUE(comes([&] { return state().other_side && state().other_side->as; }));
    hand("key alt+Right");
    ASSERT_TRUE(comes([&] { return !state().other_side; }));
    EXPECT_FALSE(state().dirty);
}

// A clip is how one looks, and the level is played in a process of its own.
TEST_F(Hand, PlaysAClipAndAsksWhetherTheLevelIsSolvable) {
    ASSERT_TRUE(rests());
    ASSERT_NE(state().timeline.shown(), nullptr);
    hand("key space");
    ASSERT_TRUE(comes([&] { return state().timeline.playing && state().session.moment() > 0; }));
    EXPECT_EQ(state().picture.facts().quality, Quality::drag);
    hand("key space");
    ASSERT_TRUE(comes([&] { return !state().timeline.playing; }));
    ASSERT_TRUE(rests());
    EXPECT_NEAR(state().session.moment(), state().timeline.second(), 1e-6);
    EXPECT_FALSE(state().dirty);

    hand("key shift+F5");
    ASSERT_TRUE(comes([&] { return state().solve.solved.has_value() && !state().solving; }))
        << state().problem;
    EXPECT_EQ(state().drawer_tab, kSolveTab);
    EXPECT_EQ(state().solve.words, "solved at step 3");
    slow_ = true;
    hand("key shift+F5");
    ASSERT_TRUE(comes([&] { return state().solving; }));
    hand("key shift+F5");
    ASSERT_TRUE(comes([&] { return !state().solving; }));
    EXPECT_FALSE(state().solve.solved);
    EXPECT_EQ(state().problem, "");
    EXPECT_EQ(steps(), 0u);
}

// Lux for a place of the wall, by a drag in the picture; solved as one step.
TEST_F(HandAtTheDrawer, WishesForLightAndSolvesThat) {
    ASSERT_TRUE(rests());
    ASSERT_TRUE(
        click_along(11, [&] { return state().splits.drawer_open && state().drawer_tab == kWishesTab; }));
    ASSERT_TRUE(click_along(33, [&] { return state().wishes.placing; }));
    ASSERT_TRUE(rests());
    const Box& box = state().layout.picture;
    const vec2 place(box.x + 0.5f * box.width, box.y + 0.6f * box.height);
    hand("mousemove " + at(place) + " mousedown 1 mousemove " + at(place + vec2(10, 0)) + " mousemove " +
         at(place + vec2(20, 0)) + " mouseup 1");
    ASSERT_TRUE(comes([&] { return state().wishes.rows.size() == 1 && state().wishes.rows[0].found; }));
    const WishRow row = state().wishes.rows.front();
    EXPECT_GT(row.wish.radius, 0.02);
    EXPECT_GT(row.found->places, 0);
    EXPECT_EQ(steps(), 0u);
    EXPECT_TRUE(state().chosen.empty());  // the drag chose nothing
    hand("key Escape");
    ASSERT_TRUE(comes([&] { return !state().wishes.placing; }));
    ASSERT_TRUE(click_along(33, [&] { return state().wishes.solve || steps() == 1; }));
    ASSERT_TRUE(comes([&] { return steps() == 1; })) << state().problem;
    EXPECT_NE(state().toast.find("1 of 1 wishes met"), std::string::npos) << state().toast;
    ASSERT_TRUE(comes([&] { return !state().wishes.old(state().session.version()); }));
    const editor::WishOutcome& now = *state().wishes.rows[0].found;  // traced once more
    EXPECT_NEAR(now.before, 100, 4 * std::hypot(row.found->noise * 100 / row.found->before, now.noise));
    hand("key ctrl+z");
    ASSERT_TRUE(comes([&] { return steps() == 0; }));
}

// The path tracer: how far it has come, an edit that begins it again, and out by Esc, by the button and by
// its key.
TEST_F(Hand, IsDrawnByThePathTracerAndComesBack) {
    ASSERT_EQ(gi::technique_entry(kPath).name, "path");
    ASSERT_TRUE(rests());
    EXPECT_FALSE(state().traced.grows());
    hand("key alt+9");
    ASSERT_TRUE(comes([&] { return state().traced.progress().done >= 9 && !state().pace.due(); }));
    EXPECT_EQ(state().picture.facts().technique, "path");
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
    EXPECT_EQ(state().traced.progress().wanted, 64);
    const double left = state().traced.seconds_left().value_or(0);
    EXPECT_GT(left, 0);
    const int done = state().traced.progress().done;
    ASSERT_TRUE(comes([&] { return state().traced.progress().done >= done + 3; }));  // it goes on
    EXPECT_FALSE(window_->asleep());

    hand("mousemove " + at(lamp()) + " click 1");
    ASSERT_TRUE(comes([&] { return state().chosen.size() == 1; }));
    EXPECT_GT(state().traced.progress().done, done);  // to choose is no edit
    drag_up(lamp());
    ASSERT_TRUE(comes([&] { return state().picture.facts().quality == Quality::drag; }));
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return steps() == 1 && state().picture.facts().quality == Quality::rest; }));
    EXPECT_LT(state().traced.progress().done, done);
    EXPECT_TRUE(state().traced.due());

    hand("key Escape");
    ASSERT_TRUE(comes([&] { return state().picture.facts().technique == "emc"; }));
    EXPECT_EQ(state().chosen.size(), 1u);  // the first Esc is about what is traced
    EXPECT_FALSE(state().traced.grows());
    EXPECT_EQ(steps(), 1u);

    hand("key alt+9");
    ASSERT_TRUE(comes([&] { return state().traced.due() && !state().cancel_button.empty(); }));
    const Box button = state().cancel_button;
    hand("mousemove " + at({button.x + button.width / 2, button.y + button.height / 2}) + " click 1");
    ASSERT_TRUE(comes([&] { return state().picture.facts().technique == "emc"; }));
    EXPECT_TRUE(state().cancel_button.empty());
    hand("key alt+9");
    ASSERT_TRUE(comes([&] { return state().traced.due(); }));
    hand("key alt+9");
    ASSERT_TRUE(comes([&] { return state().picture.facts().technique == "emc"; }));
    ASSERT_TRUE(rests());
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
}

class PatientHand : public Hand {
  protected:
    PatientHand() : Hand(true, {800, 450}) {}
};

// What is still is drawn on; a click is answered all the same, and a hand that moves something ends it.
TEST_F(PatientHand, SeesAStillPictureRefined) {
    ASSERT_TRUE(comes([&] { return state().refinement.begun(); }));
    EXPECT_EQ(state().picture.facts().quality, Quality::still);
    EXPECT_EQ(state().refinement.words().substr(0, 22), "refining: error about ");
    const int frames = state().picture.frames();
    ASSERT_TRUE(comes([&] { return state().picture.frames() > frames + 3; }));
    hand("mousemove " + at(lamp()) + " click 1");
    ASSERT_TRUE(comes([&] { return state().chosen.size() == 1; }));
    EXPECT_TRUE(state().refinement.begun());
    drag_up(lamp());
    ASSERT_TRUE(comes([&] { return state().picture.facts().quality == Quality::drag; }));
    EXPECT_EQ(state().refinement.words(), "");
    hand("mouseup 1");
    ASSERT_TRUE(comes([&] { return state().refinement.begun(); }));
}

TEST(EditorWithoutADisplay, SaysSoInOneLineAndEndsWith3) {
    const testing_tools::Outcome outcome =
        testing_tools::run_program(LANTHORN_BINARY, {"edit"}, {"DISPLAY=", "WAYLAND_DISPLAY="});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
}

}  // namespace
}  // namespace lanthorn::edit_window
