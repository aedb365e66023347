#include "gi_module/techniques/coarse-path/point_history.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"
#include "tests/unit/coarse-path/floor_points.h"

namespace lanthorn::gi::test {
namespace {

// Gives every point one sample, by its position.
template <class Light>
void add_samples(PointHistory& history, const GridPoints& points, const Light& light) {
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const vec3 value = light(points.points[i].position);
        const float l = luminance(value);
        history.estimates()[i].add(value, l * l, 1);
    }
}

vec3 slope(const vec3& p) {
    return vec3(1 + p.x, 2 + p.z, 3 + p.x - p.z);
}

struct Seen {
    int known = 0, unknown = 0;
    float furthest = 0;  // of the known ones from what `light` says
};

template <class Light>
Seen seen(const PointHistory& history, const GridPoints& points, const Light& light) {
    Seen result;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const PointEstimate& estimate = history.estimates()[i];
        if (estimate.samples > 0) {
            ++result.known;
            const vec3 off = glm::abs(estimate.irradiance - light(points.points[i].position));
            result.furthest = std::max({result.furthest, off.x, off.y, off.z});
        } else {
            ++result.unknown;
        }
    }
    return result;
}

class History : public ::testing::Test {
  protected:
    reference::TileWorkers workers{1};
    PointHistory history;

    void see(const GridPoints& points, const PointView& view, std::span<const MovedInstance> movers = {}) {
        history.follow(points, view, movers, workers);
    }
};

TEST(PointEstimate, IsTheMeanAndTheVarianceOfItsSamples) {
    PointEstimate estimate;
    estimate.add(vec3(1 + 2), 1 + 4, 2);
    estimate.add(vec3(6), 36, 1);
    EXPECT_FLOAT_EQ(estimate.irradiance.x, 3);
    EXPECT_FLOAT_EQ(estimate.samples, 3);
    // Of the samples 1, 2 and 6: 7; of their mean: a third.
    EXPECT_NEAR(estimate.variance(), 7.0 / 3, 1e-5);
}

// Variance of a mean of n samples is that of one over n.
TEST(PointEstimate, VarianceFallsAsOneOverN) {
    double variance[2] = {0, 0};
    const int counts[2] = {16, 256};
    for (int k = 0; k < 2; ++k) {
        for (std::uint32_t point = 0; point < 400; ++point) {
            PointEstimate estimate;
            for (int i = 0; i < counts[k]; ++i) {
                const float x = reference::unit_float(
                    reference::mix_bits(reference::mix_bits(point + 1) + static_cast<std::uint32_t>(i)));
                estimate.add(vec3(x), x * x, 1);
            }
            variance[k] += static_cast<double>(estimate.variance()) / 400;
        }
        // Of a number spread evenly over 0..1: 1/12.
        EXPECT_NEAR(variance[k] * counts[k] * 12, 1, 0.05) << counts[k];
    }
    EXPECT_NEAR(variance[0] / variance[1], 16, 1);
}

TEST_F(History, IsKeptUnderAStillCamera) {
    const PointView view = above(0, 0);
    const GridPoints points = floor_points(view, 4);
    see(points, view);
    add_samples(history, points, slope);
    see(points, view);
    const Seen now = seen(history, points, slope);
    EXPECT_EQ(now.unknown, 0);
    EXPECT_LT(now.furthest, 1e-4f);
}

// A camera that walks sees what it saw where it saw it: light that is linear on the floor comes out as it
// was, and only what comes into the picture is new.
TEST_F(History, FollowsTheSurfaceUnderAWalkingCamera) {
    const PointView before = above(0, 0), now = above(0.3f, 0.1f);
    const GridPoints points = floor_points(before, 4);
    see(points, before);
    add_samples(history, points, slope);
    const GridPoints moved = floor_points(now, 4);
    see(moved, now);
    const Seen after = seen(history, moved, slope);
    // Bilinear of what is linear, but at the rim, where it is the nearest.
    EXPECT_LT(after.furthest, 0.15f);
    int beyond = 0;
    for (const SurfacePoint& p : moved.points) {
        const float half = glm::length(before.camera.right) * 2;
        beyond += std::abs(p.position.x) > half || std::abs(p.position.z) > half ? 1 : 0;
    }
    EXPECT_GT(beyond, 0);
    EXPECT_NEAR(after.unknown, beyond, 16);  // half a column and half a row
}

