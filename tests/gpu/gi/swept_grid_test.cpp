// Rays across what many movers sweep: none may be missed, and few that cross nothing may count.
#include "gi_module/techniques/emc/gather/swept_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gi_module/techniques/emc/gather/mover_programs.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

struct Ray {
    vec3 start{0};
    float length = 0;
    vec3 direction{0};
    float inside_counts = 1;
};

bool crosses(const Aabb& box, const Ray& ray) {
    const vec3 a = (box.lower - ray.start) / ray.direction;
    const vec3 b = (box.upper - ray.start) / ray.direction;
    const vec3 near = glm::min(a, b), far = glm::max(a, b);
    return std::max({near.x, near.y, near.z, 0.0f}) <= std::min({far.x, far.y, far.z, ray.length});
}

bool crosses_any(const std::vector<Aabb>& boxes, const Ray& ray) {
    return std::ranges::any_of(boxes, [&](const Aabb& box) { return crosses(box, ray); });
}

// A hundred people in a hall of 24 by 24 by 5 metres, standing along `up`.
std::vector<Aabb> crowd(int up) {
    const int u = (up + 1) % 3, v = (up + 2) % 3;
    std::vector<Aabb> boxes;
    for (int i = 0; i < 100; ++i) {
        vec3 feet(0);
        feet[u] = 2.4f * static_cast<float>(i % 10) + 0.3f * std::sin(static_cast<float>(i));
        feet[v] = 2.4f * static_cast<float>(i / 10) + 0.3f * std::cos(static_cast<float>(i));
        vec3 size(0.5f);
        size[up] = i == 0 ? 4.8f : 1.8f;  // one with a flag: the others have air above
        boxes.push_back({feet, feet + size});
    }
    return boxes;
}

// Off the floor and as far as the walls or the ceiling, as those of a gather.
std::vector<Ray> rays_from_the_floor(int up, std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        vec3 d(2 * unit(random) - 1, 2 * unit(random) - 1, 2 * unit(random) - 1);
        d[up] = std::abs(d[up]);
        ray.direction = glm::normalize(d);
        ray.start = 24.0f * vec3(unit(random), unit(random), unit(random));
        ray.start[up] = 0;
        ray.length = std::min(5 / ray.direction[up], 20 * unit(random));
    }
    return rays;
}

std::vector<bool> crossed(const std::vector<Aabb>& boxes, const std::vector<Ray>& rays) {
    SweptGrid grid;
    grid.fill(boxes, 1e-3f);
    MoverPrograms programs({"tests/gpu/gi/grid_rays.comp"}, {});
    const gpu::Buffer given = gpu::Buffer::from(rays);
    const gpu::Buffer found(rays.size() * sizeof(std::uint32_t));
    const gpu::Program& program = programs.use(grid, 0);
    given.bind_storage(0);
    found.bind_storage(1);
    program.dispatch(ivec2(static_cast<int>(rays.size()), 1), ivec2(64, 1));
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const auto words = found.read<std::uint32_t>(rays.size());
    return {words.begin(), words.end()};
}

class SweptGrids : public testing::TestWithParam<int> {};  // the axis that people stand along

TEST_P(SweptGrids, MissNoRayAndLetThoseBetweenPass) {
    const Bench bench;
    const std::vector<Aabb> boxes = crowd(GetParam());
    const std::vector<Ray> rays = rays_from_the_floor(GetParam(), 20000);
    const std::vector<bool> by_grid = crossed(boxes, rays);
    int missed = 0, crossing = 0, stale = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool crosses = crosses_any(boxes, rays[i]);
        crossing += crosses ? 1 : 0;
        stale += by_grid[i] ? 1 : 0;
        missed += crosses && !by_grid[i] ? 1 : 0;
    }
    EXPECT_EQ(missed, 0);
    EXPECT_GT(crossing, 4000);
    EXPECT_LT(stale, 1.8 * crossing);
}

// What a mover carries along leaves the mover that it lies on, but may meet another.
TEST_P(SweptGrids, LetRaysOutOfWhereTheyStart) {
    const Bench bench;
    const int up = GetParam();
    const std::vector<Aabb> boxes = crowd(up);
    std::vector<Ray> rays;
    for (const Aabb& box : boxes) {
        vec3 across(0.01f);
        across[(up + 1) % 3] = 1;
        vec3 above(0.01f);
        above[up] = 1;
        vec3 start = box.centre();
        start[up] = box.lower[up] + 0.9f;
        rays.push_back({start, 1.2f, glm::normalize(across), 1});  // from within, which counts
        rays.push_back({start, 1.2f, glm::normalize(across), 0});
        rays.push_back({start, 3, glm::normalize(above), 0});
        rays.push_back({start, 24, glm::normalize(across), 0});  // as far as the others
    }
    const std::vector<bool> by_grid = crossed(boxes, rays);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(by_grid[4 * i]) << i;
        EXPECT_FALSE(by_grid[4 * i + 1]) << i;
        EXPECT_FALSE(by_grid[4 * i + 2]) << i;
        EXPECT_TRUE(by_grid[4 * i + 3] || i % 10 == 9) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Axes, SweptGrids, testing::Values(0, 1, 2));

TEST(SweptGrid, IsEmptyWithoutMovers) {
    SweptGrid grid;
    grid.fill({}, 0.1f);
    EXPECT_TRUE(grid.empty());
}

}  // namespace
}  // namespace lanthorn::gi::test
