// The Cornell box as measured (Cornell University, Program of Computer Graphics, 1998): what must hold of its
// light although no formula gives it.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "tests/unit/reference/scenes.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::reference::test {
namespace {

constexpr int kSide = 48;

class Cornell : public testing::Test {
  protected:
    Cornell() {
        const std::vector<ecs::Entity> entities = spawn(world_, scene_generator::cornell());
        for (const ecs::Entity e : entities) {
            if (world_.has<CameraComponent>(e)) {
                frame_ = Extractor().extract(world_, e);
            }
        }
        settings_.spp = 128;
    }
    std::vector<float> indirect(int bounces) {
        settings_.bounces = bounces;
        PathTracer tracer(frame_, ivec2(kSide), settings_, {.indirect = true});
        tracer.render({});
        EXPECT_EQ(tracer.nan_count(), 0u);
        return tracer.image(PathAov::indirect);
    }
    static double mean(const std::vector<float>& image) {
        return std::accumulate(image.begin(), image.end(), 0.0) / static_cast<double>(image.size());
    }

    ecs::World world_;
    FrameScene frame_;
    PathSettings settings_;
};

// Light loses more than the whitest wall absorbs at every reflection (rho = 0.74), and the front is open.
TEST_F(Cornell, EveryReflectionLosesLight) {
    std::vector<double> sums{0};
    for (int bounces = 1; bounces <= 4; ++bounces) {
        sums.push_back(mean(indirect(bounces)));
    }
    double last = sums[1];
    for (std::size_t b = 2; b < sums.size(); ++b) {
        const double gained = sums[b] - sums[b - 1];
        EXPECT_GT(gained, 0.3 * last) << b;
        EXPECT_LT(gained, 0.74 * last) << b;
        last = gained;
    }
    settings_.unlimited = true;
    const double all = mean(indirect(0));
    EXPECT_GT(all, sums.back() + last * 0.3);
    EXPECT_LT(all, sums.back() + last * 0.74 / (1 - 0.74));
}

// The floor beside the red wall is redder than the one beside the green wall.
TEST_F(Cornell, WallsBleedTheirColour) {
    const std::vector<float> image = indirect(1);
    const auto ratio = [&](int x, int y) {  // red over green, of 5 x 5 pixels
        double red = 0, green = 0;
        for (int j = -2; j <= 2; ++j) {
            for (int i = -2; i <= 2; ++i) {
                const std::size_t at = 3 * static_cast<std::size_t>((y + j) * kSide + x + i);
                red += static_cast<double>(image[at]);
                green += static_cast<double>(image[at + 1]);
            }
        }
        return red / green;
    };
    const double left = ratio(4, 44), right = ratio(43, 44);
    EXPECT_GT(left, 1.3 * right) << "the red wall is on the left";
}

// Diffuse walls: what the full transport does must be the same within noise.
TEST_F(Cornell, BothTransportsAgree) {
    const double diffuse = mean(indirect(2));
    settings_.transport = Transport::full;
    EXPECT_NEAR(mean(indirect(2)) / diffuse, 1, 0.01);
}

}  // namespace
}  // namespace lanthorn::reference::test
