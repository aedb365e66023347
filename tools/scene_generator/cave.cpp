// After Frisvad et al. 2005, Fig. 9: a cave of some 40 000 triangles with a mirror and a mirror ball, lit by
// the lantern of a figure that walks through it.
#include <algorithm>
#include <cmath>

#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/rigged_shape.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

// Smooth noise, -1 to 1, of features a metre wide: cubic between random numbers at whole metres.
double noise(const dvec3& p, std::uint64_t seed) {
    const dvec3 base = glm::floor(p);
    const dvec3 f = p - base;
    const dvec3 s = f * f * (3.0 - 2.0 * f);
    double sum = 0;
    for (int k = 0; k < 8; ++k) {
        const dvec3 corner(k & 1, k >> 1 & 1, k >> 2);
        const dvec3 at = base + corner + 1000.0;
        const auto number = static_cast<std::uint64_t>(at.x + 2048 * (at.y + 2048 * at.z));
        const dvec3 weight = corner * s + (1.0 - corner) * (1.0 - s);
        sum += weight.x * weight.y * weight.z * (2 * uniform(seed, number) - 1);
    }
    return sum;
}

double rough(const dvec3& p, std::uint64_t seed) {
    return noise(p, seed) + 0.25 * noise(2.1 * p, seed + 1);
}

// Moves the shape's corners and gives them smooth normals.
template <class Move>
Shape moved(Shape shape, const Move& move) {
    std::vector<dvec3> places;
    for (Shape::Corner& corner : shape.corners) {
        corner.position = move(corner.position);
        places.push_back(corner.position);
    }
    const std::vector<dvec3> normals = smooth_normals(places, shape.indices);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        shape.corners[i].normal = normals[i];
    }
    return shape;
}

// Where the rock is: an uneven vault over a floor that is nearly flat.
Shape vault() {
    return moved(icosphere(1, 5, true), [](const dvec3& d) {
        const dvec3 p = dvec3(3.7, 2.5, 3.5) * d * (1 + 0.16 * rough(2.2 * d, 11)) + dvec3(0, 0.9, 0);
        const double floor = 0.5 * (p.y + std::sqrt(p.y * p.y + 0.5)) - 0.07 + 0.015 * noise(1.5 * p, 5);
        return dvec3(p.x, floor, p.z);
    });
}

// Grows up from the origin, or down.
Shape dripstone(double height, double radius, std::uint64_t seed) {
    return moved(icosphere(1, 3), [&](const dvec3& d) {
        const double up = 0.5 * (1 + d.y), narrow = (1 - up) * (1 - up) + 0.12 * up;
        const double wide = radius * (0.25 + narrow) * (1 + 0.15 * noise(2.0 * d, seed));
        return dvec3(wide * d.x, height * (1.06 * up - 0.06), wide * d.z);
    });
}

void dripstones(Builder& b, std::uint32_t material) {
    struct Place {
        double x, y, z, height, radius;
    };
    constexpr Place kPlaces[] = {{-2.3, 0, -1.1, 1.1, 0.34},   {2.2, 0, -1.6, 1.15, 0.38},
                                 {1.6, 0, -2.2, 0.7, 0.3},     {-0.9, 2.9, -1.3, -0.9, 0.26},
                                 {0.7, 3.0, -0.9, -1.0, 0.34}, {1.7, 2.8, 0.5, -0.7, 0.22}};
    std::uint64_t number = 0;
    for (const Place& place : kPlaces) {
        Shape stone = dripstone(std::abs(place.height), place.radius, 30 + number);
        if (place.height < 0) {  // turned about x
            for (Shape::Corner& corner : stone.corners) {
                corner.position = {corner.position.x, -corner.position.y, -corner.position.z};
                corner.normal = {corner.normal.x, -corner.normal.y, -corner.normal.z};
            }
        }
        b.solid("dripstone-" + std::to_string(++number), stone, material, {},
                at({place.x, place.y, place.z}));
    }
}

}  // namespace

SceneData cave() {
    Builder b;
    b.solid("rock", vault(), b.matte("sandstone", {0.62f, 0.46f, 0.32f}, 0));
    dripstones(b, b.matte("dripstone", {0.34f, 0.55f, 0.5f}, 0));
    const std::uint32_t silver = b.metal("silver", {0.95f, 0.94f, 0.91f}, 0);
    b.solid("mirror", box({-0.6, 0, -0.015}, {0.6, 1.7, 0.015}), silver, {},
            looking({-1.0, 0.03, -2.25}, {-1.6, 0.03, -4.4}));
    b.solid("pedestal", cylinder(0.22, 0.55, 24), b.matte("slate", {0.3f, 0.3f, 0.34f}, 0), {},
            at({0, 0, 0}));
    b.solid("mirror-ball", icosphere(0.26, 3), silver, {}, at({0, 0.8, 0}));

    AnimationClip walk;
    walk.name = "walk";
    const std::uint32_t hook = add_puppet(b, "puppet", add_puppet_meshes(b), {}, walk);
    Light light;
    light.type = LightType::point;
    light.colour = {1, 0.72f, 0.42f};
    light.intensity = 60;
    b.light("lantern-light", at({0, -0.18, 0}), light, hook);
    b.scene.animations.push_back(std::move(walk));
    b.camera("camera", looking({2.3, 1.75, 2.2}, {-0.5, 0.85, -0.7}), glm::radians(62.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
