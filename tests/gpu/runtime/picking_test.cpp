// What is picked under every pixel is what the picture shows there.
#include "lanthorn/runtime/picking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"

namespace lanthorn {
namespace picking_test {

constexpr ivec2 kSize(64, 48);
constexpr double kSameDistance = 1e-3;  // of it
constexpr double kFewerPixels = 0.005;  // on edges, where a ray and a rasteriser may differ by a rounding

void check(App& app, ViewId view, const char* name) {
    PickOptions shapes;
    shapes.lights = shapes.cameras = false;
    const ImageF depth = app.world().resource<Renderer>().of(view).read(render::Aov::depth);
    int other = 0, seen = 0;
    for (int y = 0; y < depth.height; ++y) {
        for (int x = 0; x < depth.width; ++x) {
            const double shown = depth.pixels[static_cast<std::size_t>(y * depth.width + x)];
            const auto found = pick(app, view, {x + 0.5, y + 0.5}, shapes);
            const double picked = found.empty() ? 0 : found.front().distance;
            other += std::abs(picked - shown) <= kSameDistance * shown ? 0 : 1;
            seen += shown > 0 ? 1 : 0;
        }
    }
    EXPECT_LE(other, kFewerPixels * depth.width * depth.height) << name;
    EXPECT_GT(seen, depth.width * depth.height / 4) << name;
}

// Where an entity is in a view's picture, or beside it; none: behind its camera.
std::optional<glm::dvec2> pixel_of(App& app, ViewId view, ecs::Entity entity) {
    const DrawnView& drawn = app.world().resource<Renderer>().drawn(view);
    const CameraView& look = drawn.scene->camera;
    const dvec3 place(app.world().get<WorldTransform>(entity).matrix[3]);
    const dvec3 seen(dmat4(look.view) * dvec4(place - drawn.scene->origin, 1));
    if (seen.z > -look.camera.z_near) {
        return std::nullopt;
    }
    const double height = std::tan(0.5 * static_cast<double>(look.camera.y_fov)) * -seen.z;
    const ivec2 size = drawn.frame->size();
    return 0.5 * glm::dvec2(size) + glm::dvec2(seen.x, -seen.y) * (0.5 * size.y / height);
}

TEST(Picking, FindsUnderEachPixelWhatThePictureShows) {
    const auto context = gpu::create_headless_context();
    int cameras = 0;
    for (const char* file : {"puppet.glb", "lantern-room.glb", "glass-ball.glb", "cornell.glb"}) {
        App app;
        add_scene_plugins(app);
        app.add<RenderPlugin>();
        render::RenderSettings settings;
        settings.adaptive_detail = false;  // which draws fewer triangles than shapes have
        app.world().insert_resource(settings);
        spawn_scene(app, import_gltf(support::repository_file(std::string("assets/") + file)),
                    BadExtras::skip);
        play_clip(app.world(), "", file);
        app.view() = {.size = kSize, .camera = find_by_name(app.world(), "camera")};
        const ViewId other = app.add_view({.size = {30, 40}});
        for (int i = 0; i < 10; ++i) {
            app.frame(1.0 / 30);  // figures walk
        }
        check(app, ViewId::first, file);
        check(app, other, file);
        // The camera that looks is not in its own way, but stands in the other view's.
        const auto mine = pick(app, ViewId::first, glm::dvec2(kSize) / 2.0, {.icon_pixels = 1e4});
        EXPECT_EQ(std::ranges::count(mine, PickedKind::camera, &Picked::kind), 0) << file;
        if (const auto pixel = pixel_of(app, other, app.view().camera)) {
            const auto theirs = pick(app, other, *pixel);
            EXPECT_EQ(std::ranges::count(theirs, app.view().camera, &Picked::entity), 1) << file;
            ++cameras;
        }
        app.view(other).size = ivec2(0);
        app.show();
        EXPECT_THROW(pick(app, other, {1, 1}), Error);
    }
    EXPECT_GE(cameras, 2);
}

}  // namespace picking_test
}  // namespace lanthorn
