// The editor's picture is the game's: the same passes, bit for bit, from the bytes that it would save.
#include <gtest/gtest.h>

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

TEST_P(Pictures, AreTheGamesAfterRandomEdits) {
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    EditSession session(with_game());
    session.open(support::repository_file(GetParam()));
    Dice dice(3);
    const workbench::CameraPose pose = session.pose();
    for (int edits = 0; edits < 50;) {
        try {
            session.run(testing_tools::random_command(session.model(), dice));
            ++edits;
        } catch (const InputError&) {
            continue;
        }
    }
    for (std::size_t i = dice.below(10); i-- > 0;) {
        session.undo();
    }
    workbench::CameraPose from = pose;
    from.at += dvec3(dice.between(-0.5, 0.5), dice.between(-0.3, 0.3), dice.between(-0.5, 0.5));
    from.yaw += dice.between(-40, 40);
    session.set_pose(from);
    const SameAsGame result = same_as_game(session, settings, {{96, 64}, 2});
    EXPECT_TRUE(result.same()) << result.first_difference << " differs";
    // What was drawn before leaves nothing behind.
    EXPECT_EQ(editor_frames(session, settings, {{96, 64}, 2}),
              editor_frames(session, settings, {{96, 64}, 2}));
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
    session.adopt();
    EXPECT_TRUE(session.guests().empty());
    session.undo();
    EXPECT_EQ(session.guests().size(), 2u);
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
