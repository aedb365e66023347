// Frames that are measured are those that are shown.
#include "lanthorn/workbench/frame_meter.h"

#include <gtest/gtest.h>

#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/render_job.h"
#include "tests/support/repository.h"

namespace lanthorn::workbench {
namespace frame_meter_test {

// Polished things reflect lamps, which are traced: what direct light leaves to the technique is left to it
// under the meter, too.
TEST(FrameMeter, ThePictureIsRendersAndTheTechniquesMemoryIsCounted) {
    const std::string file = support::repository_file("assets/mirror-balls.glb");
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    settings.apply_preset("low");
    RenderJob job;
    job.size = ivec2(48);
    job.frames = 2;
    job.view.time = 0;
    const RenderOutcome shown = render_scene(load_scene(file, job.view), settings, job, [](int) {});

    const auto context = gpu::create_headless_context();
    ShownScene scene(load_scene(file, job.view), job.view);
    FrameMeter meter(scene.app(), settings, *context);
    scene.app().view().size = job.size;
    for (int i = 0; i < job.frames; ++i) {
        meter.measure([&] { scene.show_at(0); });
    }
    const render::FrameRenderer& frame = *std::as_const(scene).world().resource<Renderer>().frame;
    EXPECT_EQ(frame.read(render::Aov::final).pixels, shown.images.front().pixels);
    EXPECT_GT(meter.held().scene, 1 << 20) << "maps and the light on them";
    EXPECT_GT(meter.held().picture, 1 << 16) << "the picture's rays";
}

}  // namespace frame_meter_test
}  // namespace lanthorn::workbench
