// The filter and the up-sampling alone, on light that is known.
#include "gi_module/techniques/coarse-path/svgf_filter.h"

#include <gtest/gtest.h>

#include "gi_module/reference/random.h"
#include "gi_module/techniques/coarse-path/coarse_upsampling.h"
#include "gi_module/techniques/coarse-path/point_history.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace svgf_filter_test {

constexpr ivec2 kSize(128);
constexpr int kSpacing = 4;

// A floor and a wall that meet in a line, seen from the front.
FrameScene corner() {
    return scene_of({quad({-4, 0, 4}, {8, 0, 0}, {0, 0, -4}, 0), quad({-4, 0, 0}, {8, 0, 0}, {0, 4, 0}, 0)},
                    {lambertian(vec3(0.5f))}, {point_light({0, 2, 2}, 100)}, {0, 1.5f, 4}, {0, 0.5f, 0});
}

class Filter : public ::testing::Test {
  protected:
    Bench bench{TechniqueKind::none};
    FrameScene scene = corner();
    gpu::PassTimer timer{false, true};
    CoarseGrid grid;
    SvgfFilter filter;
    CoarseUpsampling upsampling;

    void SetUp() override {
        bench.frame(scene, kSize);
        grid.find(inputs(), kSpacing);
    }
    render::FrameInputs inputs() { return bench.renderer().inputs(scene, timer); }

    template <class Light>
    std::vector<PointEstimate> estimates(const Light& light, float samples, float variance) {
        std::vector<PointEstimate> result;
        for (const SurfacePoint& point : grid.points().points) {
            PointEstimate& e = result.emplace_back();
            if (point.distance > 0) {
                e.irradiance = light(point);
                const float l = glm::dot(e.irradiance, vec3(0.2126f, 0.7152f, 0.0722f));
                e.second = l * l + variance;
                e.samples = samples;
            }
        }
        return result;
    }
    // Four floats a cell of the lattice.
    std::vector<float> filtered(const std::vector<PointEstimate>& estimates, int levels) {
        return filter
            .filter(inputs(), grid.points().cells, grid.buffer(), gpu::Buffer::from(estimates), levels, 4)
            .read_floats(4);
    }
};

TEST_F(Filter, KeepsConstantLight) {
    const auto known = estimates([](const SurfacePoint&) { return vec3(3, 2, 1); }, 64, 1);
    const std::vector<float> light = filtered(known, 5);
    int lit = 0;
    for (std::size_t i = 0; i < grid.points().lattice(); ++i) {
        if (grid.points().points[i].distance > 0) {
            EXPECT_NEAR(light[4 * i], 3, 1e-4);
            EXPECT_NEAR(light[4 * i + 2], 1, 1e-4);
            ++lit;
        } else {
            EXPECT_EQ(light[4 * i], 0);
        }
    }
    EXPECT_GT(lit, 500);
}

// Light on the wall stays on the wall, however noisy it is.
TEST_F(Filter, KeepsTheEdgeBetweenPlanes) {
    const auto known =
        estimates([](const SurfacePoint& p) { return vec3(p.normal.y > 0.5f ? 1 : 5); }, 64, 1e4f);
    const std::vector<float> light = filtered(known, 5);
    int floor = 0, wall = 0;
    for (std::size_t i = 0; i < grid.points().lattice(); ++i) {
        const SurfacePoint& p = grid.points().points[i];
        if (p.distance > 0) {
            EXPECT_NEAR(light[4 * i], p.normal.y > 0.5f ? 1 : 5, 1e-3);
            ++(p.normal.y > 0.5f ? floor : wall);
        }
    }
    EXPECT_GT(floor, 100);
    EXPECT_GT(wall, 100);
}

// A step in light on one plane is kept if the samples are sure of it.
TEST_F(Filter, KeepsAStepThatIsSure) {
    const auto known =
        estimates([](const SurfacePoint& p) { return vec3(p.position.x < 0 ? 1 : 5); }, 64, 1e-6f);
    const std::vector<float> light = filtered(known, 5);
    for (std::size_t i = 0; i < grid.points().lattice(); ++i) {
        const SurfacePoint& p = grid.points().points[i];
        // The first level's guide is a 3x3 mean: the cells at the step differ by less than sigma there.
        const bool near_step = std::abs(p.position.x) < 0.25f * p.distance;
        if (p.distance > 0 && !near_step) {
            EXPECT_NEAR(light[4 * i], p.position.x < 0 ? 1 : 5, 0.02);
        }
    }
}

