// The panes of an editor, as CONTRIBUTING.md shows them.
#include <gtest/gtest.h>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/picking.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"

namespace lanthorn {
namespace {

constexpr ivec2 kPane(96, 72);

ViewId open_second_pane(App& app, ecs::Entity camera) {
    const ViewId right = app.add_view({.size = kPane, .camera = camera, .name = "right"});
    app.world().resource_mut<PresentTarget>().panes = {{ViewId::first, {0, 0}, kPane},
                                                       {right, {kPane.x, 0}, kPane}};
    return right;
}

// Frames what lies under the cursor, pixels from the upper left of the pane, and returns it.
ecs::Entity choose(App& app, ViewId pane, glm::dvec2 cursor) {
    const std::vector<Picked> found = pick(app, pane, cursor);
    render::Lines& lines = app.world().resource_mut<render::Lines>();
    lines.clear();
    if (found.empty()) {
        return ecs::kNullEntity;
    }
    lines.add_sphere(found.front().position, 0.2, {.colour = {1, 0.6f, 0, 1}, .width = 2, .on_top = true});
    return found.front().entity;
}

TEST(PanesGuide, ShowsPicksAndFrames) {
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>().add<PresentPlugin>();
    spawn_scene(app, import_gltf(support::repository_file("assets/two-rooms.glb")), BadExtras::skip);
    app.view() = {.size = kPane, .camera = find_by_name(app.world(), "lit")};
    gpu::Texture window = gpu::Texture::make_2d(GL_RGBA8, {2 * kPane.x, kPane.y});
    const gpu::Framebuffer framebuffer({&window}, nullptr);
    app.world().resource_mut<PresentTarget>() = {framebuffer.id(), window.size(), {}};
    const ViewId right = open_second_pane(app, find_by_name(app.world(), "dark"));
    app.show();
    const std::vector<float> before = window.read_floats(3);
    const ecs::Entity chosen = choose(app, right, {48, 36});
    EXPECT_TRUE(app.world().alive(chosen));
    app.show();
    EXPECT_NE(window.read_floats(3), before);
}

}  // namespace
}  // namespace lanthorn
