// The picture in a framebuffer, as a window shows it.
#include <gtest/gtest.h>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"

namespace lanthorn {
namespace {

TEST(Present, CopiesThePictureUnlessThereIsNowhereToPutIt) {
    const auto context = gpu::create_headless_context();
    constexpr ivec2 kSize(24, 16);
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>().add<PresentPlugin>();
    spawn(app.world(), import_gltf(support::repository_file("assets/cornell.glb")));
    app.view().size = kSize;

    gpu::Texture window = gpu::Texture::make_2d(GL_RGBA8, kSize);
    const gpu::Framebuffer framebuffer({&window}, nullptr);
    window.clear(vec4(0, 1, 0, 1));
    app.world().resource_mut<PresentTarget>().framebuffer = framebuffer.id();
    app.show();
    const std::vector<float> green = window.read_floats(3);
    EXPECT_EQ(green[0], 0) << "drawn into, though its size is 0";
    EXPECT_EQ(green[1], 1);

    app.world().resource_mut<PresentTarget>().size = kSize;
    app.show();
    const render::FrameRenderer& renderer = *app.world().resource<Renderer>().frame;
    EXPECT_EQ(window.read_floats(3), renderer.final().read_floats(3));
    GLint bound = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    EXPECT_EQ(bound, static_cast<GLint>(framebuffer.id())) << "for a menu over the picture";
    EXPECT_EQ(app.frame_schedule().order().back(), "present");
}

}  // namespace
}  // namespace lanthorn
