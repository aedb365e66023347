// The scene as rays of indirect light meet it: followed from frame to frame, what moves by coarser shapes.
#include "gi_module/shared/rays/followed_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

using reference::SurfaceHit;

constexpr vec3 kCentre(2, 1.2f, 1.5f);
constexpr float kRadius = 0.5f;
constexpr std::size_t kWall = 0, kBall = 1;

// A room with a ball that deforms: every pose stretches it.
class BallRoom {
  public:
    explicit BallRoom(int levels = 4) : ball_(support::sphere(vec3(0), kRadius, levels, false, 0)) {
        scene = support::scene_of({support::box(vec3(0), vec3(4, 2.6f, 3), true, 0), ball_},
                                  {support::lambertian(vec3(0.5f))}, {}, vec3(3), vec3(1));
        scene.instances[kBall].deformed = 0;
        scene.instances[kBall].transform[3] = vec4(kCentre, 1);
        scene.deformed.resize(1);
        pose(1);
    }

    void pose(float stretch) { take(ball_, nullptr, stretch); }

    // The same ball by other triangles.
    void refine(int levels, std::uint64_t serial) {
        const Mesh finer = support::sphere(vec3(0), kRadius, levels, false, 0);
        auto topology = std::make_shared<RefinedTopology>();
        topology->serial = serial;
        topology->uv0.resize(finer.vertices.size());
        topology->uv1.resize(finer.vertices.size());
        topology->colours.resize(finer.vertices.size(), vec4(1));
        topology->indices = finer.indices;
        take(finer, topology, 1);
    }

    FrameScene scene;

  private:
    void take(const Mesh& mesh, std::shared_ptr<const RefinedTopology> refined, float stretch) {
        auto vertices = std::make_shared<std::vector<VertexFrame>>();
        Aabb bounds;
        for (const Vertex& v : mesh.vertices) {
            vertices->push_back({v.position * vec3(stretch, 1, 1), v.normal, v.tangent});
            bounds.add(vertices->back().position);
        }
        scene.deformed[0] = {++version_, vertices, std::move(refined), bounds};
        Instance& instance = scene.instances[kBall];
        instance.version = version_;
        instance.bounds = transformed(bounds, instance.transform);
        if (version_ > 1) {
            ++scene.frame;
            scene.changes = {};
            scene.changes.assets = scene.changes.lights = scene.changes.camera = false;
            scene.changes.moved = {kBall};
        }
    }

    Mesh ball_;
    std::uint64_t version_ = 0;
};

bool met(const FollowedScene& scene, const vec3& origin, const vec3& direction, SurfaceHit& hit) {
    return scene.scene().intersect(origin, direction, 0, std::numeric_limits<float>::infinity(),
                                   reference::Blended::ignored, hit);
}

std::size_t triangles(const FollowedScene& scene, std::size_t instance) {
    return scene.scene().instances()[instance].mesh->indices.size() / 3;
}

float largest_error(const FrameScene& scene) {
    return RayShapes::kErrorOfScene * scene.diagonal();
}

// From outside, in many directions: what both meet lies as near as the error says.
void expect_same_surfaces(const FollowedScene& one, const FollowedScene& other, float tolerance) {
    int on_the_ball = 0;
    for (int i = 0; i < 200; ++i) {
        const float a = 0.31f * static_cast<float>(i);
        const vec3 origin = kCentre + 0.9f * vec3(std::cos(a), std::sin(3 * a), std::sin(a)) / 1.42f;
        const vec3 aim = kCentre + 0.3f * vec3(std::sin(7 * a), std::cos(5 * a), std::sin(2 * a)) / 1.8f;
        SurfaceHit hit, expected;
        ASSERT_TRUE(met(one, origin, glm::normalize(aim - origin), hit));
        ASSERT_TRUE(met(other, origin, glm::normalize(aim - origin), expected));
        EXPECT_EQ(hit.instance, expected.instance) << i;
        // Seen aslant at most by 60 degrees or so, and a triangle's middle lies farther off than the mean.
        EXPECT_NEAR(hit.t, expected.t, 6 * tolerance + 1e-6f) << i;
        on_the_ball += hit.instance == kBall ? 1 : 0;
    }
    EXPECT_GT(on_the_ball, 150);
}

