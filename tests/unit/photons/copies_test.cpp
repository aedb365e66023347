// What lies exactly in each other's place.
#include "gi_module/shared/photons/copies.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

using Firsts = std::vector<std::uint32_t>;

TEST(Copies, OfTrianglesAreTheSameCornersTheSameWayRound) {
    //                                        0        again    from another corner  turned round  another
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 1, 2, 1, 2, 0, 0, 2, 1, 1, 2, 3};
    const std::vector<vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(first_of_copies(indices, vertex_places(corners)), (Firsts{0, 0, 0, 3, 4}));
    // Vertices of their own in the same places.
    const std::vector<vec3> twice{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> each{0, 1, 2, 5, 3, 4};
    EXPECT_EQ(first_of_copies(each, vertex_places(twice)), (Firsts{0, 0}));
}

TEST(Copies, OfInstancesHaveTheSameTrianglesInTheSamePlaces) {
    const Mesh box = support::box(vec3(0), vec3(1), true, 0),
               inward = support::box(vec3(0), vec3(1), false, 0),
               higher = support::box(vec3(0), vec3(1, 1.001f, 1), true, 0);
    FrameScene scene = support::scene_of({box, inward, higher, box, box}, {support::lambertian(vec3(0.5f))},
                                         {}, vec3(3), vec3(0));
    EXPECT_EQ(first_of_copies(scene), (Firsts{0, 1, 2, 0, 0}));
    EXPECT_EQ(first_of_copies(FrameScene()), Firsts());
}

}  // namespace
}  // namespace lanthorn::gi::test
