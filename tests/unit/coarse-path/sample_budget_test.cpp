#include "gi_module/techniques/coarse-path/sample_budget.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/unit/coarse-path/floor_points.h"

namespace lanthorn::gi::test {
namespace {

// Points with `samples` of mean 1 and this variance each.
PointEstimate estimate(float samples, float variance) {
    PointEstimate result;
    result.irradiance = vec3(1);
    result.second = 1 + variance;
    result.samples = samples;
    return result;
}

double share(const std::vector<int>& counts, std::size_t begin, std::size_t end) {
    return std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(begin),
                           counts.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
}

class Budget : public ::testing::Test {
  protected:
    GridPoints points = floor_points(above(0, 0), 1);
    std::size_t count = points.points.size();
    std::vector<PointEstimate> known = std::vector<PointEstimate>(count, estimate(16, 1));
};

TEST_F(Budget, IsSpentEvenlyOverEvenNoise) {
    for (const float mean : {0.5f, 1.0f, 2.25f}) {
        const std::vector<int> counts = share_samples(points, known, mean, 8, 3);
        EXPECT_NEAR(share(counts, 0, count) / static_cast<double>(count) / static_cast<double>(mean), 1,
                    0.03);
        for (const int n : counts) {
            EXPECT_LE(std::abs(static_cast<float>(n) - mean), 1.0f);
        }
    }
}

// Rows below the middle are four times as noisy: relative standard errors 1 : 4, mean 2.5, rates
// 1/4 + 3/4 (0.4 or 1.6).
TEST_F(Budget, GoesWhereTheNoiseIs) {
    std::fill(known.begin() + static_cast<std::ptrdiff_t>(count / 2), known.end(), estimate(16, 16));
    const std::vector<int> counts = share_samples(points, known, 4, 8, 3);
    EXPECT_NEAR(share(counts, count / 2, count) / share(counts, 0, count / 2), 1.45 / 0.55, 0.05);
    EXPECT_NEAR(share(counts, 0, count) / static_cast<double>(count), 4, 0.05);
}

TEST_F(Budget, GoesToWhatIsNewlySeen) {
    std::fill(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count / 8), PointEstimate());
    const std::vector<int> counts = share_samples(points, known, 2, 8, 3);
    EXPECT_NEAR(share(counts, 0, count / 8) * 7 / share(counts, count / 8, count), 4, 0.2);
    for (std::size_t i = 0; i < count / 8; ++i) {
        EXPECT_GE(counts[i], 1);
    }
}

TEST_F(Budget, LeavesOutTheBackground) {
    for (std::size_t i = 0; i < count / 2; ++i) {
        points.points[i].distance = 0;
    }
    const std::vector<int> counts = share_samples(points, known, 2, 8, 3);
    EXPECT_EQ(share(counts, 0, count / 2), 0);
    EXPECT_NEAR(share(counts, count / 2, count) / static_cast<double>(count / 2), 2, 0.05);
}

TEST_F(Budget, RoundsAnewInEveryFrame) {
    std::vector<int> sums(count, 0);
    for (std::uint32_t frame = 0; frame < 64; ++frame) {
        const std::vector<int> counts = share_samples(points, known, 0.25f, 8, frame);
        for (std::size_t i = 0; i < count; ++i) {
            sums[i] += counts[i];
        }
    }
    const auto [least, most] = std::ranges::minmax(sums);
    EXPECT_GT(least, 2);  // 16 expected, standard deviation 3.5
    EXPECT_LT(most, 32);
}

}  // namespace
}  // namespace lanthorn::gi::test
