// What mirrors and glass show, against what is known on paper: a mirror's picture is what a camera behind it
// sees, a window's is what stands behind it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/render/brdf_table.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);
constexpr float kNits = 100;

Material glass(float ior, float thickness) {
    Material m;
    m.metallic = 0;
    m.roughness = 0;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = thickness;
    return m;
}

SkyInstance even_sky() {
    SkyImage image;
    image.width = 8;
    image.height = 4;
    image.radiance.assign(32, vec3(kNits));
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    return sky;
}

// A room whose walls have three colours, with a block; `more`: stands in it too. `wall`: the one at x = 4 is
// there.
FrameScene room(std::vector<Mesh> more, std::vector<Material> materials, const vec3& eye, const vec3& target,
                bool wall = true) {
    std::vector<Mesh> meshes{
        quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0),  // floor
        quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),       quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 1),
        quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 2),      quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
        box({0.5f, 0, 0.5f}, {1.1f, 0.9f, 1.1f}, false, 2)};
    std::vector<Material> all{lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)),
                              lambertian(vec3(0.7f, 0.3f, 0.2f))};
    if (wall) {  // at x = 4
        meshes.push_back(quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0));
    }
    for (Mesh& mesh : more) {
        mesh.material += 3;
        meshes.push_back(std::move(mesh));
    }
    all.insert(all.end(), materials.begin(), materials.end());
    FrameScene scene =
        scene_of(std::move(meshes), std::move(all), {point_light(vec3(2, 2.1f, 0.6f), 60)}, eye, target);
    scene.camera.camera.y_fov = 0.6f;  // the lamp's own reflection is not in the picture
    return scene;
}

class Specular : public ::testing::TestWithParam<EmcRays> {
  protected:
    static void SetUpTestSuite() { add_embree_rays(); }
    GiSettings settings() const {
        GiSettings s;
        s.edit<EmcSettings>().rays = GetParam();
        // Two pictures of one room are alike as far as their lit maps are: rays have the same there, photons
        // noise.
        s.edit<EmcSettings>().gather_source = GatherSource::rays;
        s.edit<EmcSettings>().gather_points = 1;
        s.edit<EmcSettings>().gather_grid = 2;
        // A mirror's own light on the room is not what these tests are about.
        s.edit<EmcSettings>().caustic_photons = 0;
        s.edit<EmcSettings>().gather_endless = false;
        return s;
    }
    // Radiance of a still picture, nits. What is mirrored has been reflected once less than what is seen.
    ImageF picture(FrameScene scene, int bounces = 2, int grid = 1) const {
        constexpr ivec2 size = kSize;
        Bench bench;
        bench.settings = settings();
        bench.settings.bounces = bounces;
        bench.settings.edit<EmcSettings>().specular_grid = grid;
        bench.frame(scene, size);
        hold_still(scene);
        for (int f = 1; f < 12; ++f) {
            bench.frame(scene, size);
        }
        EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
        return bench.renderer().read(render::Aov::radiance);
    }
    Deviation coarser(const FrameScene& scene, int grid, const char* what) const;
};

std::string name_of(const ::testing::TestParamInfo<EmcRays>& info) {
    return info.param == EmcRays::maps ? "maps" : "bvh";
}

INSTANTIATE_TEST_SUITE_P(Rays, Specular, ::testing::Values(EmcRays::maps, EmcRays::bvh), name_of);

// Mean over the middle half of the picture, by channel.
vec3 middle_of(const ImageF& image) {
    dvec3 sum(0);
    int count = 0;
    for (int y = image.height / 4; y < 3 * image.height / 4; ++y) {
        for (int x = image.width / 4; x < 3 * image.width / 4; ++x) {
            const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
            sum += dvec3(image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]);
            ++count;
        }
    }
    return vec3(sum / static_cast<double>(count));
}

