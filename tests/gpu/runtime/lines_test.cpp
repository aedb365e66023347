// Lines over pictures: which pixels they cover, what hides them, near planes, and places far away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/render/line_pass.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn {
namespace {

constexpr ivec2 kSize(64, 48);
const vec4 kRed(1, 0, 0, 1);

// A grey wall in the plane z = 0 on the left half, 6.4 m by 4.8 m in the picture: 0.1 m a pixel.
struct Wall {
    FrameScene scene;
    std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    App app;

    explicit Wall(const dvec3& origin = dvec3(0)) {
        app.add<RenderPlugin>();
        scene = support::scene_of({support::quad(vec3(-10, -10, 0), vec3(10, 0, 0), vec3(0, 20, 0), 0)},
                                  {support::lambertian(vec3(0.5f))}, {}, vec3(0, 0, 10), vec3(0));
        scene.camera.camera.orthographic = true;
        scene.camera.camera.y_mag = 2.4f;
        scene.camera.camera.x_mag = 3.2f;
        scene.camera.camera.z_near = 0.1f;
        scene.origin = origin;
        app.view().size = kSize;
    }
    render::Lines& lines() { return app.world().resource_mut<render::Lines>(); }
    ImageF show() {
        app.world().insert_resource(scene);
        app.show();
        return app.world().resource<Renderer>().frame->read(render::Aov::final);
    }
};

vec3 at(const ImageF& image, int x, int y_up) {
    const auto i = static_cast<std::size_t>(3 * ((image.height - 1 - y_up) * image.width + x));
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

int red_pixels(const ImageF& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        count += image.pixels[i] > 0.9f && image.pixels[i + 1] < 0.1f ? 1 : 0;
    }
    return count;
}

// Metres of a pixel's centre.
dvec3 metres(int x, int y_up, double z = 1) {
    return {(x + 0.5 - 32) * 0.1, (y_up + 0.5 - 24) * 0.1, z};
}

TEST(Lines, CoverThePixelsThatTheyAreWide) {
    Wall wall;
    const ImageF before = wall.show();
    wall.lines().add(metres(10, 20), metres(40, 20), {.colour = kRed, .width = 3});
    const ImageF after = wall.show();
    int wrong = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            if (x >= 10 && x <= 40 && y >= 19 && y <= 21) {
                wrong += at(after, x, y) == vec3(1, 0, 0) ? 0 : 1;
            } else if (x < 8 || x > 42 || y < 18 || y > 22) {
                wrong += at(after, x, y) == at(before, x, y) ? 0 : 1;
            }
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(at(after, 25, 22), at(before, 25, 22)) << "half a pixel beyond the rim";
    wall.lines().clear();
    EXPECT_EQ(wall.show().pixels, before.pixels);
    wall.app.view().lines.add(metres(5, 5), metres(5, 5), {.colour = {1, 0, 0, 0.5f}, .width = 4});
    const vec3 mixed = at(wall.show(), 5, 5);
    EXPECT_NEAR(mixed.x, 0.5f + 0.5f * at(before, 5, 5).x, 2.0f / 255) << "a dot that covers half";
}

TEST(Lines, AreHiddenByWhatIsNearerUnlessOnTop) {
    Wall wall;
    const auto shown = [&](double z, bool on_top) {
        wall.lines().clear();
        wall.lines().add(metres(10, 20, z), metres(50, 20, z),
                         {.colour = kRed, .width = 1, .on_top = on_top});
        const ImageF image = wall.show();
        return std::pair(at(image, 20, 20) == vec3(1, 0, 0), at(image, 45, 20) == vec3(1, 0, 0));
    };
    EXPECT_EQ(shown(1, false), std::pair(true, true));
    EXPECT_EQ(shown(0, false), std::pair(true, true)) << "on the wall";
    EXPECT_EQ(shown(-1, false), std::pair(false, true)) << "the wall ends at the middle";
    EXPECT_EQ(shown(-1, true), std::pair(true, true));
}

TEST(Lines, HoldFarFromTheOriginAndWhenTheyAreLong) {
    Wall wall;
    wall.lines().add(metres(10, 7), metres(40, 31), {.colour = kRed, .width = 2});
    const ImageF near = wall.show();
    const dvec3 place(6.4e6, -2e6, 1.5e7);
    Wall far(place);
    far.lines().add(place + metres(10, 7), place + metres(40, 31), {.colour = kRed, .width = 2});
    const ImageF image = far.show();
    float most = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        most = std::max(most, std::abs(image.pixels[i] - near.pixels[i]));
    }
    EXPECT_LE(most, 2.0f / 255);
    EXPECT_GT(red_pixels(near), 30);

