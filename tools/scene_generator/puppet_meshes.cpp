#include <cmath>

#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/puppet_joints.h"
#include "tools/scene_generator/rigged_shape.h"

namespace lanthorn::scene_generator {

namespace {

// Bones that hang down from their joints: each takes over at its own joint.
JointChain hanging(std::initializer_list<PuppetJoint> joints) {
    JointChain result;
    for (const PuppetJoint joint : joints) {
        result.joints.emplace_back(static_cast<std::uint16_t>(joint), joint_place(joint).y);
    }
    return result;
}

// Bones that rise from their joints: each takes over at the joint above it.
JointChain rising(std::initializer_list<PuppetJoint> from_the_top) {
    JointChain result;
    double above = 0;
    for (const PuppetJoint joint : from_the_top) {
        result.joints.emplace_back(static_cast<std::uint16_t>(joint), above);
        above = joint_place(joint).y;
    }
    return result;
}

Mesh body(std::uint32_t material) {
    using enum PuppetJoint;
    RiggedShape shape;
    const JointChain torso = rising({neck, chest, spine, hips});
    shape.add_tube(capsule({0, 0.83, 0}, {0, 1.47, 0}, 0.15, 0.17, 0.64, 12), 28, &torso);
    shape.add_tube(capsule({0, 1.40, 0}, {0, 1.57, 0}, 0.05, 0.045, 1, 4), 16, &torso);
    for (const bool left : {true, false}) {
        const PuppetJoint thigh = left ? thigh_l : thigh_r, shin = left ? shin_l : shin_r,
                          foot = left ? foot_l : foot_r;
        const JointChain leg = hanging({thigh, shin, foot});
        const double x = joint_place(thigh).x;
        shape.add_tube(capsule({x, 0.04, 0}, {x, 0.95, 0}, 0.055, 0.09, 1, 16), 20, &leg);
        const JointChain sole = hanging({foot});
        std::vector<Ring> rings = capsule({x, 0, 0.06}, {x, 0.10, 0.05}, 0.049, 0.049, 2.6, 2, 8);
        shape.add_tube(rings, 32, &sole);
        const PuppetJoint arm = left ? arm_l : arm_r, forearm = left ? forearm_l : forearm_r,
                          hand = left ? hand_l : hand_r;
        const JointChain sleeve = hanging({arm, forearm, hand});
        const double side = joint_place(arm).x;
        shape.add_tube(capsule({side, 0.79, 0}, {side, 1.45, 0}, 0.042, 0.06, 1, 14), 18, &sleeve);
    }
    return smooth_mesh("body", shape, material);
}

// A thin slab of quads that hangs from the shoulders: the cage of a Catmull-Clark surface.
Mesh cape(std::uint32_t material) {
    constexpr int kAcross = 6, kDown = 8;
    constexpr double kThick = 0.02;
    const JointChain hang =
        hanging({PuppetJoint::chest, PuppetJoint::cape_1, PuppetJoint::cape_2, PuppetJoint::cape_3});
    const auto point = [&](int across, int down, bool outer) {
        const double u = 2.0 * across / kAcross - 1;
        const double v = static_cast<double>(down) / kDown;
        const double half = 0.17 + 0.12 * v;
        const double z = -0.155 - 0.07 * v + 0.05 * u * u + 0.012 * (across % 2) * v;
        return dvec3(half * u, 1.44 - 0.94 * v, outer ? z - kThick : z);
    };
    Mesh mesh;
    mesh.name = "cape";
    mesh.material = material;
    mesh.cage = SubdivisionCage{};
    mesh.cage->level = 2;
    const auto quad = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        add_hanging_face(mesh, {a, b, c, d}, hang);
    };
    for (int d = 0; d < kDown; ++d) {
        for (int a = 0; a < kAcross; ++a) {
            quad(point(a, d, true), point(a + 1, d, true), point(a + 1, d + 1, true), point(a, d + 1, true));
            quad(point(a, d, false), point(a, d + 1, false), point(a + 1, d + 1, false),
                 point(a + 1, d, false));
        }
        quad(point(0, d, false), point(0, d, true), point(0, d + 1, true), point(0, d + 1, false));
        quad(point(kAcross, d, true), point(kAcross, d, false), point(kAcross, d + 1, false),
             point(kAcross, d + 1, true));
    }
    for (int a = 0; a < kAcross; ++a) {
        quad(point(a, 0, false), point(a + 1, 0, false), point(a + 1, 0, true), point(a, 0, true));
        quad(point(a, kDown, true), point(a + 1, kDown, true), point(a + 1, kDown, false),
             point(a, kDown, false));
    }
    return mesh;
}

// 1 at `centre`, falling off smoothly within `size`.
double bump(const dvec3& p, const dvec3& centre, const dvec3& size) {
    const dvec3 d = (p - centre) / size;
    return std::exp(-glm::dot(d, d));
}

// The origin is the head's joint, the face looks along +Z.
Mesh head(std::uint32_t material) {
    constexpr int kRings = 32;
    const dvec3 centre(0, 0.11, 0.01);
    const dvec3 half(0.09, 0.125, 0.105);
    std::vector<Ring> rings;
    for (int i = 0; i <= kRings; ++i) {
        const double angle = 3.14159265358979323846 * i / kRings;
        const double wide = i == 0 || i == kRings ? 0 : std::sin(angle);
        rings.push_back({centre - dvec3(0, half.y * std::cos(angle), 0), half.x * wide, half.z * wide});
    }
    RiggedShape shape;
    shape.add_tube(rings, 40, nullptr);
    const auto moved = [&](const auto& by) {
        std::vector<dvec3> points = shape.positions;
        for (dvec3& p : points) {
            p += by(p);
        }
        return points;
    };
    shape.positions = moved([](const dvec3& p) {
        return dvec3(0, 0,
                     0.015 * bump(p, {0, 0.105, 0.115}, {0.028, 0.034, 0.05}) -
                         0.006 * bump(p, {0.035, 0.135, 0.1}, {0.02, 0.016, 0.05}) -
                         0.006 * bump(p, {-0.035, 0.135, 0.1}, {0.02, 0.016, 0.05}) +
                         0.005 * bump(p, {0, 0.063, 0.105}, {0.032, 0.018, 0.05}));
    });
    Mesh mesh = smooth_mesh("head", shape, material);
    const auto jaw = moved([](const dvec3& p) {
        const double chin = bump(p, {0, 0.02, 0.07}, {0.06, 0.035, 0.07});
        const double mouth = bump(p, {0, 0.06, 0.11}, {0.026, 0.012, 0.05});
        return dvec3(0, -0.022 * chin, -0.03 * mouth);
    });
    const auto smile = moved([](const dvec3& p) {
        const double left = bump(p, {0.034, 0.066, 0.09}, {0.02, 0.018, 0.05});
        const double right = bump(p, {-0.034, 0.066, 0.09}, {0.02, 0.018, 0.05});
        return dvec3(0.008 * (left - right), 0.014 * (left + right), 0.006 * (left + right));
    });
    const auto brows = moved([](const dvec3& p) {
        const double left = bump(p, {0.035, 0.158, 0.09}, {0.03, 0.012, 0.05});
        const double right = bump(p, {-0.035, 0.158, 0.09}, {0.03, 0.012, 0.05});
        return dvec3(0, 0.008, 0.010) * (left + right);
    });
    for (const auto& target : {jaw, smile, brows}) {
        mesh.morphs.push_back(morph_target(shape, target));
    }
    mesh.morph_weights = {0, 0, 0};
    return mesh;
}

Shape eyes() {
    Shape shape;
    for (const double x : {-0.034, 0.034}) {
        const Shape ball = icosphere(0.013, 2);
        const auto first = static_cast<std::uint32_t>(shape.corners.size());
        for (Shape::Corner corner : ball.corners) {
            corner.position += dvec3(x, 0.133, 0.098);
            shape.corners.push_back(corner);
        }
        for (const std::uint32_t index : ball.indices) {
            shape.indices.push_back(first + index);
        }
    }
    return shape;
}

// Hangs from the origin: a ring's bar, two plates and four posts.
Shape lantern() {
    Shape shape;
    add_box(shape, {-0.003, -0.10, -0.003}, {0.003, 0, 0.003});
    add_box(shape, {-0.035, -0.11, -0.035}, {0.035, -0.10, 0.035});
    add_box(shape, {-0.03, -0.28, -0.03}, {0.03, -0.27, 0.03});
    for (const double x : {-0.03, 0.026}) {
        for (const double z : {-0.03, 0.026}) {
            add_box(shape, {x, -0.27, z}, {x + 0.004, -0.11, z + 0.004});
        }
    }
    return shape;
}

std::uint32_t add(Builder& b, Mesh mesh) {
    b.scene.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(b.scene.meshes.size() - 1);
}

}  // namespace

PuppetMeshes add_puppet_meshes(Builder& b, const PuppetDress& dress) {
    const std::uint32_t tunic = b.matte("tunic", dress.tunic);
    const std::uint32_t cloth = b.matte("cloth", dress.cape);
    const std::uint32_t skin = b.matte("skin", dress.skin);
    const std::uint32_t dark = b.matte("eyes", {0.05f, 0.04f, 0.04f});
    const std::uint32_t iron = b.matte("iron", {0.12f, 0.12f, 0.13f});
    return {add(b, body(tunic)), add(b, cape(cloth)), add(b, head(skin)), b.mesh("eyes", eyes(), dark),
            b.mesh("lantern", lantern(), iron)};
}

}  // namespace lanthorn::scene_generator