TEST(FollowedScene, HasFewerTrianglesOfWhatDeforms) {
    BallRoom room;
    FollowedScene full, coarser;
    full.follow(room.scene);
    coarser.follow(room.scene, RayDetail::coarser);
    EXPECT_EQ(triangles(full, kBall), 5120u);
    EXPECT_LT(triangles(coarser, kBall), 5120u / 2);
    EXPECT_EQ(triangles(coarser, kWall), 12u);
    expect_same_surfaces(coarser, full, largest_error(room.scene));
}

// Rays start where the picture and the maps have a surface, which lies in front of the coarser triangles here
// and behind them there.
TEST(FollowedScene, DoesNotMeetTheSurfaceThatARayLeaves) {
    BallRoom room;
    room.pose(1.3f);
    FollowedScene coarser;
    coarser.follow(room.scene, RayDetail::coarser);
    const std::vector<VertexFrame>& vertices = *room.scene.deformed[0].vertices;
    for (std::size_t v = 0; v < vertices.size(); v += 7) {
        const vec3 outwards = glm::normalize(vertices[v].position / vec3(1.3f * 1.3f, 1, 1));
        for (const float offset : {-1.0f, 0.0f}) {
            const vec3 start =
                kCentre + vertices[v].position + offset * 0.3f * largest_error(room.scene) * outwards;
            SurfaceHit hit;
            ASSERT_TRUE(met(coarser, start, outwards, hit));
            EXPECT_EQ(hit.instance, kWall) << v;
        }
    }
}

TEST(FollowedScene, IsTheSameAsOneMadeAnew) {
    BallRoom room;
    FollowedScene kept;
    for (int i = 0; i <= 40; ++i) {  // past poses in which it has its tree built again
        room.pose(1 + 0.01f * static_cast<float>(i));
        kept.follow(room.scene, RayDetail::coarser);
    }
    FollowedScene anew;
    anew.follow(room.scene, RayDetail::coarser);
    EXPECT_EQ(kept.builds(), 1u);
    EXPECT_EQ(triangles(kept, kBall), triangles(anew, kBall));
    expect_same_surfaces(kept, anew, 0);
}

// Balls come and go in front of, between and behind others, in any order.
TEST(FollowedScene, TakesWhatComesAndLeavesWhatStays) {
    FrameScene scene = support::scene_of(
        {support::box(vec3(0), vec3(4, 2.6f, 3), true, 0), support::sphere(vec3(0), 0.2f, 2, false, 0),
         support::box(vec3(-0.2f), vec3(0.2f), false, 0)},
        {support::lambertian(vec3(0.5f))}, {}, vec3(3), vec3(1));
    const std::vector<Instance> kinds = scene.instances;
    scene.instances.resize(1);
    scene.changes.arrived = {0};
    FollowedScene kept;
    kept.follow(scene);
    std::uint32_t next = 100;
    for (int frame = 0; frame < 40; ++frame) {
        ++scene.frame;
        scene.changes = {};
        scene.changes.assets = scene.changes.lights = scene.changes.camera = false;
        scene.changes.geometry = true;
        const auto count = static_cast<int>(scene.instances.size());
        if (frame % 3 == 2 && count > 2) {
            scene.instances.erase(scene.instances.begin() + frame * 7 % count);  // the room, too
        }
        Instance comes = kinds[1 + static_cast<std::size_t>(frame) % 2];
        comes.id = next++;
        comes.transform[3] = vec4(0.4f + 0.08f * static_cast<float>(frame), 1.3f, 1.5f, 1);
        comes.bounds = transformed(scene.assets->meshes[comes.mesh].bounds, comes.transform);
        const auto at =
            static_cast<std::uint32_t>(frame * 5 % (static_cast<int>(scene.instances.size()) + 1));
        scene.instances.insert(scene.instances.begin() + at, comes);
        scene.changes.arrived = scene.changes.moved = {at};
        kept.follow(scene);
        FollowedScene fresh;
        fresh.follow(scene);
        for (int i = 0; i < 60; ++i) {
            const float a = 0.7f * static_cast<float>(i);
            const vec3 origin(2, 2.4f, 1.5f), direction(std::sin(a), -0.5f + 0.01f * a, std::cos(3 * a));
            SurfaceHit hit, expected;
            ASSERT_EQ(met(kept, origin, direction, hit), met(fresh, origin, direction, expected));
            EXPECT_EQ(hit.t, expected.t) << frame << ", " << i;
            EXPECT_EQ(hit.instance, expected.instance) << frame << ", " << i;
            EXPECT_EQ(hit.primitive, expected.primitive) << frame << ", " << i;
        }
    }
    EXPECT_EQ(kept.builds(), 1u);
    EXPECT_LT(kept.scene().triangles().size(), 2 * (12 + 20 * (320 + 12)));
}

