#include "gi_module/techniques/emc/maps/candidates.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

TEST(Candidates, LieInsideAndApart) {
    const Aabb box{vec3(-1, 2, 3), vec3(4, 5, 9)};
    const auto points = candidate_points(box, 0, 40, 1);
    ASSERT_EQ(points.size(), 40u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(points[i], box.lower)) &&
                    glm::all(glm::lessThanEqual(points[i], box.upper)));
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(glm::distance(points[i], points[j]), 0.02f * box.diagonal());
        }
    }
}

TEST(Candidates, BatchesContinueTheSequence) {
    const Aabb box{vec3(0), vec3(1)};
    const auto all = candidate_points(box, 0, 30, 7);
    const auto later = candidate_points(box, 20, 10, 7);
    for (std::size_t i = 0; i < later.size(); ++i) {
        EXPECT_EQ(later[i], all[20 + i]);
    }
}

TEST(Candidates, FlatAndEmptyBoxesGiveFinitePoints) {
    for (const Aabb& box : {Aabb{}, Aabb{vec3(1), vec3(1)}, Aabb{vec3(0), vec3(1, 0, 1)}}) {
        for (const vec3& p : candidate_points(box, 0, 8, 1)) {
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        }
    }
}

}  // namespace
}  // namespace lanthorn::gi
