// The settings of `coarse-path`, and how the door comes to know it.
#include <gtest/gtest.h>

#include <algorithm>

#include "gi_module/techniques/coarse-path/coarse_path_technique.h"
#include "lanthorn/coarse-path/coarse_path.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi::test {
namespace {

class CoarseSettingsTest : public ::testing::Test {
  protected:
    CoarseSettingsTest() {
        add_coarse_path();
        declare_gi_settings(schema_);
    }
    Settings settings() const { return Settings(schema_); }

  private:
    SettingsSchema schema_;
};

TEST_F(CoarseSettingsTest, TakeWhatIsInRange) {
    Settings s = settings();
    for (const char* assignment :
         {"gi.technique=coarse-path", "gi.coarse-path.grid=8", "gi.coarse-path.samples=0.5",
          "gi.coarse-path.history=3", "gi.coarse-path.still_history=9", "gi.coarse-path.filter=2",
          "gi.coarse-path.sigma=1.5", "gi.coarse-path.threads=2"}) {
        s.set_from_text(assignment);
    }
    const GiSettings gi = gi_settings(s);
    EXPECT_EQ(gi.technique, add_coarse_path());
    EXPECT_EQ(technique_entry(gi.technique).name, "coarse-path");
    const auto& coarse = gi.of<CoarseSettings>();
    EXPECT_EQ(coarse.grid, Spacing::eight);
    EXPECT_EQ(coarse.samples, 0.5f);
    EXPECT_EQ(coarse.history, 3);
    EXPECT_EQ(coarse.still_history, 9);
    EXPECT_EQ(coarse.filter, 2);
    EXPECT_EQ(coarse.sigma, 1.5f);
    EXPECT_EQ(coarse.threads, 2);
}

TEST_F(CoarseSettingsTest, RefuseWhatIsNot) {
    Settings s = settings();
    for (const char* assignment :
         {"gi.technique=coarse", "gi.coarse-path.grid=3", "gi.coarse-path.samples=0",
          "gi.coarse-path.samples=nan", "gi.coarse-path.history=0", "gi.coarse-path.still_history=-1",
          "gi.coarse-path.filter=7", "gi.coarse-path.sigma=0", "gi.coarse-path.threads=-1",
          "gi.coarse-path.rays=5"}) {
        EXPECT_THROW(s.set_from_text(assignment), InputError) << assignment;
    }
}

TEST_F(CoarseSettingsTest, PresetsCostMoreFromLowToUltra) {
    float last = 0;
    for (const char* preset : {"low", "medium", "high", "ultra"}) {
        Settings s = settings();
        s.apply_preset(preset);
        const auto c = gi_settings(s).of<CoarseSettings>();
        const auto spacing = static_cast<float>(1 << static_cast<int>(c.grid));
        const float paths_a_pixel = c.samples / (spacing * spacing);
        EXPECT_GT(paths_a_pixel, last) << preset;
        last = paths_a_pixel;
    }
}

TEST(TechniqueDoor, MakesWhatItHasBeenToldOf) {
    const TechniqueKind coarse_path = add_coarse_path();
    EXPECT_EQ(add_coarse_path(), coarse_path);  // a second time alters nothing
    EXPECT_EQ(std::ranges::count(technique_names(), "coarse-path"), 1);
    const std::unique_ptr<Technique> made = make_technique(coarse_path);
    EXPECT_NE(dynamic_cast<const CoarsePathTechnique*>(made.get()), nullptr);

    // The plan was emc's for every technique.
    const auto first_pass = [](TechniqueKind kind) {
        FrameScene scene;
        scene.assets = std::make_shared<SceneAssets>();
        GiSettings settings;
        settings.technique = kind;
        return first_plan(scene, settings).entries.front();
    };
    EXPECT_EQ(first_pass(TechniqueKind::first).pass, "selection");
    EXPECT_EQ(first_pass(coarse_path).pass, "acceleration_structure");
    EXPECT_EQ(first_pass(TechniqueKind::none).why, "the technique is 'none': direct light alone");
}

// What a schema was declared without stays as it is made.
TEST(TechniqueDoor, TakesSettingsThatWereDeclaredBeforeATechniqueWasKnown) {
    struct LateSettings {
        int steps = 3;
    };
    SettingsSchema before;
    declare_gi_settings(before);
    TechniqueEntry late;
    late.name = "late";
    late.declare = [](SettingList& list) {
        list.declare<&LateSettings::steps>("gi.late.steps").range(1, 9).cost("none").docs("Steps.");
    };
    const TechniqueKind kind = add_technique(std::move(late));
    EXPECT_EQ(technique_entry(kind).name, "late");
    EXPECT_EQ(gi_settings(Settings(before)).of<LateSettings>().steps, 3);

    SettingsSchema after;
    declare_gi_settings(after);
    Settings settings(after);
    settings.set_from_text("gi.late.steps=7");
    settings.set_from_text("gi.technique=late");
    const GiSettings gi = gi_settings(settings);
    EXPECT_EQ(gi.of<LateSettings>().steps, 7);
    EXPECT_EQ(gi.technique, kind);
    GiSettings edited = gi;
    edited.edit<LateSettings>().steps = 8;
    EXPECT_EQ(gi.of<LateSettings>().steps, 7);  // copies do not share what is edited
}

}  // namespace
}  // namespace lanthorn::gi::test
