// What lies between a lamp and a floor: cut-outs, blends, glass, backs; and textures as OpenGL looks them up.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/scene/texture_lookup.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

constexpr float kAlbedo = 0.5f;

// Irradiance below a pane half way to a light straight above, over what it is without a pane.
double passing(const Material& pane, Transport transport, bool upside_down = false, bool lamp_light = false) {
    const Mesh floor_mesh = quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0);
    const Mesh pane_mesh = upside_down ? quad({-5, 1, -5}, {10, 0, 0}, {0, 0, 10}, 1)
                                       : quad({-5, 1, 5}, {10, 0, 0}, {0, 0, -10}, 1);
    const Mesh panel = quad({-0.5f, 4, -0.5f}, {1, 0, 0}, {0, 0, 1}, 2);
    std::vector<LightInstance> lights;
    if (!lamp_light) {
        lights.push_back(directional_light({0, -1, 0}, 100));
    }
    const auto lit = [&](std::vector<Mesh> meshes) {
        FrameScene scene = scene_of(std::move(meshes), {lambertian(vec3(kAlbedo)), pane, lamp(vec3(100))},
                                    lights, vec3(0), vec3(0, 1, 0));
        look_closely(scene, vec3(0, 0.5f, 0.5f), vec3(0), 1e-3f);
        PathSettings settings;
        settings.transport = transport;
        settings.spp = 512;
        return mean_of(scene, settings, PathAov::direct, ivec2(4));
    };
    return lamp_light ? lit({floor_mesh, pane_mesh, panel}) / lit({floor_mesh, panel})
                      : lit({floor_mesh, pane_mesh}) / lit({floor_mesh});
}

TEST(Between, OpaqueSurfacesBlockFromBothSides) {
    for (const Transport transport : {Transport::diffuse, Transport::full}) {
        EXPECT_EQ(passing(lambertian(vec3(1)), transport), 0);
        EXPECT_EQ(passing(lambertian(vec3(1)), transport, true), 0) << "its back";
    }
}

TEST(Between, CutOutsLetLightThroughWhereTheyAreCutOut) {
    Material pane = lambertian(vec3(1));
    pane.alpha_mode = AlphaMode::mask;
    for (const Transport transport : {Transport::diffuse, Transport::full}) {
        pane.base_colour.a = 0.4f;
        EXPECT_NEAR(passing(pane, transport), 1, 1e-5);
        pane.base_colour.a = 0.6f;
        EXPECT_EQ(passing(pane, transport), 0);
    }
}

TEST(Between, BlendedSurfacesLetTheRestThrough) {
    Material pane = lambertian(vec3(1));
    pane.alpha_mode = AlphaMode::blend;
    pane.base_colour.a = 0.3f;
    EXPECT_NEAR(passing(pane, Transport::full), 0.7, 1e-4);
    EXPECT_NEAR(passing(pane, Transport::full, false, true), 0.7, 0.01)
        << "by multiple importance sampling, too";
    EXPECT_NEAR(passing(pane, Transport::diffuse, false, true), 0.7, 0.03)
        << "the same places in every frame";
}

TEST(Between, ThinGlassLetsThroughWhatItDoesNotReflect) {
    Material pane = lambertian({0.8f, 0.8f, 0.8f});
    pane.specular = 1;
    pane.roughness = 0;
    pane.transmission = 1;
    const double straight = 0.8 * (1 - 0.04);  // Fresnel at normal incidence, ior 1.5
    EXPECT_NEAR(passing(pane, Transport::full), straight, 1e-3);
    EXPECT_NEAR(passing(pane, Transport::full, true), straight, 1e-3) << "from its back";
    EXPECT_NEAR(passing(pane, Transport::full, false, true), straight, 0.01);
    EXPECT_EQ(passing(pane, Transport::diffuse), 0) << "the rasteriser's glass casts a shadow";
}

// Frosted glass spreads light, and keeps what it spreads: seen from below a pane under an even sky, it is as
// bright as what it transmits.
TEST(Between, RoughGlassUnderAnEvenSkyIsAsBrightAsTheSky) {
    Material pane = lambertian(vec3(1));
    pane.specular = 0;
    pane.roughness = 0.3f;
    pane.transmission = 1;
    FrameScene scene = scene_of({quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0), sphere(vec3(0), 10, 3, true, 1)},
                                {pane, lamp(vec3(10))}, {}, vec3(0, 2, 0), vec3(0));
    look_closely(scene, vec3(0, 2, 0), vec3(0), 0.1f);
    PathSettings settings;
    settings.transport = Transport::full;
    settings.spp = 512;
    const double seen = mean_of(scene, settings, PathAov::radiance, ivec2(4)) / 10;
    EXPECT_GT(seen, 0.93) << "single scattering loses a little";
    EXPECT_LT(seen, 1.005);
}