// Of the picture from the expected one times `share`, over all channels.
Deviation against(const ImageF& image, const ImageF& expected, float share) {
    double sum = 0, wanted = 0, squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto value = static_cast<double>(image.pixels[i]);
        const auto right = static_cast<double>(expected.pixels[i] * share);
        EXPECT_TRUE(std::isfinite(value)) << i;
        sum += value;
        wanted += right;
        squares += (value - right) * (value - right);
    }
    const auto count = static_cast<double>(image.pixels.size());
    return {sum / wanted, std::sqrt(squares / count) / (wanted / count)};
}

// A picture whose rays are `grid` pixels apart, from one with a ray a pixel.
Deviation Specular::coarser(const FrameScene& scene, int grid, const char* what) const {
    const Deviation d = against(picture(scene, 2, grid), picture(scene), 1);
    std::printf("%s, one ray in %d x %d: flux %.4f, relRMSE %.4f\n", what, grid, grid, d.mean, d.rel_rmse);
    return d;
}

TEST(BrdfTable, ReflectsNoMoreThanArrives) {
    for (const float nv : {0.0f, 0.1f, 0.5f, 1.0f}) {
        for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
            const vec2 share = render::brdf_share(nv, roughness);
            EXPECT_LE(share.x + share.y, 1.001f) << nv << ' ' << roughness;
            EXPECT_GT(share.x + share.y, 0.3f) << nv << ' ' << roughness;
            // A white dielectric, its diffuse part and its lobe together.
            for (const float f0 : {0.0f, 0.04f, 0.25f, 1.0f}) {
                const float f90 = std::min(50 * f0, 1.0f);
                const float out = f0 + (f90 - f0) * std::pow(1 - nv, 5.0f), in = f0 + (f90 - f0) / 21;
                EXPECT_LE(f0 * share.x + f90 * share.y + (1 - out) * (1 - in), 1.0f)
                    << nv << ' ' << roughness << ' ' << f0;
            }
        }
    }
    // A mirror reflects all of it: Schlick's reflectance and nothing else.
    const vec2 mirror = render::brdf_share(0.5f, 0);
    EXPECT_NEAR(mirror.x, 1 - std::pow(0.5f, 5.0f), 0.01f);
    EXPECT_NEAR(mirror.y, std::pow(0.5f, 5.0f), 0.01f);
}

// Under an even sky every lobe sees the same, traced or not: brdf_share() says how much comes back.
TEST_P(Specular, AMetalFloorUnderAnEvenSkyReflectsItsShare) {
    for (const float roughness : {0.0f, 0.2f, 0.45f, 1.0f}) {
        FrameScene scene =
            scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0)}, {metal(vec3(0.9f, 0.6f, 0.3f), roughness)},
                     {}, vec3(0, 2, 0.01f), vec3(0));
        scene.camera.camera.y_fov = 0.5f;
        scene.sky = even_sky();
        const vec3 got = middle_of(picture(scene));
        const vec2 share = render::brdf_share(1, roughness);
        for (int c = 0; c < 3; ++c) {
            const float base = vec3(0.9f, 0.6f, 0.3f)[c];
            EXPECT_NEAR(got[c] / kNits, base * share.x + share.y, 0.015f) << roughness << ' ' << c;
        }
    }
}

// The mirror fills the wall at x = 4; the same room from behind it, with the wall away, is its picture.
TEST_P(Specular, AMirrorShowsWhatACameraBehindItSees) {
    const Material mirror = metal(vec3(1), 0);
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.0f, 1.75f);
    const ImageF shown =
        picture(room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {mirror}, eye, target), 3);
    const vec3 flip(-1, 1, 1), behind(2 * 3.99f, 0, 0);
    const ImageF direct = picture(room({}, {}, eye * flip + behind, target * flip + behind, false));
    ImageF mirrored = direct;
    for (int y = 0; y < direct.height; ++y) {
        for (int x = 0; x < direct.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const int to = 3 * (y * direct.width + x) + c;
                const int from = 3 * (y * direct.width + direct.width - 1 - x) + c;
                mirrored.pixels[static_cast<std::size_t>(to)] = direct.pixels[static_cast<std::size_t>(from)];
            }
        }
    }
    const Deviation d = against(shown, mirrored, 1);
    std::printf("mirror: flux %.4f, relRMSE %.4f\n", d.mean, d.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.03);
    EXPECT_LT(d.rel_rmse, GetParam() == EmcRays::bvh ? 0.06 : 0.1);
}

