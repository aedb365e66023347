#include "gi_module/techniques/emc/gather/swept_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

Aabb unit_box_at(float x, float y = 0) {
    return {vec3(x, y, 0), vec3(x + 1, y + 1, 1)};
}

// One instance a box; ids count from 0.
FrameScene scene_of_boxes(const std::vector<Aabb>& boxes) {
    FrameScene scene;
    scene.changes = {};
    scene.changes.geometry = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Instance instance;
        instance.id = static_cast<std::uint32_t>(i);
        instance.bounds = boxes[i];
        scene.instances.push_back(instance);
    }
    return scene;
}

TEST(SweptBoxes, HoldWhereAMoverIsAndWas) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(0), unit_box_at(5)});
    swept.follow(scene, 1);
    EXPECT_TRUE(swept.movers().empty());
    scene.instances[1].bounds = unit_box_at(7);
    scene.changes.moved = {1};
    swept.follow(scene, 1);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_EQ(swept.movers()[0].swept, (Aabb{vec3(5, 0, 0), vec3(8, 1, 1)}));
    scene.changes.moved.clear();
    swept.follow(scene, 1);
    EXPECT_TRUE(swept.movers().empty());
}

TEST(SweptBoxes, HoldWhatCameAndWhatWent) {
    SweptBoxes swept;
    swept.follow(scene_of_boxes({unit_box_at(0), unit_box_at(3)}), 1);
    FrameScene scene = scene_of_boxes({unit_box_at(0)});
    Instance arrived;
    arrived.id = 7;
    arrived.bounds = unit_box_at(20);
    scene.instances.push_back(arrived);
    scene.changes.moved = {1};
    scene.changes.arrived = {1};
    swept.follow(scene, 1);
    ASSERT_EQ(swept.movers().size(), 2u);
    EXPECT_EQ(swept.movers()[0].swept, unit_box_at(3));
    EXPECT_EQ(swept.movers()[1].swept, unit_box_at(20));
}

TEST(SweptBoxes, MoveWithTheOrigin) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(100)});
    swept.follow(scene, 1);
    scene.origin = {100, 0, 0};
    scene.instances[0].bounds = unit_box_at(0.5f);  // half a metre on
    scene.changes.moved = {0};
    swept.follow(scene, 1);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_EQ(swept.movers()[0].swept, (Aabb{vec3(0), vec3(1.5f, 1, 1)}));
}

// No more than the shader has room for, and every mover is in one.
TEST(SweptBoxes, BecomeOneWhereTheyLieTogether) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 40; ++i) {
        boxes.push_back(unit_box_at(i % 2 == 0 ? 0.1f * static_cast<float>(i) : 1000, static_cast<float>(i)));
    }
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes(boxes);
    swept.follow(scene, 1);
    for (std::uint32_t i = 0; i < 40; ++i) {
        scene.changes.moved.push_back(i);
    }
    swept.follow(scene, 1);
    EXPECT_EQ(swept.movers().size(), SweptBoxes::kMost);
    for (const Aabb& box : boxes) {
        const bool inside = std::ranges::any_of(swept.movers(), [&](const Mover& m) {
            return glm::all(glm::lessThanEqual(m.swept.lower, box.lower)) &&
                   glm::all(glm::greaterThanEqual(m.swept.upper, box.upper));
        });
        EXPECT_TRUE(inside);
    }
    // The two crowds, a kilometre apart, are not joined.
    for (const Mover& m : swept.movers()) {
        EXPECT_LT(m.swept.size().x, 500);
        EXPECT_TRUE(!m.rigid || m.carry == mat4(1));
    }
}

// A grid knows more about many than sixteen boxes do.
TEST(SweptBoxes, AreManyBeyondWhatAShaderTestsOneByOne) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 17; ++i) {
        boxes.push_back(unit_box_at(6.0f * static_cast<float>(i)));
    }
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes(boxes);
    swept.follow(scene, 1);
    for (std::uint32_t i = 0; i < 16; ++i) {
        scene.changes.moved.push_back(i);
    }
    swept.follow(scene, 1);
    EXPECT_FALSE(swept.are_many());
    scene.changes.moved.push_back(16);
    swept.follow(scene, 1);
    ASSERT_TRUE(swept.are_many());
    const std::vector<std::uint32_t>& columns = swept.grid().columns();
    const auto swept_columns = std::ranges::count_if(columns, [](std::uint32_t bits) { return bits != 0; });
    EXPECT_LT(static_cast<double>(swept_columns), 0.5 * static_cast<double>(columns.size()));
}

