// What lies along a ray, against answers known on paper.
#include "lanthorn/runtime/picking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/runtime/triangle_ray.h"
#include "lanthorn/runtime/scene_plugin.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/view.h"
#include "tests/support/shapes.h"

namespace lanthorn {
namespace {

constexpr double kNear = 1e-6;  // metres: render space is in floats

// Walls that face +Z, one metre apart, seen from z = 10.
struct Walls {
    App app;
    ecs::World& world = app.world();
    dvec3 offset{0};

    explicit Walls(const dvec3& at = dvec3(0)) : offset(at) {
        app.add<ScenePlugin>();
        asset_store(world);
    }
    ecs::Entity add(const Mesh& mesh, const Material& material, const Transform& local = {}) {
        AssetStore& store = asset_store(world);
        Mesh placed = mesh;
        placed.material = store.add(material).slot;
        Transform moved = local;
        moved.translation += offset;
        return world.create(LocalTransform{moved}, MeshInstances{{store.add(placed)}});
    }
    ecs::Entity add_wall(float z, const Material& material = support::lambertian(vec3(0.5f)),
                         float size = 2) {
        return add(support::quad(vec3(-size / 2, -size / 2, z), vec3(size, 0, 0), vec3(0, size, 0), 0),
                   material);
    }
    template <class Component>
    ecs::Entity add_at(const dvec3& at, const Component& component) {
        Transform local;
        local.translation = offset + at;
        return world.create(LocalTransform{local}, component);
    }
    std::vector<Picked> pick_at(double x, double y, const PickOptions& options = {}) {
        PickRay ray;
        ray.origin = offset + dvec3(x, y, 10);
        return pick(world, scene(), ray, options);
    }
    const FrameScene& scene() {
        app.show();
        return world.resource<FrameScene>();
    }
};

std::vector<ecs::Entity> entities(const std::vector<Picked>& found) {
    std::vector<ecs::Entity> result;
    for (const Picked& picked : found) {
        result.push_back(picked.entity);
    }
    return result;
}

using Entities = std::vector<ecs::Entity>;

TEST(Picking, FindsShapesNearestFirstWhereTheRayMeetsThem) {
    for (const dvec3& offset : {dvec3(0), dvec3(1e6, -2e6, 3e6)}) {
        Walls walls(offset);
        const ecs::Entity far = walls.add_wall(-1), near = walls.add_wall(2),
                          beside = walls.add_wall(0, {}, 0.5f);
        const auto found = walls.pick_at(0.6, 0.7);
        EXPECT_EQ(entities(found), (Entities{near, far}));
        ASSERT_EQ(found.size(), 2u);
        EXPECT_NEAR(found[0].distance, 8, kNear);
        EXPECT_NEAR(found[1].distance, 11, kNear);
        EXPECT_LT(glm::distance(found[0].position, offset + dvec3(0.6, 0.7, 2)), 1e-6);
        EXPECT_EQ(found[0].normal, dvec3(0, 0, 1));
        EXPECT_EQ(entities(walls.pick_at(0.2, 0.2)), (Entities{near, beside, far}));
        EXPECT_TRUE(walls.pick_at(1.1, 0).empty());
        EXPECT_EQ(entities(walls.pick_at(1, 1)), (Entities{near, far})) << "at the very corner";
    }
}

TEST(Picking, LooksThroughBackFacesUnlessTheyAreShown) {
    Walls walls;
    Transform turned;
    turned.rotation = glm::angleAxis(kPi, vec3(0, 1, 0));
    Material two_sided = support::lambertian(vec3(0.5f));
    two_sided.double_sided = true;
    const Mesh quad = support::quad(vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), 0);
    walls.add(quad, support::lambertian(vec3(0.5f)), turned);
    const ecs::Entity shown = walls.add(quad, two_sided, turned);
    Transform mirrored;
    mirrored.scale = vec3(-1, 1, 1);  // faces +Z still
    mirrored.translation.z = -1;
    const ecs::Entity mirror_image = walls.add(quad, support::lambertian(vec3(0.5f)), mirrored);
    const auto found = walls.pick_at(0.3, 0.1);
    EXPECT_EQ(entities(found), (Entities{shown, mirror_image}));
    EXPECT_LT(glm::distance(found.at(0).normal, dvec3(0, 0, 1)), 1e-6) << "towards the ray";
}

TEST(Picking, FindsWhatIsBehindGlassAndInHoles) {
    Walls walls;
    Material glass = support::lambertian(vec3(0.5f)), grid = glass, pane = glass;
    glass.transmission = 1;
    pane.alpha_mode = AlphaMode::blend;
    grid.alpha_mode = AlphaMode::mask;
    Image image;
    image.width = 2;
    image.height = 1;
    image.rgba = {255, 255, 255, 255, 255, 255, 255, 0};
    Texture texture;
    texture.image = asset_store(walls.world).add(image).slot;
    texture.sampler.mag = Filter::nearest;
    grid.base_colour_texture.texture = asset_store(walls.world).add(texture).slot;
    Mesh with_hole = support::quad(vec3(-1, -1, 3), vec3(2, 0, 0), vec3(0, 2, 0), 0);
    for (Vertex& vertex : with_hole.vertices) {
        vertex.uv0 = 0.5f * vec2(vertex.position) + 0.5f;  // the right half is a hole
    }
    const ecs::Entity wall = walls.add_wall(0), behind_glass = walls.add_wall(1, glass),
                      behind_pane = walls.add_wall(2, pane), masked = walls.add(with_hole, grid);
    EXPECT_EQ(entities(walls.pick_at(-0.5, 0)), (Entities{masked, behind_pane, behind_glass, wall}));
    EXPECT_EQ(entities(walls.pick_at(0.5, 0)), (Entities{behind_pane, behind_glass, wall}));
}

TEST(Picking, LightsAndCamerasAreSpheres) {
    Walls walls;
    const ecs::Entity wall = walls.add_wall(0);
    const ecs::Entity light = walls.add_at(dvec3(0.5, 0, 3), LightComponent{});
    const ecs::Entity camera = walls.add_at(dvec3(0.5, 0, 5), CameraComponent{});
    PickOptions options;
    options.icon_metres = 0.25;
    const auto found = walls.pick_at(0.5, 0.15, options);
    ASSERT_EQ(entities(found), (Entities{camera, light, wall}));
    EXPECT_EQ(found[0].kind, PickedKind::camera);
    EXPECT_EQ(found[1].kind, PickedKind::light);
    EXPECT_EQ(found[2].kind, PickedKind::shape);
    EXPECT_NEAR(found[1].distance, 7 - 0.2, 1e-6) << "a sphere: 0.25^2 = 0.15^2 + 0.2^2";
    EXPECT_EQ(entities(walls.pick_at(0.5, 0.26, options)), (Entities{wall}));
    options.through = camera;
    EXPECT_EQ(entities(walls.pick_at(0.5, 0.15, options)), (Entities{light, wall}));
    options.lights = false;
    EXPECT_EQ(entities(walls.pick_at(0.5, 0.15, options)), (Entities{wall}));
    options.shapes = false;
    EXPECT_TRUE(walls.pick_at(0.5, 0.15, options).empty());

    // As wide as pixels, farther away: 10 pixels of 0.01 a metre are 0.7 m at 7 m.
    PickRay ray;
    ray.origin = dvec3(0.5, 0.6, 10);
    ray.pixel_spread = 0.01;
    options = {.icon_metres = 0.1, .icon_pixels = 10};
    EXPECT_EQ(entities(pick(walls.world, walls.scene(), ray, options)), (Entities{light, wall}));
    ray.farthest = 6;
    EXPECT_TRUE(pick(walls.world, walls.scene(), ray, options).empty());
    ray.origin = dvec3(0.5, 0, 3.05);
    ray.farthest = std::numeric_limits<double>::infinity();
    EXPECT_EQ(entities(pick(walls.world, walls.scene(), ray, options)), (Entities{wall}))
        << "not what the ray starts in";
}

TEST(Picking, WhatHasBeenDestroyedIsNotFound) {
    Walls walls;
    const ecs::Entity near = walls.add_wall(1), far = walls.add_wall(0);
    const FrameScene shown = walls.scene();
    walls.world.destroy(near);
    walls.add_wall(1);  // may be of the same number
    PickRay ray;
    ray.origin = dvec3(0, 0, 10);
    const auto found = pick(walls.world, shown, ray);
    EXPECT_EQ(found.back().entity, far);
    for (const Picked& picked : found) {
        EXPECT_TRUE(walls.world.alive(picked.entity));
        EXPECT_NE(picked.entity, near);
    }
}

TEST(Picking, RaysOfPixelsMeetWhatProjectsThere) {
    Camera camera;
    for (const bool orthographic : {false, true}) {
        camera.orthographic = orthographic;
        camera.x_mag = camera.y_mag = 3;
        const dvec3 origin(1e5, 0, -1e5);
        dmat4 at(1);
        at[3] = dvec4(origin + dvec3(1, 2, 3), 1);
        const CameraView look = camera_view(camera, at, origin);
        const ivec2 size(40, 20);
        const PickRay centre = pick_ray(look, origin, size, {20, 10});
        EXPECT_LT(glm::distance(centre.direction, dvec3(0, 0, -1)), 1e-7);
        EXPECT_LT(glm::distance(centre.origin, origin + dvec3(1, 2, 3)), 1e-9);
        EXPECT_NEAR(centre.nearest, 0.05, 1e-7);
        const PickRay corner = pick_ray(look, origin, size, {0, 0});
        const double half = orthographic ? 3 : std::tan(0.5 * static_cast<double>(camera.y_fov));
        const dvec3 seen = corner.origin + corner.direction * (1 / -corner.direction.z) - centre.origin;
        EXPECT_LT(glm::distance(seen, dvec3(-2 * half, half, -1)), 1e-6) << "the upper left, a metre away";
        EXPECT_NEAR(-corner.direction.z * corner.nearest, 0.05, 1e-7) << "the near plane is flat";
    }
}

// Two triangles over a shared edge: every ray meets one at least.
TEST(TriangleRay, LeavesNoGap) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto point = [&] { return dvec3(number(random), number(random), number(random)); };
    for (int i = 0; i < 20000; ++i) {
        const dvec3 a = point() + dvec3(0, 0, -3), b = point() + dvec3(0, 0, -3);
        const double share = 0.5 + 0.49 * number(random);
        const dvec3 direction = glm::normalize(glm::mix(a, b, share));
        // On either side of the edge as it is seen.
        const dvec3 across = glm::normalize(glm::cross(b - a, direction));
        const dvec3 left = glm::mix(a, b, 0.5) + across + 0.2 * point();
        const dvec3 right = glm::mix(a, b, 0.5) - across + 0.2 * point();
        const TriangleRay ray(direction);
        const auto hit = ray.meet(a, b, left), other = ray.meet(b, a, right);
        ASSERT_TRUE(hit || other) << i;
        const double expected = glm::length(glm::mix(a, b, share));
        EXPECT_NEAR(hit ? hit->distance : other->distance, expected, 1e-9);
    }
}

TEST(TriangleRay, KnowsWhichSideItSees) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            dvec3 direction(0.1);
            direction[axis] = sign;
            const dvec3 u(direction.y, -direction.x, 0.0), v = glm::cross(direction, u);
            const dvec3 centre = 4.0 * direction;
            // u x v points along -direction or direction; counter-clockwise as seen is where it comes towards
            // us.
            const bool towards = glm::dot(glm::cross(u, v), direction) < 0;
            const auto hit = TriangleRay(direction).meet(centre - u - v, centre + u - v, centre + v);
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->counter_clockwise, towards);
            EXPECT_NEAR(hit->distance, 4, 1e-12);
        }
    }
}

}  // namespace
}  // namespace lanthorn