// The rays of one pixel in 2 x 2 or 4 x 4 show what each pixel's own do, a little softer: of a mirror and of
// brushed metal.
TEST_P(Specular, ACoarserGridShowsTheSame) {
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.0f, 1.75f);
    for (const float roughness : {0.0f, 0.3f}) {
        const FrameScene scene =
            room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {metal(vec3(1), roughness)}, eye, target);
        const ImageF every = picture(scene, 2);
        for (const int grid : {2, 4}) {
            const Deviation d = against(picture(scene, 2, grid), every, 1);
            std::printf("one ray in %d x %d, roughness %.1f: flux %.4f, relRMSE %.4f\n", grid, grid,
                        static_cast<double>(roughness), d.mean, d.rel_rmse);
            EXPECT_NEAR(d.mean, 1, 0.005);
            EXPECT_LT(d.rel_rmse, grid == 2 ? 0.065 : 0.095);
            EXPECT_GT(d.rel_rmse, 0.01);  // it is coarser
        }
    }
}

// Slats of a mirror before a dull wall, hardly wider than a pixel: each pixel that shows another surface than
// the first of its cell has its own ray.
TEST_P(Specular, ACoarserGridLeavesThinThingsAlone) {
    std::vector<Mesh> slats;
    for (int i = 0; i < 12; ++i) {
        const float z = 0.5f + 0.17f * static_cast<float>(i);
        slats.push_back(
            quad({3.9f - 0.01f * static_cast<float>(i % 3), 0, z}, {0, 0, 0.012f}, {0, 2.6f, 0}, 0));
    }
    const FrameScene scene = room(slats, {metal(vec3(1), 0)}, vec3(2.6f, 1.3f, 1.5f), vec3(4, 1.0f, 1.75f));
    const Deviation d = coarser(scene, 2, "thin mirrors");
    EXPECT_NEAR(d.mean, 1, 0.001);
    EXPECT_LT(d.rel_rmse, 0.01);
}

// Strips of two materials in one plane, side by side, each a pixel and a half wide in the picture.
std::vector<Mesh> strips(const vec3& corner, const vec3& across, const vec3& up, int count) {
    std::vector<Mesh> result;
    const vec3 step = across / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        result.push_back(
            quad(corner + step * static_cast<float>(i), step, up, static_cast<std::uint32_t>(i % 2)));
    }
    return result;
}

// What is polished mirrors a panel behind the eye, which lets no light past its lobe; rays of what is rough
// beside it often miss the panel.
TEST_P(Specular, ACoarserGridKeepsRoughnessesApart) {
    std::vector<Mesh> meshes = strips({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 150);
    meshes.push_back(quad({-2.2f, -2.2f, 1.5f}, {0, 4.4f, 0}, {4.4f, 0, 0}, 2));
    FrameScene scene =
        scene_of(std::move(meshes), {metal(vec3(1), 0.11f), metal(vec3(0.02f), 0.447f), lamp(vec3(kNits))},
                 {}, vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.7f;
    const Deviation d = coarser(scene, 2, "two roughnesses");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.015);
}

// A pane right before the eye, that reflects nothing.
struct Pane {
    explicit Pane(const vec3& eye, const vec3& target) {
        const vec3 towards = glm::normalize(eye - target);
        right = glm::normalize(glm::cross(vec3(0, 1, 0), towards));
        up = glm::cross(towards, right);
        corner = eye - 0.4f * towards - 0.5f * (right + up);
    }
    static Material material(const vec3& colour) {
        Material m = glass(1.5f, 0);
        m.specular = 0;
        m.base_colour = vec4(colour, 1);
        return m;
    }
    vec3 right, up, corner;
};
constexpr vec3 kPaneEye(3.4f, 1.3f, 2.6f), kPaneTarget(0.8f, 0.9f, 0.6f);

TEST_P(Specular, ACoarserGridShowsTheSameThroughAWindow) {
    const Pane pane(kPaneEye, kPaneTarget);
    const FrameScene scene = room({quad(pane.corner, pane.right, pane.up, 0)}, {Pane::material(vec3(0.5f))},
                                  kPaneEye, kPaneTarget);
    const Deviation d = coarser(scene, 2, "a window");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.11);
    EXPECT_GT(d.rel_rmse, 0.01);  // it is coarser
}

