#include "game/presentation/quality.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/workbench/all_settings.h"

namespace lanthorn::game {
namespace {

render::RenderSettings drawn_with(const Options& options) {
    return render::render_settings(Quality(options, 1).settings());
}

TEST(Quality, APresetIsTheOneThatLanthornRenderHasWithAnEyesWaysAndAirToSee) {
    for (const std::string_view preset : kPresetNames) {
        Options options;
        options.preset = preset;
        SettingsSchema schema;
        workbench::declare_all_settings(schema);
        Settings rendered(schema);
        rendered.apply_preset(preset);
        rendered.set("gi.seed", static_cast<int>(options.seed));
        rendered.set("render.antialias", true);
        rendered.set_from_text("render.upscale=temporal");
        rendered.set("render.exposure.darkest", 0.1f);
        rendered.set("render.bloom.share", 0.1f);
        rendered.set("render.rim", 0.2f);
        rendered.set("render.shoulder", 0.5f);
        rendered.set("render.air.scattering", preset == "low" ? 0.0f : 0.0012f);
        EXPECT_EQ(Quality(options, 1).settings().to_json(), rendered.to_json()) << preset;
    }
    Options low;
    low.preset = "low";
    EXPECT_EQ(drawn_with(low).shadow_resolution, 256);
}

TEST(Quality, TakesEverySettingOfThePicture) {
    Options options;
    options.set = {"render.exposure.compensation=1", "path.spp=4", "gi.bounces=1"};
    EXPECT_EQ(drawn_with(options).exposure_compensation, 1.0f);
}

TEST(Quality, SingleSettingsStandAbovePresets) {
    Options options;
    options.preset = "low";
    options.set = {"render.shadow.resolution=1024"};
    Quality quality(options, 1);
    EXPECT_EQ(render::render_settings(quality.settings()).shadow_resolution, 1024);
    quality.choose({"ultra"});
    EXPECT_EQ(render::render_settings(quality.settings()).shadow_resolution, 1024);
    EXPECT_EQ(render::render_settings(quality.settings()).area_lights_samples, 16);
}

// gi.gather.points alone would shoot rays from as many points in a quarter of the pixels.
TEST(Quality, ASmallerPictureGathersFromFewerPoints) {
    const auto points = [](const Quality& quality) {
        return gi::gi_settings(quality.settings()).of<gi::EmcSettings>().gather_points;
    };
    Quality quality(Options{}, 1);
    const int whole = points(quality);
    EXPECT_EQ(whole, gi::EmcSettings().gather_points);
    quality.choose({"low", 0.5});
    EXPECT_EQ(points(quality), whole / 4);
    quality.choose({"low", 1e-6});
    EXPECT_EQ(points(quality), 1);
    quality.choose({"low", 1});
    EXPECT_EQ(points(quality), whole);

    Options options;
    options.set = {"gi.gather.points=900"};
    Quality told(options, 1);
    told.choose({"low", 0.5});
    EXPECT_EQ(points(told), 900);
}

TEST(Quality, RefusesWhatIsNoSetting) {
    Options options;
    options.set = {"render.shadow.resolutoin=1024"};
    EXPECT_THROW(Quality refused(options, 1), InputError);
}

}  // namespace
}  // namespace lanthorn::game