// Noise is averaged away, and the variance that the filter gives is that of what it gives.
TEST_F(Filter, TakesNoiseAwayAndKnowsHowMuchIsLeft) {
    constexpr float kDeviation = 0.5f;
    const auto known = estimates(
        [](const SurfacePoint& p) {
            const std::uint32_t bits = reference::mix_bits(p.pixel + 77);
            return vec3(10 + kDeviation * std::sqrt(12.0f) * (reference::unit_float(bits) - 0.5f));
        },
        64, kDeviation * kDeviation * 64);
    double before = 0, after = 0, told = 0, cells = 0;
    const std::vector<float> light = filtered(known, 3);
    for (std::size_t i = 0; i < grid.points().lattice(); ++i) {
        if (grid.points().points[i].distance > 0) {
            before += std::pow(static_cast<double>(known[i].irradiance.x) - 10, 2);
            after += std::pow(static_cast<double>(light[4 * i]) - 10, 2);
            told += static_cast<double>(light[4 * i + 3]);
            cells += 1;
        }
    }
    std::printf("filter: variance %.4f -> %.5f, told %.5f\n", before / cells, after / cells, told / cells);
    EXPECT_LT(after, 0.05 * before);
    // Levels that meet the same points again count their noise as new: what is told is less, not more.
    EXPECT_LT(told, after);
    EXPECT_GT(told, 0.1 * after);
}

// Every pixel between the lattice's gets constant light, and light that is linear on a plane is interpolated.
TEST_F(Filter, UpsamplingKeepsConstantLightAtEveryPixel) {
    const auto known =
        estimates([](const SurfacePoint& p) { return vec3(p.normal.y > 0.5f ? 1 : 5); }, 64, 1);
    const gpu::Buffer buffer = gpu::Buffer::from(known);
    const gpu::Texture& light = filter.filter(inputs(), grid.points().cells, grid.buffer(), buffer, 2, 4);
    const std::vector<float> picture = upsampling.irradiance(inputs(), grid, light, buffer).read_floats(4);
    const ImageF normals = bench.renderer().read(render::Aov::normal);
    const ImageF depth = bench.renderer().read(render::Aov::depth);
    int lit = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const auto from_top = static_cast<std::size_t>((kSize.y - 1 - y) * kSize.x + x);
            const float value = picture[4 * static_cast<std::size_t>(y * kSize.x + x)];
            if (depth.pixels[from_top] > 0) {
                EXPECT_NEAR(value, normals.pixels[3 * from_top + 1] > 0.5f ? 1 : 5, 1e-3) << x << ' ' << y;
                ++lit;
            } else {
                EXPECT_EQ(value, 0);
            }
        }
    }
    EXPECT_GT(lit, kSize.x * kSize.y / 2);
}

// A rod thinner than the lattice has points of its own, and they find each other's light.
TEST(CoarseGrid, AddsPointsWhereTheLatticeMissesASurface) {
    FrameScene scene = corner();
    FrameScene with_rod =
        scene_of({quad({-4, 0, 4}, {8, 0, 0}, {0, 0, -4}, 0), quad({-4, 0, 0}, {8, 0, 0}, {0, 4, 0}, 0),
                  box({0.30f, 0, 1}, {0.36f, 1.2f, 1.05f}, false, 0)},
                 {lambertian(vec3(0.5f))}, {point_light({0, 2, 2}, 100)}, {0, 1.5f, 4}, {0, 0.5f, 0});
    Bench bench{TechniqueKind::none};
    gpu::PassTimer timer(false, true);
    CoarseGrid grid;
    bench.frame(scene, kSize);
    grid.find(bench.renderer().inputs(scene, timer), 8);
    const std::size_t without = grid.points().extras().size();
    bench.frame(with_rod, kSize);
    grid.find(bench.renderer().inputs(with_rod, timer), 8);
    const auto extras = grid.points().extras();
    std::size_t on_rod = 0;
    for (const SurfacePoint& p : extras) {
        on_rod += p.position.z > 0.99f && p.position.z < 1.06f && p.position.y > 0.01f ? 1 : 0;
        EXPECT_GT(p.distance, 0);
    }
    std::printf("extra points: %zu without the rod, %zu with it, %zu on it\n", without, extras.size(),
                on_rod);
    EXPECT_GT(on_rod, 5u);
    EXPECT_LT(extras.size(), 400u);
    EXPECT_TRUE(std::ranges::is_sorted(extras, {}, &SurfacePoint::pixel));
}

}  // namespace svgf_filter_test
}  // namespace lanthorn::gi::test