// Stained glass: no colour runs into the one beside it.
TEST_P(Specular, ACoarserGridKeepsColoursOfGlassApart) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps panes are as fine as texels";
    }
    const Pane pane(kPaneEye, kPaneTarget);
    const FrameScene scene =
        room(strips(pane.corner, pane.right, pane.up, 250),
             {Pane::material(vec3(0.9f, 0.2f, 0.1f)), Pane::material(vec3(0.1f, 0.3f, 0.9f))}, kPaneEye,
             kPaneTarget);
    const Deviation d = coarser(scene, 2, "stained glass");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.15);
}

// Each ray takes one direction of the lobe of rough glass: no pixel shows fewer of them than all sixteen.
TEST_P(Specular, ACoarserGridShowsTheSameThroughRoughGlass) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps glass is clear";
    }
    const Pane pane(kPaneEye, kPaneTarget);
    Material frosted = Pane::material(vec3(1));
    frosted.roughness = 0.4f;
    const FrameScene scene =
        room({quad(pane.corner, pane.right, pane.up, 0)}, {frosted}, kPaneEye, kPaneTarget);
    const Deviation d = coarser(scene, 2, "rough glass");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.12);
}

// A panel of rough metal reflects as much in a mirror as seen from behind it: its lobe counts once.
TEST_P(Specular, RoughMetalInAMirrorIsAsBrightAsBesideIt) {
    const Material mirror = metal(vec3(1), 0), rough = metal(vec3(0.8f, 0.7f, 0.5f), 0.7f);
    const Mesh panel = quad({0.01f, 0, 0}, {0, 2.6f, 0}, {0, 0, 3}, 0);
    Mesh behind_mirror = panel;
    behind_mirror.material = 1;
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.2f, 1.6f);
    const ImageF shown = picture(
        room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0), behind_mirror}, {mirror, rough}, eye, target),
        3);
    const vec3 flip(-1, 1, 1), behind(2 * 3.99f, 0, 0);
    const ImageF direct = picture(room({panel}, {rough}, eye * flip + behind, target * flip + behind, false));
    double in_mirror = 0, beside = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        in_mirror += static_cast<double>(shown.pixels[i]);
        beside += static_cast<double>(direct.pixels[i]);
    }
    std::printf("rough metal in a mirror: %.4f of what is seen from behind it\n", in_mirror / beside);
    EXPECT_NEAR(in_mirror / beside, 1, 0.1)
        << "what a lobe shows depends on the view, in the mirror it does not";
}

// Straight through, less what its surface reflects.
TEST_P(Specular, AThinWindowShowsWhatStandsBehindIt) {
    const Pane pane(kPaneEye, kPaneTarget);
    const ImageF through = picture(room({quad(pane.corner, pane.right, pane.up, 0)},
                                        {Pane::material(vec3(0.5f))}, kPaneEye, kPaneTarget),
                                   3);
    const ImageF direct = picture(room({}, {}, kPaneEye, kPaneTarget));
    const Deviation d = against(through, direct, 0.5f);
    std::printf("window: flux %.4f, relRMSE %.4f\n", d.mean, d.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.05);
    EXPECT_LT(d.rel_rmse, GetParam() == EmcRays::bvh ? 0.08 : 0.16);
}

// A block of index 1 bends no light and reflects none; what it absorbs is Beer's law.
TEST_P(Specular, ABlockOfGlassAbsorbsByItsThickness) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps glass is as thin as a sheet";
    }
    Material block = glass(1, 1);
    block.attenuation_distance = 0.5f;
    block.attenuation_colour = vec3(0.5f, 1, 0.25f);
    FrameScene scene =
        scene_of({box({-1, 0.2f, -1}, {1, 0.7f, 1}, false, 0), quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 1)},
                 {block, lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    const vec3 got = middle_of(picture(scene));
    EXPECT_NEAR(got.x, 0.5f * kNits, 1);
    EXPECT_NEAR(got.y, 1.0f * kNits, 1);
    EXPECT_NEAR(got.z, 0.25f * kNits, 1);
}

