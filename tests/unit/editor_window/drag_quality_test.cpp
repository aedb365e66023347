// What a picture is drawn with while a hand edits.
#include "tools/editor/window/drag_quality.h"

#include <gtest/gtest.h>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::edit_window {
namespace {

TEST(DragQuality, IsCoarserAndLeavesTheLightItsWays) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings chosen(schema);
    chosen.apply_preset("low");
    chosen.set("render.upscale", render::Upscale::temporal);
    const Settings dragged = drag_settings(chosen);
    EXPECT_EQ(dragged.get<int>("render.shadow.resolution"), 128);
    EXPECT_EQ(dragged.get<int>("gi.gather.points"), 3000);
    EXPECT_EQ(dragged.text("render.upscale"), "spatial");
    for (const char* kept : {"gi.technique", "gi.bounces", "gi.emc.count", "gi.gather.texels",
                             "gi.gather.photons", "gi.gather.rays"}) {
        EXPECT_EQ(dragged.text(kept), chosen.text(kept)) << kept;
    }
    // What is coarse already stays.
    chosen.set("render.shadow.resolution", 64);
    chosen.set("gi.gather.points", 500);
    chosen.set("render.upscale", render::Upscale::none);
    EXPECT_EQ(drag_settings(chosen).to_json(), chosen.to_json());
}

TEST(DragQuality, MakesNoMorePixelsThanThereAreAtRest) {
    EXPECT_EQ(drag_whole({175, 117}, {700, 468}), ivec2(350, 234));
    EXPECT_EQ(drag_whole({455, 304}, {700, 468}), ivec2(700, 468));
}

}  // namespace
}  // namespace lanthorn::edit_window
