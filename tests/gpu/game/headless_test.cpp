// The game without a window: as many pictures as were asked for.
#include "game/presentation/headless.h"

#include <gtest/gtest.h>

#include "game/presentation/playthrough.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

class Headless : public testing::Test {
  protected:
    Headless() {
        options_.headless = true;
        options_.level = support::repository_file("assets/lantern-room.glb");
        scene_ = import_gltf(options_.level);
        options_.size = ivec2(32, 18);
        options_.set = {"gi.technique=none"};
        options_.out = folder_.path("pictures");
    }

    // She walks for `steps` steps.
    void record(int steps) {
        Options options = options_;
        options.headless = false;
        options.record = folder_.path("walk.rec");
        Playthrough playthrough(options, scene_);
        session::Session& session = playthrough.session();
        PlayerInput input;
        input.forward = axis(1);
        playthrough.set_devices([&] { return input; });
        for (int i = 0; i < steps; ++i) {
            session.app().step();
        }
        session.finish();
        options_.replay = options.record;
    }

    std::vector<std::string> pictures(int wanted) {
        options_.frames = wanted;
        const StopSignal stop;
        EXPECT_EQ(run_headless(options_, scene_, stop), ExitCode::ok);
        return testing_tools::files_in(options_.out);
    }

    testing_tools::TemporaryFolder folder_;
    Options options_;
    SceneData scene_;
};

TEST_F(Headless, MakesMorePicturesThanThereAreSteps) {
    options_.size = ivec2(160, 90);
    record(30);
    const std::vector<std::string> names = pictures(100);
    ASSERT_EQ(names.size(), 100u);
    EXPECT_EQ(names.back(), "frame-0100.png");
    // Steps 29.1 and 29.7: between two steps she is under way.
    const auto picture = [&](int i) {
        return read_image(options_.out + '/' + names[static_cast<std::size_t>(i)]).pixels;
    };
    EXPECT_NE(picture(96), picture(98));
}

TEST_F(Headless, MakesFewPicturesOfManySteps) {
    record(12);
    EXPECT_EQ(pictures(5).size(), 5u);
}

TEST_F(Headless, MakesOnePictureAStepWhereThereAreFew) {
    record(12);
    EXPECT_EQ(pictures(0).size(), 12u);
}

}  // namespace
}  // namespace lanthorn::game
