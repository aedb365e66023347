// The reference at some of a picture's pixels: the same numbers as of the whole picture.
#include "gi_module/reference/sparse_paths.h"

#include <gtest/gtest.h>

#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

FrameScene lit_corner() {
    return scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0), quad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, 0)},
                    {lambertian(vec3(0.7f, 0.5f, 0.3f))}, {point_light(vec3(0.5f, 2, 0.5f), 100)},
                    vec3(0, 1, 3), vec3(0, 0.8f, -2));
}

TEST(SparsePaths, FindsWhatThePathTracerFindsAtItsPixels) {
    const FrameScene scene = lit_corner();
    const ivec2 size(30, 22);
    PathSettings settings;
    settings.spp = 6;
    PathTracer tracer(scene, size, settings, {.indirect = true});
    tracer.render({});
    const std::vector<float> image = tracer.image(PathAov::indirect), coverage = tracer.coverage();
    SparsePaths sparse(scene, size, 4, settings);
    ASSERT_TRUE(sparse.trace(4, {}));
    ASSERT_TRUE(sparse.trace(2, {}));
    EXPECT_EQ(sparse.spp(), 6);
    EXPECT_EQ(sparse.cells(), ivec2(7, 5));
    const std::vector<float> found = sparse.film().mean();
    int lit = 0;
    for (int cell = 0; cell < 35; ++cell) {
        const ivec2 at = sparse.pixel(cell);
        EXPECT_EQ(at, ivec2(cell % 7, cell / 7) * 4 + 2);
        const auto pixel = static_cast<std::size_t>(at.y * size.x + at.x);
        EXPECT_EQ(sparse.lit(cell), coverage[pixel] == 1.0f);
        lit += sparse.lit(cell) ? 1 : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(found[3 * static_cast<std::size_t>(cell) + c], image[3 * pixel + c]) << cell;
        }
    }
    EXPECT_GT(lit, 15);
    EXPECT_LT(lit, 35);
}

TEST(SparsePaths, StopsWhenItIsTold) {
    const FrameScene scene = lit_corner();
    SparsePaths sparse(scene, ivec2(400), 4, {});
    int asked = 0;
    EXPECT_FALSE(sparse.trace(1000, [&] { return ++asked < 3; }));
    EXPECT_EQ(asked, 3);
    EXPECT_LT(sparse.spp(), 10);
}

}  // namespace
}  // namespace lanthorn::reference::test
