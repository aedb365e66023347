#include "game/presentation.h"

#include <gtest/gtest.h>

#include "game/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

constexpr ivec2 kSize(64, 48);

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

TEST(Presentation, DrawsWithTheSettingsOfThePicture) {
    const SceneData scene = import_gltf(support::repository_file("assets/lantern-room.glb"));
    const Level level = find_level(scene);
    const auto context = gpu::create_headless_context();
    const View view = Simulation(level, 1, 1).view();
    std::vector<double> brightness;
    for (const char* compensation : {"render.exposure.compensation=0", "render.exposure.compensation=1"}) {
        Options options;
        options.preset = "low";
        options.set = {"gi.technique=none", compensation};
        Presentation presentation(scene, level, context->info());
        presentation.draw(view, kSize, Quality(options).settings());
        brightness.push_back(mean(presentation.picture().pixels));
        EXPECT_EQ(presentation.renderer().light_maps().resolution(), 256);
    }
    EXPECT_GT(brightness[1], 1.1 * brightness[0]);
}

}  // namespace
}  // namespace lanthorn::game