TEST(Seen, BacksOfSingleSidedSurfacesAreNot) {
    Material wall = lambertian(vec3(0.5f));
    const auto depth = [&] {
        FrameScene scene = scene_of(
            {quad({-1, -1, -1}, {0, 2, 0}, {2, 0, 0}, 0), quad({-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, 0)},
            {wall}, {}, vec3(0), vec3(0, 0, -1));
        PathTracer tracer(scene, ivec2(1), {}, {});
        return tracer.image(PathAov::depth)[0];
    };
    EXPECT_NEAR(depth(), 2, 1e-5f);
    wall.double_sided = true;
    EXPECT_NEAR(depth(), 1, 1e-5f);
}

// A mirror image of a node (a negative scale) turns its triangles round, not its sides.
TEST(Seen, FrontsOfMirroredNodesAre) {
    for (const vec3 scale : {vec3(1), vec3(-1, 1, 1), vec3(1, -1, 1), vec3(-1, -1, 1), vec3(-2, 3, 1)}) {
        FrameScene scene = scene_of({quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0)}, {lambertian(vec3(0.5f))},
                                    {}, vec3(0), vec3(0, 0, -1));
        scene.instances[0].transform = glm::scale(mat4(1), scale);
        PathTracer tracer(scene, ivec2(1), {}, {});
        EXPECT_NEAR(tracer.image(PathAov::depth)[0], 1, 1e-5f) << scale.x << " " << scale.y;
        EXPECT_GT(tracer.image(PathAov::normal)[2], 0.99f) << scale.x << " " << scale.y;
    }
}

// A wall of two sheets in one place, back to back, is seen and reflects like its front sheet alone.
TEST(Seen, SheetsBackToBackAreOneWall) {
    const Mesh front = quad({-5, -5, -1}, {10, 0, 0}, {0, 10, 0}, 0);
    const Mesh back = quad({-5, -5, -1}, {0, 10, 0}, {10, 0, 0}, 0);
    const Mesh beyond = quad({-5, -5, -2}, {10, 0, 0}, {0, 10, 0}, 0);
    const Mesh behind = quad({-5, -5, 1}, {0, 10, 0}, {10, 0, 0}, 0);
    const auto light_and_depth = [&](std::vector<Mesh> meshes) {
        FrameScene scene = scene_of(std::move(meshes), {lambertian(vec3(0.5f))}, {point_light(vec3(0), 100)},
                                    vec3(0), vec3(0, 0, -1));
        PathTracer tracer(scene, ivec2(8), {}, {});
        scene.camera.view = glm::lookAt(vec3(0), vec3(0, 0, 1), vec3(0, 1, 0));
        PathSettings settings;
        settings.bounces = 1;
        const double light =
            mean_of(scene, settings, PathAov::indirect);  // off the wall, at the one behind the eye
        return std::pair(light, tracer.image(PathAov::depth));
    };
    const auto alone = light_and_depth({front, beyond, behind});
    EXPECT_GT(alone.first, 1);
    for (const auto& sheets : {std::vector{front, back}, std::vector{back, front}}) {
        const auto both = light_and_depth({sheets[0], sheets[1], beyond, behind});
        EXPECT_NEAR(both.first / alone.first, 1, 1e-5);
        for (std::size_t i = 0; i < both.second.size(); ++i) {
            EXPECT_NEAR(both.second[i], alone.second[i], 1e-5f);
        }
    }
}

TEST(Seen, UnlitIsItsColourAndReflectsNothing) {
    Material sign = lambertian({0.2f, 0.4f, 0.6f});
    sign.unlit = true;
    FrameScene scene = scene_of({quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0)}, {sign},
                                {point_light(vec3(0), 100)}, vec3(0), vec3(0, 0, -1));
    for (const Transport transport : {Transport::diffuse, Transport::full}) {
        PathSettings settings;
        settings.transport = transport;
        settings.spp = 4;
        PathTracer tracer(scene, ivec2(1), settings, {true, true, true});
        tracer.render({});
        EXPECT_EQ(tracer.image(PathAov::radiance), (std::vector<float>{0.2f, 0.4f, 0.6f}));
        EXPECT_EQ(tracer.image(PathAov::direct), std::vector<float>(3));
        EXPECT_EQ(tracer.coverage(), (std::vector<float>{2}));
    }
}

TEST(Textures, AreLookedUpAsOpenGlDoes) {
    SceneAssets assets;
    assets.images.push_back({"two", 2, 1, {0, 0, 0, 255, 255, 255, 255, 255}});
    Texture texture;
    const auto red = [&](float u, bool srgb = false) {
        return sample_texture(assets, texture, {u, 0.5f}, srgb).r;
    };
    EXPECT_NEAR(red(0.25f), 0, 1e-6f);
    EXPECT_NEAR(red(0.5f), 0.5f, 1e-6f);
    EXPECT_NEAR(red(0.75f), 1, 1e-6f);
    EXPECT_NEAR(red(1.0f), 0.5f, 1e-6f) << "repeats";
    EXPECT_NEAR(red(-0.25f), 1, 1e-6f);
    texture.sampler.wrap_s = Wrap::clamp_to_edge;
    EXPECT_NEAR(red(1.0f), 1, 1e-6f);
    EXPECT_NEAR(red(-7.0f), 0, 1e-6f);
    texture.sampler.wrap_s = Wrap::mirrored_repeat;
    EXPECT_NEAR(red(1.25f), 1, 1e-6f);
    EXPECT_NEAR(red(1.75f), 0, 1e-6f);
    texture.sampler.mag = Filter::nearest;
    EXPECT_NEAR(red(0.49f), 0, 1e-6f);
    EXPECT_NEAR(red(0.51f), 1, 1e-6f);
    assets.images.edit(0, [](Image& image) { image.rgba[0] = 128; });
    EXPECT_NEAR(red(0.2f, true), 0.2158605f, 1e-6f) << "sRGB, IEC 61966-2-1";
    EXPECT_EQ(red(NAN), 1) << "no place at all";
}

}  // namespace
}  // namespace lanthorn::reference::test
