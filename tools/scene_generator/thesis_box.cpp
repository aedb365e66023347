// The scene of Jozwowski 2002, sec. 5: a box that holds two smaller boxes, 16 square surfaces in all, and a
// point light that circles in it; here its back wall is blue and the one behind the camera red (fig. 34).
// Lengths are not in the thesis.
#include <cmath>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace thesis_box_parts {

constexpr double kHalf = 2;  // metres
constexpr double kSeconds = 8, kCircle = 1;
constexpr int kKeys = 64;
constexpr float kCandela = 20;

// The parallelogram a, a + u, a + u + v, a + v as side x side surfaces.
void cut(Shape& shape, const dvec3& a, const dvec3& u, const dvec3& v, int side, const dvec3& towards) {
    const auto point = [&](int x, int y) {
        return a + static_cast<double>(x) / side * u + static_cast<double>(y) / side * v;
    };
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const dvec3 middle = 0.5 * (point(x, y) + point(x + 1, y + 1));
            const dvec3 normal = glm::normalize(glm::cross(u, v));
            const double turn = glm::dot(towards - middle, normal) > 0 ? 1 : -1;
            add_quad(shape, point(x, y), point(x + 1, y), point(x + 1, y + 1), point(x, y + 1),
                     middle + turn * normal);
        }
    }
}

// Stands on the floor, without a lower face.
Shape standing(const dvec3& lower, const dvec3& upper, int side) {
    const dvec3 size = upper - lower, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    const dvec3 middle = 0.5 * (lower + upper);
    Shape shape;
    const auto face = [&](const dvec3& corner, const dvec3& u, const dvec3& v) {
        const dvec3 centre = corner + 0.5 * (u + v);
        cut(shape, corner, u, v, side, centre + (centre - middle));
    };
    face(lower + y, x, z);
    face(lower, x, y);
    face(lower + z, x, y);
    face(lower, z, y);
    face(lower + x, z, y);
    return shape;
}

void circling_light(Builder& b) {
    Light lamp;
    lamp.type = LightType::point;
    lamp.intensity = kCandela;
    AnimationChannel channel;
    channel.node = b.light("lamp", at({kCircle, 1, 0}), lamp);
    for (int k = 0; k <= kKeys; ++k) {
        const double turn = 2 * kPi * (k % kKeys) / kKeys;
        channel.times.push_back(static_cast<float>(kSeconds * k / kKeys));
        for (const double v : {kCircle * std::cos(turn), 1.0, kCircle * std::sin(turn)}) {
            channel.values.push_back(static_cast<float>(v));
        }
    }
    AnimationClip circle;
    circle.name = "circle";
    circle.duration = static_cast<float>(kSeconds);
    circle.channels.push_back(std::move(channel));
    b.scene.animations.push_back(std::move(circle));
}

// 16 side^2 surfaces.
SceneData thesis_box(int side) {
    Builder b;
    const std::uint32_t grey = b.matte("grey", vec3(0.7f), 0);
    const dvec3 low(-kHalf), across(2 * kHalf, 0, 0), up(0, 2 * kHalf, 0), back(0, 0, 2 * kHalf);
    const auto wall = [&](const char* name, const dvec3& corner, const dvec3& u, const dvec3& v,
                          std::uint32_t material) {
        Shape shape;
        cut(shape, corner, u, v, side, dvec3(0));
        b.solid(name, shape, material);
    };
    wall("floor", low, across, back, grey);
    wall("ceiling", low + up, across, back, grey);
    wall("left", low, back, up, grey);
    wall("right", low + across, back, up, grey);
    wall("back", low, across, up, b.matte("blue", {0.15f, 0.2f, 0.75f}, 0));
    wall("behind", low + back, across, up, b.matte("red", {0.75f, 0.15f, 0.12f}, 0));
    b.solid("tall", standing({-1.2, -kHalf, -1.2}, {-0.3, -0.4, -0.3}, side), grey);
    b.solid("low", standing({0.4, -kHalf, 0}, {1.2, -1.2, 0.8}, side), grey);
    circling_light(b);
    b.camera("camera", looking({0, 0.3, 1.95}, {0, -0.4, 0}), glm::radians(75.0f), 0.01f);
    return b.scene;
}

}  // namespace thesis_box_parts

SceneData thesis_box_16() {
    using namespace thesis_box_parts;
    return thesis_box(1);
}

SceneData thesis_box_64() {
    using namespace thesis_box_parts;
    return thesis_box(2);
}

SceneData thesis_box_256() {
    using namespace thesis_box_parts;
    return thesis_box(4);
}

SceneData thesis_box_1024() {
    using namespace thesis_box_parts;
    return thesis_box(8);
}

}  // namespace lanthorn::scene_generator
