// The settings of `drm`.
#include <gtest/gtest.h>

#include "gi_module/techniques/drm/drm_technique.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/drm/drm.h"

namespace lanthorn::gi {
namespace {

class DrmSettingsTest : public ::testing::Test {
  protected:
    DrmSettingsTest() : kind_(add_drm()) { declare_gi_settings(schema_); }
    Settings settings() const { return Settings(schema_); }

    TechniqueKind kind_;

  private:
    SettingsSchema schema_;
};

TEST_F(DrmSettingsTest, TakeWhatIsInRange) {
    Settings s = settings();
    for (const char* assignment : {"gi.technique=drm", "gi.drm.samples=16", "gi.drm.solid_angle=15",
                                   "gi.drm.mips=none", "gi.drm.texels=1", "gi.drm.lights=3",
                                   "gi.drm.mirrors=trick", "gi.drm.visibility=maps", "gi.drm.second=2"}) {
        s.set_from_text(assignment);
    }
    const GiSettings gi = gi_settings(s);
    const DrmSettings& drm = gi.of<DrmSettings>();
    EXPECT_EQ(gi.technique, kind_);
    EXPECT_EQ(drm.samples, 16);
    EXPECT_EQ(drm.solid_angle, SolidAngle::eq_15);
    EXPECT_EQ(drm.mips, DrmMips::none);
    EXPECT_EQ(drm.texels, 1);
    EXPECT_EQ(drm.lights, 3);
    EXPECT_EQ(drm.mirrors, DrmMirrors::trick);
    EXPECT_EQ(drm.visibility, DrmVisibility::maps);
    EXPECT_EQ(drm.second, 2);
    EXPECT_EQ(gi_settings(settings()).of<DrmSettings>(), DrmSettings());
}

TEST_F(DrmSettingsTest, RefuseWhatIsNot) {
    Settings s = settings();
    for (const char* assignment :
         {"gi.drm.samples=0", "gi.drm.samples=17", "gi.drm.samples=nan", "gi.drm.solid_angle=7",
          "gi.drm.solid_angle=12", "gi.drm.mips=some", "gi.drm.texels=0", "gi.drm.lights=0",
          "gi.drm.mirrors=none", "gi.drm.m=3", "gi.drm.visibility=rays", "gi.drm.second=5"}) {
        EXPECT_THROW(s.set_from_text(assignment), InputError) << assignment;
    }
}

TEST_F(DrmSettingsTest, PresetsCostMoreFromLowToUltra) {
    int last = 0;
    for (const char* preset : {"low", "medium", "high", "ultra"}) {
        Settings s = settings();
        s.apply_preset(preset);
        const int samples = gi_settings(s).of<DrmSettings>().samples;
        EXPECT_GT(samples, last) << preset;
        last = samples;
    }
}

TEST_F(DrmSettingsTest, SamplesHoldWhereTheyWouldBeTheSame) {
    const DrmSettings a;
    DrmSettings b = a;
    b.mirrors = DrmMirrors::direct;
    EXPECT_TRUE(same_samples(a, b));
    b = a;
    b.samples = 5;
    EXPECT_FALSE(same_samples(a, b));
    b = a;
    b.solid_angle = SolidAngle::eq_11;
    EXPECT_FALSE(same_samples(a, b));
    b = a;
    b.visibility = DrmVisibility::maps;
    EXPECT_FALSE(same_samples(a, b));
    b = a;
    b.second = 1;
    EXPECT_FALSE(same_samples(a, b));
}

}  // namespace
}  // namespace lanthorn::gi