TEST_F(History, IsDroppedWhenTheCameraCuts) {
    const PointView before = above(0, 0), now = above(50, 0);
    const GridPoints points = floor_points(before, 4);
    see(points, before);
    add_samples(history, points, slope);
    const GridPoints elsewhere = floor_points(now, 4);
    see(elsewhere, now);
    EXPECT_EQ(seen(history, elsewhere, slope).known, 0);
}

// A table's top comes into the picture where the floor was.
TEST_F(History, IsNotTakenFromAnotherSurface) {
    const PointView view = above(0, 0);
    const GridPoints floor = floor_points(view, 4), table = floor_points(view, 4, 0.1f);
    see(floor, view);
    add_samples(history, floor, slope);
    see(table, view);
    EXPECT_EQ(seen(history, table, slope).known, 0);
}

TEST_F(History, GoesWithWhatMoves) {
    const PointView view = above(0, 0);
    const GridPoints top = floor_points(view, 4, 0.5f), higher = floor_points(view, 4, 0.6f);
    see(top, view);
    add_samples(history, top, slope);
    MovedInstance lift;
    lift.bounds.add(vec3(-9, 0, -9));
    lift.bounds.add(vec3(9, 0.6001f, 9));
    lift.to_before = glm::translate(mat4(1), vec3(0, -0.1f, 0));
    see(higher, view, std::span(&lift, 1));
    const Seen now = seen(history, higher, slope);
    EXPECT_EQ(now.unknown, 0);
    EXPECT_LT(now.furthest, 0.15f);
}

// The world's origin of render space is moved, and nothing else.
TEST_F(History, OutlivesAnotherOrigin) {
    const PointView before = above(0, 0);
    const GridPoints points = floor_points(before, 4);
    see(points, before);
    add_samples(history, points, slope);
    const PointView now = above(-5, 0, dvec3(5, 0, 0));
    const GridPoints same = floor_points(now, 4);
    see(same, now);
    EXPECT_EQ(seen(history, same, slope).unknown, 0);
}

// Extra points are found again between the pixels of the lattice.
TEST_F(History, KnowsExtraPoints) {
    const PointView view = above(0, 0);
    GridPoints points = floor_points(view, 8);
    for (const ivec2 pixel : {ivec2(10, 21), ivec2(11, 21), ivec2(50, 33)}) {
        points.points.push_back(floor_point(view, pixel, 0.5f));
    }
    see(points, view);
    add_samples(history, points, slope);
    see(points, view);
    const Seen now = seen(history, points, slope);
    EXPECT_EQ(now.unknown, 0);
    EXPECT_LT(now.furthest, 0.05f);
}

// The mean of `frames` frames, then an exponential one: alpha = 1 / frames.
TEST_F(History, ForgetsExponentially) {
    const PointView view = above(0, 0);
    const GridPoints points = floor_points(view, 8);
    see(points, view);
    constexpr int kFrames = 4;
    for (int frame = 1; frame <= 12; ++frame) {
        history.age(kFrames);
        add_samples(history, points, [&](const vec3&) { return vec3(frame <= 6 ? 1 : 0); });
        const float expected = frame <= 6 ? 1 : std::pow(0.75f, static_cast<float>(frame - 6));
        EXPECT_NEAR(history.estimates()[5].irradiance.x, expected, 1e-5f) << frame;
        EXPECT_NEAR(history.estimates()[5].samples, std::min(frame, kFrames), 1e-4f) << frame;
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
