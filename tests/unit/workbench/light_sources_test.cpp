// Light that changes while geometry stands: what measurements ask of it.
#include "tools/workbench/scene/light_sources.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/runtime/shown_scene.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::workbench {
namespace {

// The room of cornell, lit by a panel, with a lamp beside it.
SceneData panel_and_lamp() {
    SceneData scene = scene_generator::cornell();
    NodeData& node = scene.nodes.emplace_back();
    node.name = "lamp";
    node.light = static_cast<std::uint32_t>(scene.lights.size());
    scene.lights.emplace_back().intensity = 3;
    return scene;
}

class Dimming : public testing::Test {
  protected:
    Dimming() : shown_(panel_and_lamp(), {}) {
        shown_.app().show();
        shown_.app().show();
    }
    const SceneChanges& dimmed(DimmedLights& lights, float factor) {
        lights.dim(factor);
        shown_.app().show();
        return shown_.frame().changes;
    }
    ShownScene shown_;
};

TEST_F(Dimming, ByTheLastBitIsOtherLightAndTheSameGeometry) {
    ASSERT_EQ(emissive_meshes(shown_.world()).size(), 1u);
    DimmedLights panel(shown_.world());
    panel.add(emissive_meshes(shown_.world()).front());
    for (const float factor : {std::nextafter(1.0f, 2.0f), 1.0f, std::nextafter(1.0f, 2.0f)}) {
        const SceneChanges& changes = dimmed(panel, factor);
        EXPECT_TRUE(changes.emission);
        EXPECT_FALSE(changes.lights);
        EXPECT_FALSE(changes.geometry || changes.pattern || changes.camera || changes.replaced);
        EXPECT_TRUE(changes.painted.empty());
    }
    EXPECT_FALSE(dimmed(panel, std::nextafter(1.0f, 2.0f)).emission) << "the same again";
}

TEST_F(Dimming, IsRelativeToWhatStoodThere) {
    DimmedLights lamp(shown_.world());
    lamp.add(punctual_lights(shown_.world()).back());
    const std::size_t last = shown_.frame().lights.size() - 1;
    dimmed(lamp, 0.5f);
    const SceneChanges& changes = dimmed(lamp, 0.25f);
    EXPECT_TRUE(changes.lights);
    EXPECT_FALSE(changes.emission);
    EXPECT_FLOAT_EQ(shown_.frame().lights[last].light.intensity, 0.75f);
    dimmed(lamp, 1);
    EXPECT_FLOAT_EQ(shown_.frame().lights[last].light.intensity, 3);
}

}  // namespace
}  // namespace lanthorn::workbench