// What turns and moves carries its points to where they are now.
TEST(SweptBoxes, CarryPointsAlong) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(0)});
    scene.instances[0].transform = glm::translate(mat4(1), vec3(1, 2, 3));
    swept.follow(scene, 1);
    const mat4 turned =
        glm::rotate(glm::translate(mat4(1), vec3(4, 2, 3)), glm::radians(90.0f), vec3(0, 0, 1));
    scene.instances[0].transform = turned;
    scene.changes.moved = {0};
    scene.origin = {0, 0, 1};
    scene.instances[0].transform[3].z -= 1;
    swept.follow(scene, 1);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_TRUE(swept.movers()[0].rigid);
    // A metre along the object's x, in the render space of the new origin.
    const vec3 now = vec3(swept.movers()[0].carry * vec4(2, 2, 2, 1));
    EXPECT_NEAR(glm::distance(now, vec3(4, 3, 2)), 0, 1e-5f);
}

// A figure of two legs, a metre apart: what lies between them is not swept.
class WalkingLegs {
  public:
    WalkingLegs() {
        Mesh mesh = support::box(vec3(0), vec3(0.1f, 1, 0.1f), false, 0);
        const Mesh other = support::box(vec3(1, 0, 0), vec3(1.1f, 1, 0.1f), false, 0);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const std::uint32_t i : other.indices) {
            mesh.indices.push_back(first + i);
        }
        left_ = first;
        scene = support::scene_of({mesh}, {Material{}}, {}, vec3(0, 0, 5), vec3(0));
        scene.instances[0].deformed = 0;
        scene.deformed.resize(1);
        pose(0);
    }
    // The right leg at its place, the left one a step ahead.
    void pose(float step) {
        const Mesh& mesh = scene.assets->meshes[0];
        auto vertices = std::make_shared<std::vector<VertexFrame>>();
        Aabb bounds;
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            vertices->push_back({mesh.vertices[i].position + vec3(0, 0, i < left_ ? step : 0)});
            bounds.add(vertices->back().position);
        }
        scene.deformed[0] = {1, vertices, nullptr, bounds};
        scene.instances[0].bounds = bounds;
        scene.changes.moved = {0};
    }

    FrameScene scene;

  private:
    std::size_t left_;
};

TEST(SweptBoxes, HoldEachLimbOfAFigure) {
    SweptBoxes swept;
    WalkingLegs figure;
    figure.scene.changes.moved.clear();
    swept.follow(figure.scene, 1);
    figure.pose(0.5f);
    swept.follow(figure.scene, 1);
    EXPECT_FALSE(swept.has_limbs());  // where its limbs were was not known
    EXPECT_EQ(swept.boxes(), swept.whole());
    figure.pose(0.75f);
    swept.follow(figure.scene, 1);
    ASSERT_TRUE(swept.has_limbs());
    EXPECT_EQ(swept.whole().size(), 1u);
    EXPECT_LE(swept.boxes().size(), SweptBoxes::kMost);
    const auto holds = [&](const vec3& p) {
        return std::ranges::any_of(swept.boxes(), [&](const Aabb& box) {
            return glm::all(glm::lessThanEqual(box.lower, p)) &&
                   glm::all(glm::greaterThanEqual(box.upper, p));
        });
    };
    for (const float y : {0.0f, 0.3f, 0.999f}) {
        EXPECT_TRUE(holds(vec3(0.05f, y, 0.55f)));  // where the left one was
        EXPECT_TRUE(holds(vec3(0.05f, y, 0.8f)));   // and is
        EXPECT_TRUE(holds(vec3(1.05f, y, 0.05f)));
    }
    EXPECT_FALSE(holds(vec3(0.5f, 0.5f, 0.4f)));
    EXPECT_FALSE(holds(vec3(1.05f, 0.5f, 0.6f)));
}

// Each part goes its own way, turning as it does.
TEST(SweptBoxes, CarryTheLimbsOfAFigureAlong) {
    SweptBoxes swept;
    WalkingLegs figure;
    figure.scene.changes.moved.clear();
    swept.follow(figure.scene, 1);
    figure.pose(0.1f);
    swept.follow(figure.scene, 1);
    EXPECT_TRUE(swept.carries().empty());  // where it was is not known
    figure.scene.origin = {0, 10, 0};
    figure.scene.instances[0].transform =
        glm::rotate(glm::translate(mat4(1), vec3(0, -10, 0)), glm::radians(30.0f), vec3(0, 1, 0));
    figure.pose(0.3f);
    swept.follow(figure.scene, 1);
    const auto carries = swept.carries();
    ASSERT_EQ(carries.size(), 1u);
    const auto expect_carried = [&](const vec3& from, const vec3& to) {
        int holding = 0;
        for (const SweptBoxes::Carry& part : carries[0]) {
            EXPECT_TRUE(part.bends);
            if (glm::all(glm::lessThanEqual(part.before.lower, from)) &&
                glm::all(glm::greaterThanEqual(part.before.upper, from))) {
                ++holding;
                EXPECT_NEAR(glm::distance(vec3(part.carry * vec4(from, 1)), to), 0, 1e-5f);
            }
        }
        EXPECT_GT(holding, 0);
    };
    const auto now = [&](const vec3& p) { return vec3(figure.scene.instances[0].transform * vec4(p, 1)); };
    expect_carried(vec3(0.05f, -9.5f, 0.15f), now(vec3(0.05f, 0.5f, 0.35f)));  // the left one, a step on
    expect_carried(vec3(1.05f, -9.5f, 0.05f), now(vec3(1.05f, 0.5f, 0.05f)));
}