// Vertices that are no numbers take their triangles away while they are, and nothing else.
TEST(FollowedScene, OutlivesAPoseThatIsNoNumber) {
    BallRoom room;
    FollowedScene kept;
    kept.follow(room.scene);
    for (int i = 1; i <= 16; ++i) {  // the last time with its tree built again
        room.pose(i < 16 ? 1.1f : std::numeric_limits<float>::quiet_NaN());
        kept.follow(room.scene);
    }
    SurfaceHit hit;
    ASSERT_TRUE(met(kept, kCentre + vec3(0, 0, 1), vec3(0, 0, -1), hit));
    EXPECT_EQ(hit.instance, kWall) << "there is no ball";
    for (const float stretch : {1.2f, 1.3f}) {
        room.pose(stretch);
        kept.follow(room.scene);
        FollowedScene fresh;
        fresh.follow(room.scene);
        expect_same_surfaces(kept, fresh, 0);
    }
    EXPECT_EQ(kept.builds(), 1u);
}

// A finer or coarser subdivision, as the camera comes and goes: its own part alone is built anew.
TEST(FollowedScene, TakesOtherTrianglesWithoutTheRest) {
    for (const RayDetail detail : {RayDetail::full, RayDetail::coarser}) {
        BallRoom room(3);
        FollowedScene kept;
        kept.follow(room.scene, detail);
        for (const int levels : {4, 2, 5}) {
            room.refine(levels, 100 + static_cast<std::uint64_t>(levels));
            kept.follow(room.scene, detail);
            FollowedScene anew;
            anew.follow(room.scene, detail);
            EXPECT_EQ(triangles(kept, kBall), triangles(anew, kBall));
            expect_same_surfaces(kept, anew, 0);
        }
        EXPECT_EQ(kept.builds(), 1u);
    }
}

// What is rigid has its own triangles until it moves.
TEST(FollowedScene, HasFewerTrianglesOfWhatHasMoved) {
    FrameScene scene = support::scene_of(
        {support::box(vec3(0), vec3(4, 2.6f, 3), true, 0), support::sphere(kCentre, kRadius, 4, false, 0)},
        {support::lambertian(vec3(0.5f))}, {}, vec3(3), vec3(1));
    scene.changes.arrived = {0, 1};
    FollowedScene followed;
    followed.follow(scene, RayDetail::coarser);
    EXPECT_EQ(triangles(followed, kBall), 5120u);
    scene.changes = {};
    scene.changes.assets = scene.changes.lights = scene.changes.camera = false;
    scene.changes.moved = {kBall};
    scene.instances[kBall].transform[3].x += 0.01f;
    scene.instances[kBall].bounds =
        transformed(scene.assets->meshes[kBall].bounds, scene.instances[kBall].transform);
    followed.follow(scene, RayDetail::coarser);
    EXPECT_LT(triangles(followed, kBall), 5120u / 2);
    EXPECT_EQ(followed.builds(), 1u);
}

}  // namespace
}  // namespace lanthorn::gi::test