// What shines within water is darker from above by the square of its index.
TEST_P(Specular, WhatLiesInWaterIsDarkerByItsIndexSquared) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps water is as thin as a sheet";
    }
    Material water = glass(1.33f, 1);
    water.double_sided = true;
    FrameScene scene =
        scene_of({quad({-2, 0.5f, 2}, {4, 0, 0}, {0, 0, -4}, 0), quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 1)},
                 {water, lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    const float r = (0.33f / 2.33f) * (0.33f / 2.33f);
    EXPECT_NEAR(middle_of(picture(scene)).x, kNits * (1 - r) / (1.33f * 1.33f), 1);
}

// A slab under a lamp, over nothing: its lower side mirrors as its upper side does, 2 R / (1 + R) together.
TEST_P(Specular, ASlabOfGlassMirrorsWithBothSides) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps glass is as thin as a sheet";
    }
    FrameScene scene =
        scene_of({box({-1, 0.2f, -1}, {1, 0.4f, 1}, false, 0), quad({-2, 3, -2}, {4, 0, 0}, {0, 0, 4}, 1)},
                 {glass(1.5f, 0.2f), lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    EXPECT_NEAR(middle_of(picture(scene)).y, kNits * 2 * 0.04f / 1.04f, 0.1f);
}

// The mean by column: what spreads sideways.
std::vector<double> columns_of(const std::vector<float>& rgb, ivec2 size) {
    std::vector<double> sums(static_cast<std::size_t>(size.x), 0);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            sums[static_cast<std::size_t>(x)] +=
                static_cast<double>(rgb[3 * static_cast<std::size_t>(y * size.x + x) + 1]) / size.y;
        }
    }
    return sums;
}

// Radiance by the path tracer, with all that the materials say.
std::vector<float> path_traced(const FrameScene& scene) {
    reference::PathSettings path;
    path.transport = reference::Transport::full;
    path.spp = 256;
    path.bounces = 3;
    reference::PathTracer tracer(scene, kSize, path, {.radiance = true});
    tracer.render({});
    return tracer.image(reference::PathAov::radiance);
}

// Greatest difference of any value from the right one, in units of the brightest.
template <class T>
double greatest_difference(const std::vector<T>& got, const std::vector<T>& right) {
    T most = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
        most = std::max(most, std::abs(got[i] - right[i]));
    }
    return static_cast<double>(most / *std::ranges::max_element(right));
}

// Of columns.
double spread_against_path(const FrameScene& scene, const ImageF& shown) {
    return greatest_difference(columns_of(shown.pixels, kSize), columns_of(path_traced(scene), kSize));
}

// Few of a glossy floor's rays meet a small lamp: its highlight is none of squares around those that do.
TEST_P(Specular, ASmallLampsHighlightIsSmooth) {
    FrameScene scene = scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0),
                                 quad({-0.04f, 1, -0.64f}, {0.08f, 0, 0}, {0, 0, 0.08f}, 1)},
                                {metal(vec3(0.9f), 0.3f), lamp(vec3(10000))}, {}, vec3(0, 1, 1.5f), vec3(0));
    scene.camera.camera.y_fov = 0.6f;
    const double off = greatest_difference(picture(scene).pixels, path_traced(scene));
    std::printf("a small lamp's highlight: a pixel is off by %.4f\n", off);
    EXPECT_LT(off, 0.1);
}