    // Longer than floats tell its pixels by.
    far.lines().clear();
    far.lines().add(place + metres(0, 20) - dvec3(1e9, 0, 0), place + metres(0, 20) + dvec3(1e9, 0, 0),
                    {.colour = kRed, .width = 1});
    const ImageF line = far.show();
    EXPECT_EQ(red_pixels(line), kSize.x);
    EXPECT_EQ(at(line, 33, 20), vec3(1, 0, 0));
}

TEST(Lines, AreCutAtTheNearPlane) {
    const Wall wall;
    FrameScene scene = wall.scene;
    scene.camera.camera.orthographic = false;
    scene.camera.camera.y_fov = kPi / 2;  // at a distance of 1: half the height is 1
    const auto camera = render::CameraUniforms::from(scene.camera, 64.0f / 48);
    const auto seen = [&](const dvec3& from, const dvec3& to) {
        return render::in_picture({from, to, kRed, 1, false}, camera, dvec3(0), kSize);
    };
    // From 5 m behind the camera to 10 m before it, half a metre below: it comes up from the lower edge.
    const auto line = seen({0, -0.5, 15}, {0, -0.5, 0});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->from.x, 32, 1e-4);
    EXPECT_NEAR(line->to.y, 24 - 24 * 0.5 / 10, 1e-4);
    EXPECT_LT(line->from.y, 0);
    EXPECT_GT(line->from.y, -10) << "cut beside the picture";
    EXPECT_FALSE(seen({0, 0, 11}, {3, 1, 10})) << "behind";
    EXPECT_FALSE(seen({0, 0, 9.95}, {0.001, 0, 9.91})) << "nearer than the near plane";
    EXPECT_FALSE(seen({100, 0, 9}, {100, 0, 8})) << "beside";
    EXPECT_FALSE(seen({0, 0, std::nan("")}, {0, 0, 0}));
    EXPECT_FALSE(seen({0, 0, 0}, {0, 0, INFINITY}));
    EXPECT_TRUE(seen({0, 0, 0}, {0, 0, 0})) << "a dot";
    // Through the camera itself.
    const auto through = seen({-1, 0, 11}, {1, 0, 9});
    ASSERT_TRUE(through);
    EXPECT_TRUE(std::isfinite(through->from.x) && std::isfinite(through->to.x));
    EXPECT_FALSE(std::isnan(through->from_depth));
}

// To be looked at: build/release/tests/gpu/pictures/lines.png.
TEST(Lines, ShowBoundsLightsAndGizmos) {
    const auto context = gpu::create_headless_context();
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>();
    spawn_scene(app, import_gltf(support::repository_file("assets/puppet.glb")), BadExtras::skip);
    app.view() = {.size = {640, 480}, .camera = find_by_name(app.world(), "camera")};
    app.show();
    const ImageF before = app.world().resource<Renderer>().frame->read(render::Aov::final);
    const FrameScene& scene = app.world().resource<FrameScene>();
    render::Lines& lines = app.world().resource_mut<render::Lines>();
    const dmat4 to_world = glm::translate(dmat4(1), scene.origin);
    for (const Instance& instance : scene.instances) {
        lines.add_box(to_world, dvec3(instance.bounds.lower), dvec3(instance.bounds.upper),
                      {.colour = {1, 0.8f, 0.1f, 0.8f}});
    }
    for (const LightInstance& light : scene.lights) {
        lines.add_sphere(scene.origin + dvec3(light.position), 0.3,
                         {.colour = {0.2f, 0.9f, 1, 1}, .width = 2});
    }
    const dvec3 centre = scene.origin + dvec3(scene.bounds.centre());
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 end(0);
        vec4 colour(0.1f, 0.1f, 0.1f, 1);
        end[axis] = 0.7;
        colour[axis] = 1;
        lines.add(centre, centre + end, {.colour = colour, .width = 5, .on_top = true});
        end[axis] = 1e6;
        lines.add(centre - end, centre + end, {.colour = colour, .width = 1});
    }
    app.show();
    const ImageF after = app.world().resource<Renderer>().frame->read(render::Aov::final);
    EXPECT_NE(after.pixels, before.pixels);
    std::filesystem::create_directories(LANTHORN_PICTURES);
    write_image(LANTHORN_PICTURES "/lines.png", after);
    EXPECT_EQ(app.frame_schedule().order().back(), "upscale");
}

}  // namespace
}  // namespace lanthorn
