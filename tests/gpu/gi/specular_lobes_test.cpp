// Lobes of what is not quite polished, against the path tracer: highlights, frosted glass, brushed metal in
// mirrors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/reference/path_tracer.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/specular_room.h"

namespace lanthorn::gi::test {
namespace {

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
std::vector<float> lobes_by_path(const FrameScene& scene) {
    reference::PathSettings path;
    path.transport = reference::Transport::full;
    path.spp = 256;
    path.bounces = 3;
    return path_picture(scene, kSize, path, reference::PathAov::radiance);
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
    return greatest_difference(columns_of(shown.pixels, kSize), columns_of(lobes_by_path(scene), kSize));
}

// Few of a glossy floor's rays meet a small lamp: its highlight is none of squares around those that do.
TEST_P(Specular, ASmallLampsHighlightIsSmooth) {
    FrameScene scene = scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0),
                                 quad({-0.04f, 1, -0.64f}, {0.08f, 0, 0}, {0, 0, 0.08f}, 1)},
                                {metal(vec3(0.9f), 0.3f), lamp(vec3(10000))}, {}, vec3(0, 1, 1.5f), vec3(0));
    scene.camera.camera.y_fov = 0.6f;
    const double off = greatest_difference(picture(scene).pixels, lobes_by_path(scene));
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

}  // namespace
}  // namespace lanthorn::gi::test