// A lamp half behind frosted glass, in a mirror of it too: its edge is as soft as the path tracer has it.
TEST_P(Specular, RoughGlassSpreadsWhatIsSeenThroughIt) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps glass is clear";
    }
    for (const float thickness : {0.0f, 0.02f}) {
        Material frosted = glass(1.5f, thickness);
        frosted.roughness = 0.4f;
        FrameScene scene = scene_of({box({-1, -1, -0.02f}, {1, 1, 0}, false, 0),
                                     quad({-1.5f, -1.5f, -0.4f}, {1.5f, 0, 0}, {0, 3, 0}, 1)},
                                    {frosted, lamp(vec3(kNits))}, {}, vec3(0, 0, 1), vec3(0));
        if (thickness == 0) {
            scene = scene_of({quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0),
                              quad({-1.5f, -1.5f, -0.4f}, {1.5f, 0, 0}, {0, 3, 0}, 1)},
                             {frosted, lamp(vec3(kNits))}, {}, vec3(0, 0, 1), vec3(0));
        }
        scene.camera.camera.y_fov = 0.6f;
        const double off = spread_against_path(scene, picture(scene));
        std::printf("frosted glass, %g thick: a column is off by %.4f\n", static_cast<double>(thickness),
                    off);
        EXPECT_LT(off, 0.12);
    }
}

// Brushed metal in a mirror mirrors a lamp's edge softly.
TEST_P(Specular, GlossyMetalInAMirrorIsGlossy) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps second mirrors are even";
    }
    FrameScene scene = scene_of(
        {quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0), quad({2, -2, 1.5f}, {-4, 0, 0}, {0, 4, 0}, 1),
         quad({-4, -3, -1.5f}, {4, 0, 0}, {0, 6, 0}, 2)},
        {metal(vec3(1), 0), metal(vec3(0.9f), 0.35f), lamp(vec3(kNits))}, {}, vec3(0, 0, 1), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.7f;
    const double off = spread_against_path(scene, picture(scene, 3));
    std::printf("glossy in a mirror: a column is off by %.4f\n", off);
    EXPECT_LT(off, 0.12);
}

// Neighbours' rays tell of brushed metal that a slab mirrors, not of what is seen through the slab: a lamp's
// edge.
TEST_P(Specular, GlassThatMirrorsBrushedMetalIsClear) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps glass is as thin as a sheet";
    }
    FrameScene scene = scene_of(
        {box({-1, 0.2f, -1}, {1, 0.4f, 1}, false, 0), quad({-2, 3, -2}, {4, 0, 0}, {0, 0, 4}, 1),
         quad({-2, -0.2f, 2}, {2, 0, 0}, {0, 0, -4}, 2)},
        {glass(1.5f, 0.2f), metal(vec3(0.9f), 0.3f), lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    const double off = spread_against_path(scene, picture(scene, 3));
    std::printf("a lamp's edge through a slab: a column is off by %.4f\n", off);
    EXPECT_LT(off, 0.05);
}

TEST_P(Specular, NothingIsTracedWhereNothingShinesNorChanges) {
    const auto entry = [](Bench& bench) {
        for (const PlanEntry& e : bench.technique().statistics(false).plan.entries) {
            if (e.pass == "specular") {
                return e;
            }
        }
        return PlanEntry{};
    };
    Bench bench;
    bench.settings = settings();
    FrameScene dull = room({}, {}, vec3(3, 1.3f, 2), vec3(1));
    bench.frame(dull, kSize);
    EXPECT_FALSE(entry(bench).on);
    FrameScene scene = room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {metal(vec3(1), 0)},
                            vec3(2, 1.3f, 2), vec3(4, 1, 1));
    Bench shiny;
    shiny.settings = settings();
    shiny.frame(scene, kSize);
    EXPECT_TRUE(entry(shiny).on);
    hold_still(scene);
    scene.lights[0].light.intensity *= 2;
    scene.changes.lights = true;
    const ImageF before = shiny.renderer().read(render::Aov::radiance);
    shiny.frame(scene, kSize);
    EXPECT_EQ(entry(shiny).size, "no ray");  // lit anew alone
    EXPECT_NEAR(middle_of(shiny.renderer().read(render::Aov::radiance)).x / middle_of(before).x, 2, 0.1);
    hold_still(scene);
    for (int f = 0; f < 20; ++f) {
        shiny.frame(scene, kSize);
    }
    EXPECT_FALSE(entry(shiny).on);
}

}  // namespace
}  // namespace lanthorn::gi::test
