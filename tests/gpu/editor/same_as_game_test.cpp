// The editor's picture is the game's: the same passes, bit for bit, from the bytes that it would save.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/workbench/all_settings.h"
#include "tests/support/repository.h"
#include "tests/unit/editor/random_commands.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/same_as_game.h"

namespace lanthorn::editor {
namespace {

using testing_tools::Dice;

class Pictures : public testing::TestWithParam<const char*> {
  protected:
    Pictures() : settings((workbench::declare_all_settings(schema), schema)) {
        settings.set_from_text("gi.technique", "emc");
        settings.apply_preset("low");
    }
    static SessionOptions with_game() {
        SessionOptions options;
        options.view.declare = game::declare_components;
        return options;
    }
    SettingsSchema schema;
    Settings settings;
};

// Of each level; LANTHORN_EDITED_POSES=200 is the long run that docs/editor.md tells of.
int poses_of_a_level() {
    const char* text = std::getenv("LANTHORN_EDITED_POSES");
    return text == nullptr ? 1 : std::atoi(text);
}

// Anywhere near where the file's camera stands, looking anywhere.
workbench::CameraPose any_pose(workbench::CameraPose pose, Dice& dice) {
    pose.at += dvec3(dice.between(-1.5, 1.5), dice.between(-0.5, 0.5), dice.between(-1.5, 1.5));
    pose.yaw += dice.between(-180, 180);
    pose.pitch = dice.between(-35, 35);
    return pose;
}

TEST_P(Pictures, AreTheGamesAfterRandomEdits) {
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    EditSession session(with_game());
    const int poses = poses_of_a_level();
    ASSERT_GT(poses, 0) << "LANTHORN_EDITED_POSES: expected a number of poses";
    for (int i = 0; i < poses; ++i) {
        session.open(support::repository_file(GetParam()));
        Dice dice(3 + 1000u * static_cast<std::uint64_t>(i));
        for (int edits = 0; edits < 50;) {
            try {
                session.run(testing_tools::random_command(session.model(), dice));
                ++edits;
            } catch (const InputError&) {
                continue;
            }
        }
        for (std::size_t undone = dice.below(10); undone-- > 0;) {
            session.undo();
        }
        session.set_pose(any_pose(session.file_pose(), dice));
        const SameAsGame result = same_as_game(session, settings, {{96, 64}, 2});
        EXPECT_TRUE(result.same()) << GetParam() << ", pose " << i << ": " << result.first_difference
                                   << " differs";
        if ((i + 1) % 10 == 0) {
            std::printf("%s: %d poses\n", GetParam(), i + 1);
            std::fflush(stdout);
        }
        if (i == 0) {  // What was drawn before leaves nothing behind.
            context->make_current();
            EXPECT_EQ(editor_frames(session, settings, {{96, 64}, 2}), result.editor);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, Pictures,
                         testing::Values("assets/levels/red-wall.glb", "assets/levels/shutter.glb",
                                         "assets/levels/green-screen.glb", "assets/levels/two-glasses.glb",
                                         "assets/levels/pool.glb", "assets/levels/mirrors.glb",
                                         "assets/levels/burning-glass.glb", "assets/levels/lamp-bearer.glb",
                                         "assets/levels/other-light.glb"),
                         [](const auto& info) { return "Level" + std::to_string(info.index); });

// A difference is found, and named: the game does not see what is only previewed.
TEST_F(Pictures, ThatDifferAreNamed) {
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    EditSession session(with_game());
    session.new_room();
    session.begin("drag");
    const std::string brighter = "set /room/lamp light.intensity 500";
    session.preview(std::span(&brighter, 1));
    EXPECT_EQ(same_as_game(session, settings, {{64, 48}, 2}).first_difference, "direct");
    const std::string aside = "move /room/floor 0 1 0";
    session.preview(std::span(&aside, 1));
    EXPECT_EQ(same_as_game(session, settings, {{64, 48}, 2}).first_difference, "gbuffer");
    session.cancel();
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
}

// Without a light of its own: one is lent to both.
TEST_F(Pictures, OfALentLight) {
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    EditSession session(with_game());
    session.new_room();
    session.run("delete /room/lamp");
    EXPECT_EQ(session.guests().size(), 2u);  // seen from outside it is a clear day: a sky, and its sun
    session.run("move \"/room/west wall\" -1 0 0");
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
    // Adopted, sky and sun are the file's: one step, and no other picture but for the sky's last bits.
    const auto sky = [&] {
        editor_frames(session, settings, {{64, 48}, 2});
        return session.world().resource<FrameScene>().sky;
    };
    const std::optional<SkyInstance> lent = sky();
    session.run("adopt");
    EXPECT_TRUE(session.guests().empty());
    EXPECT_EQ(session.steps().position(), 1u + 2u);
    const std::optional<SkyInstance> own = sky();
    ASSERT_TRUE(lent && own);
    ASSERT_EQ(own->sky.image->radiance.size(), lent->sky.image->radiance.size());
    EXPECT_NEAR(own->sky.intensity, 1, 1e-4);
    for (std::size_t i = 0; i < own->sky.image->radiance.size(); ++i) {
        const vec3 &a = own->sky.image->radiance[i], &b = lent->sky.image->radiance[i];
        ASSERT_LT(glm::length(a - b), 1e-3f * glm::length(b)) << i;
    }
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
    // It stays about its sun, and goes with it.
    session.run("rotate /sun -10 80 0");
    const std::optional<SkyInstance> turned = sky();
    ASSERT_TRUE(turned);
    EXPECT_NE(turned->sky.image, own->sky.image);
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
    session.undo();
    session.undo();
    EXPECT_EQ(session.guests().size(), 2u);
}

// A sun of the file's own under the open sky is lent a sky, which can be adopted too.
TEST_F(Pictures, OfASkyThatIsLentToASun) {
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    EditSession session(with_game());
    session.new_room();
    session.run("delete /room/lamp");
    session.run("add-light / sun directional 0 2 0");
    session.run("rotate /sun -50 20 0");
    EXPECT_EQ(session.guests().size(), 1u);
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
    session.run("rotate /sun -20 70 0");
    EXPECT_EQ(session.guests().size(), 1u);
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
    session.run("adopt");
    EXPECT_TRUE(session.guests().empty());
    EXPECT_NE(session.document().json_text().find("clear_sky"), std::string::npos);
    EXPECT_TRUE(same_as_game(session, settings, {{64, 48}, 2}).same());
}

// The line that is copied gives the picture that is shown.
TEST_F(Pictures, AreThoseOfTheRenderLine) {
    const testing_tools::TemporaryFolder folder;
    std::ofstream(folder.path("a.edits"))
        << "new-room\nmove /room/lamp 1 2 -0.3\n"
        << "pose 1.1,1.25,0.7,33.3,-7.123456789,71\nsave " << folder.path("room.glb") << "\npicture "
        << folder.path("shown.png") << " 80x50 3\nprint render-line 80x50 3\n";
    const testing_tools::Outcome edited = testing_tools::run_program(
        LANTHORN_BINARY, {"edit", "--preset", "low", "--script", folder.path("a.edits")});
    ASSERT_EQ(edited.code, 0) << edited.err;
    std::vector<std::string> words = words_of(edited.out);
    ASSERT_GT(words.size(), 4u);
    EXPECT_EQ(words[0], "lanthorn");
    words.erase(words.begin());
    words.back() = folder.path("rendered.png");  // behind -o
    const testing_tools::Outcome outcome = testing_tools::run_program(LANTHORN_BINARY, words);
    ASSERT_EQ(outcome.code, 0) << edited.out << "\n" << outcome.err;
    const ImageF shown = read_image(folder.path("shown.png")),
                 rendered = read_image(folder.path("rendered.png"));
    EXPECT_TRUE(shown.pixels == rendered.pixels) << edited.out;  // metadata may differ
}

}  // namespace
}  // namespace lanthorn::editor