// With the node that carries it, and with the origin.
TEST(SweptBoxes, HoldLimbsWhereTheyArePlaced) {
    SweptBoxes swept;
    WalkingLegs figure;
    swept.follow(figure.scene, 1);
    figure.pose(0.1f);
    swept.follow(figure.scene, 1);
    figure.scene.origin = {0, 10, 0};
    figure.scene.instances[0].transform = glm::translate(mat4(1), vec3(0, -9, 0));  // a metre up
    figure.pose(0.1f);
    figure.scene.instances[0].bounds =
        transformed(figure.scene.deformed[0].bounds, figure.scene.instances[0].transform);
    swept.follow(figure.scene, 1);
    ASSERT_TRUE(swept.has_limbs());
    Aabb all;
    for (const Aabb& box : swept.boxes()) {
        all.add(box);
    }
    EXPECT_NEAR(all.lower.y, -10, 1e-5f);
    EXPECT_NEAR(all.upper.y, -8, 1e-5f);
}

// Other triangles between the same vertices, or more of them: limbs are found anew.
TEST(SweptBoxes, FollowAFigureThatIsRefined) {
    SweptBoxes swept;
    WalkingLegs figure;
    for (const float step : {0.0f, 0.1f, 0.2f}) {
        figure.pose(step);
        swept.follow(figure.scene, 1);
    }
    EXPECT_TRUE(swept.has_limbs());
    figure.pose(0.3f);
    auto refined = std::make_shared<RefinedTopology>();
    refined->serial = 7;
    refined->indices = {0, 1, 40};  // from one leg to the other
    figure.scene.deformed[0].refined = refined;
    swept.follow(figure.scene, 1);
    EXPECT_FALSE(swept.has_limbs());
    figure.pose(0.4f);
    figure.scene.deformed[0].refined = refined;
    swept.follow(figure.scene, 1);
    EXPECT_TRUE(swept.has_limbs());
    EXPECT_EQ(swept.boxes().size(), 1u);
}

// A crowd has no room for limbs of each, but no limb is left out.
TEST(SweptBoxes, HoldTheLimbsOfACrowd) {
    SweptBoxes swept;
    WalkingLegs figure;
    const auto crowd = [&](float step) {
        figure.pose(step);
        FrameScene scene = figure.scene;
        const Instance one = scene.instances[0];
        const DeformedMesh shape = scene.deformed[0];
        scene.instances.clear();
        scene.deformed.clear();
        scene.changes.moved.clear();
        for (std::uint32_t i = 0; i < 30; ++i) {
            Instance next = one;
            next.id = i;
            next.deformed = i;
            next.transform = glm::translate(mat4(1), vec3(5 * i, 0, 0));
            next.bounds = transformed(shape.bounds, next.transform);
            scene.instances.push_back(next);
            scene.deformed.push_back(shape);
            scene.changes.moved.push_back(i);
        }
        return scene;
    };
    for (const float step : {0.0f, 0.1f, 0.2f}) {
        swept.follow(crowd(step), 1);
    }
    EXPECT_TRUE(swept.has_limbs());
    EXPECT_LE(swept.boxes().size(), SweptBoxes::kMost);
    EXPECT_LE(swept.whole().size(), SweptBoxes::kMost);
    for (const std::vector<Aabb>& boxes : {swept.boxes(), swept.whole()}) {
        for (std::uint32_t i = 0; i < 30; ++i) {
            const vec3 p(5 * static_cast<float>(i) + 0.05f, 0.5f, 0.25f);
            EXPECT_TRUE(std::ranges::any_of(boxes, [&](const Aabb& box) {
                return glm::all(glm::lessThanEqual(box.lower, p)) &&
                       glm::all(glm::greaterThanEqual(box.upper, p));
            })) << i;
        }
    }
}

TEST(SweptBoxes, PassOverWhatHasNoExtent) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({Aabb{}});
    swept.follow(scene, 1);
    scene.changes.moved = {0};
    swept.follow(scene, 1);
    EXPECT_TRUE(swept.movers().empty());
}

}  // namespace
}  // namespace lanthorn::gi
