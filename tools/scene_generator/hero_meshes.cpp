#include "tools/scene_generator/hero_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "tools/scene_generator/puppet_joints.h"
#include "tools/scene_generator/rigged_shape.h"

namespace lanthorn::scene_generator {

namespace {

using enum PuppetJoint;

JointChain chain(std::initializer_list<std::pair<PuppetJoint, double>> from_the_top, double soft = 0.06) {
    JointChain result;
    result.soft = soft;
    for (const auto& [joint, height] : from_the_top) {
        result.joints.emplace_back(static_cast<std::uint16_t>(joint), height);
    }
    return result;
}
// Each takes over at its own joint.
JointChain hanging(std::initializer_list<PuppetJoint> joints) {
    JointChain result;
    for (const PuppetJoint joint : joints) {
        result.joints.emplace_back(static_cast<std::uint16_t>(joint), joint_place(joint).y);
    }
    return result;
}
JointChain torso() {
    return chain({{neck, 0}, {chest, 1.45}, {spine, 1.22}, {hips, 1.05}});
}
JointChain only(PuppetJoint joint) {
    return chain({{joint, 0}});
}

// Rings about an axis that may lean: height, half axes, and how far the centre is before the body's axis.
struct Slice {
    double y, x, z, ahead = 0;
};
void add_slices(RiggedShape& shape, const std::vector<Slice>& slices, int sides, const JointChain& joints,
                double side = 0) {
    std::vector<Ring> rings;
    rings.reserve(slices.size());
    for (const Slice& slice : slices) {
        rings.push_back({{side, slice.y, slice.ahead}, slice.x, slice.z});
    }
    shape.add_tube(rings, sides, &joints);
}

// Below the belt the tunic goes with the thighs, each on its side.
void bind_skirt(RiggedShape& shape, std::size_t first) {
    for (std::size_t i = first; i < shape.positions.size(); ++i) {
        const dvec3& p = shape.positions[i];
        const double down = std::clamp((0.98 - p.y) / 0.34, 0.0, 1.0);
        const auto left = static_cast<float>(std::clamp(0.5 + p.x / 0.2, 0.0, 1.0));
        const auto thighs = static_cast<float>(0.8 * down);
        std::array<std::pair<float, PuppetJoint>, 3> shares = {
            {{1 - thighs, hips}, {thighs * left, thigh_l}, {thighs * (1 - left), thigh_r}}};
        std::ranges::stable_sort(shares, std::greater<>(), &std::pair<float, PuppetJoint>::first);
        SkinInfluences bound;
        for (std::size_t k = 0; k < shares.size() && shares[k].first > 0; ++k) {
            bound.weights[k] = shares[k].first;
            bound.joints[k] = static_cast<std::uint16_t>(shares[k].second);
        }
        shape.influences[i] = bound;
    }
}

RiggedShape tunic() {
    RiggedShape shape;
    add_slices(shape,
               {{0.93, 0, 0},
                {0.94, 0.12, 0.085},
                {1.0, 0.135, 0.1},
                {1.1, 0.135, 0.1},
                {1.22, 0.16, 0.11},
                {1.34, 0.185, 0.115},
                {1.41, 0.175, 0.1},
                {1.46, 0.11, 0.075},
                {1.49, 0.05, 0.045},
                {1.495, 0, 0}},
               28, torso());
    const std::size_t skirt = shape.positions.size();
    add_slices(shape,
               {{0.6, 0, 0},
                {0.6, 0.2, 0.175},
                {0.61, 0.215, 0.19},
                {0.7, 0.195, 0.165},
                {0.8, 0.175, 0.145},
                {0.9, 0.155, 0.12},
                {1.0, 0.138, 0.103},
                {1.01, 0, 0}},
               32, torso());
    bind_skirt(shape, skirt);
    for (const bool left : {true, false}) {
        const JointChain sleeve =
            left ? hanging({arm_l, forearm_l, hand_l}) : hanging({arm_r, forearm_r, hand_r});
        add_slices(shape,
                   {{0.86, 0, 0},
                    {0.86, 0.044, 0.046},
                    {0.875, 0.05, 0.052},
                    {1.0, 0.046, 0.048},
                    {1.12, 0.049, 0.051},
                    {1.25, 0.053, 0.056},
                    {1.36, 0.06, 0.066},
                    {1.43, 0.055, 0.06},
                    {1.455, 0.03, 0.032},
                    {1.46, 0, 0}},
                   18, sleeve, joint_place(left ? arm_l : arm_r).x);
    }
    return shape;
}

RiggedShape trousers() {
    RiggedShape shape;
    for (const bool left : {true, false}) {
        const JointChain leg = left ? hanging({thigh_l, shin_l, foot_l}) : hanging({thigh_r, shin_r, foot_r});
        add_slices(shape,
                   {{0.22, 0, 0},
                    {0.225, 0.05, 0.055},
                    {0.35, 0.062, 0.066},
                    {0.49, 0.062, 0.066},
                    {0.62, 0.076, 0.08},
                    {0.78, 0.088, 0.095},
                    {0.9, 0.09, 0.1},
                    {0.96, 0.06, 0.08},
                    {0.98, 0, 0}},
                   18, leg, joint_place(left ? thigh_l : thigh_r).x);
    }
    return shape;
}

// Boots with a turned-down top, the belt, and a bag's strap is left to the cloak.
RiggedShape leather() {
    RiggedShape shape;
    for (const bool left : {true, false}) {
        const double x = joint_place(left ? thigh_l : thigh_r).x;
        const JointChain boot = left ? hanging({shin_l, foot_l}) : hanging({shin_r, foot_r});
        add_slices(shape,
                   {{0.03, 0, 0, 0.01},
                    {0.035, 0.045, 0.055, 0.01},
                    {0.1, 0.05, 0.06, 0.005},
                    {0.18, 0.055, 0.062},
                    {0.29, 0.066, 0.072},
                    {0.3, 0.075, 0.081},
                    {0.345, 0.08, 0.086},
                    {0.35, 0.07, 0.075},
                    {0.352, 0, 0}},
                   20, boot, x);
        const JointChain sole = only(left ? foot_l : foot_r);
        std::vector<Ring> rings = capsule({x, 0, 0.06}, {x, 0.1, 0.045}, 0.05, 0.047, 2.5, 2, 8);
        shape.add_tube(rings, 28, &sole);
    }
    add_slices(shape,
               {{0.985, 0, 0},
                {0.985, 0.142, 0.107},
                {0.995, 0.147, 0.112},
                {1.02, 0.147, 0.112},
                {1.03, 0.142, 0.107},
                {1.03, 0, 0}},
               28, torso());
    return shape;
}

// Head and hands. The face looks along +Z.
RiggedShape skin() {
    RiggedShape shape;
    const JointChain skull = only(head);
    constexpr int kRings = 24;
    const dvec3 centre = joint_place(head) + dvec3(0, 0.11, 0.012);
    std::vector<Ring> rings;
    for (int i = 0; i <= kRings; ++i) {
        const double angle = std::numbers::pi * i / kRings;
        const double wide = i == 0 || i == kRings ? 0 : std::sin(angle);
        // Narrower towards the chin.
        const double jaw = 1 - 0.2 * std::max(0.0, std::cos(angle));
        rings.push_back(
            {centre - dvec3(0, 0.122 * std::cos(angle), 0), 0.086 * wide * jaw, 0.1 * wide * jaw});
    }
    const std::size_t first = shape.positions.size();
    shape.add_tube(rings, 32, &skull);
    for (std::size_t i = first; i < shape.positions.size(); ++i) {
        dvec3& p = shape.positions[i];
        const auto bump = [&](const dvec3& at, const dvec3& size) {
            const dvec3 d = (p - centre - at) / size;
            return std::exp(-glm::dot(d, d));
        };
        p.z += 0.017 * bump({0, -0.012, 0.1}, {0.02, 0.026, 0.05}) -
               0.008 * (bump({0.034, 0.018, 0.09}, {0.02, 0.015, 0.05}) +
                        bump({-0.034, 0.018, 0.09}, {0.02, 0.015, 0.05}));
    }
    const JointChain throat = chain({{head, 0}, {neck, 1.52}});
    add_slices(shape, {{1.42, 0, 0}, {1.42, 0.048, 0.05}, {1.56, 0.044, 0.048}, {1.57, 0, 0}}, 16, throat);
    for (const bool left : {true, false}) {
        const JointChain palm = only(left ? hand_l : hand_r);
        const double x = joint_place(left ? hand_l : hand_r).x;
        std::vector<Ring> fist = capsule({x, 0.765, 0.008}, {x, 0.89, 0}, 0.033, 0.033, 1.3, 3, 5);
        shape.add_tube(fist, 14, &palm);
    }
    return shape;
}

RiggedShape eyes() {
    RiggedShape shape;
    const JointChain skull = only(head);
    for (const double x : {-0.032, 0.032}) {
        constexpr int kRings = 6;
        std::vector<Ring> rings;
        for (int i = 0; i <= kRings; ++i) {
            const double angle = std::numbers::pi * i / kRings;
            const double wide = i == 0 || i == kRings ? 0 : 0.011 * std::sin(angle);
            rings.push_back({{x, 1.652 - 0.014 * std::cos(angle), 0.098}, wide, wide});
        }
        shape.add_tube(rings, 10, &skull);
    }
    return shape;
}

RiggedShape hair() {
    RiggedShape shape;
    add_slices(shape,
               {{1.5, 0, 0, -0.035},
                {1.505, 0.075, 0.05, -0.04},
                {1.55, 0.096, 0.075, -0.034},
                {1.62, 0.1, 0.088, -0.026},
                {1.68, 0.099, 0.096, -0.012},
                {1.74, 0.07, 0.075, -0.005},
                {1.762, 0, 0, 0}},
               24, chain({{head, 0}, {neck, 1.5}}));
    return shape;
}

// A brim, and a crown that hangs over behind.
RiggedShape hat() {
    RiggedShape shape;
    add_slices(shape,
               {{1.686, 0, 0},
                {1.686, 0.09, 0.1},
                {1.684, 0.165, 0.168},
                {1.69, 0.172, 0.175},
                {1.697, 0.165, 0.168},
                {1.702, 0.108, 0.116},
                {1.72, 0.103, 0.112},
                {1.77, 0.094, 0.102, -0.004},
                {1.82, 0.074, 0.08, -0.014},
                {1.87, 0.05, 0.054, -0.034},
                {1.905, 0.03, 0.033, -0.06},
                {1.92, 0.016, 0.018, -0.085},
                {1.922, 0, 0, -0.095}},
               32, only(head));
    return shape;
}

RiggedShape scarf() {
    RiggedShape shape;
    add_slices(shape,
               {{1.425, 0, 0},
                {1.425, 0.075, 0.07},
                {1.435, 0.1, 0.09, 0.004},
                {1.465, 0.108, 0.098, 0.006},
                {1.495, 0.094, 0.088, 0.004},
                {1.52, 0.078, 0.076},
                {1.53, 0.06, 0.06},
                {1.53, 0, 0}},
               28, chain({{neck, 0}, {chest, 1.45}}));
    return shape;
}

// A thin slab of quads round shoulders and back, open in front: the cage of a Catmull-Clark surface.
Mesh cloak(std::uint32_t material) {
    constexpr int kRound = 24, kDown = 10;
    constexpr double kThick = 0.016, kOpen = 1.7;  // metres; radians from the back to an edge
    struct Level {
        double y, radius, flat;
    };
    constexpr Level kLevels[kDown + 1] = {{1.505, 0.085, 1},  {1.495, 0.13, 0.9},  {1.465, 0.21, 0.74},
                                          {1.4, 0.28, 0.64},  {1.27, 0.298, 0.64}, {1.14, 0.298, 0.68},
                                          {1.02, 0.3, 0.73},  {0.9, 0.305, 0.79},  {0.78, 0.314, 0.84},
                                          {0.67, 0.328, 0.9}, {0.58, 0.345, 0.94}};
    const JointChain hang = hanging({chest, cape_1, cape_2, cape_3});
    const auto point = [&](int round, int down, bool outer) {
        const double u = 2.0 * round / kRound - 1, v = static_cast<double>(down) / kDown;
        const Level& level = kLevels[down];
        const double angle = kOpen * u;
        const double fold = 1 + 0.13 * v * std::cos(6 * std::numbers::pi * u);
        const double radius = (level.radius - (outer ? 0 : kThick)) * fold;
        // In front it is shorter.
        const double up = 0.16 * v * u * u;
        return dvec3(radius * std::sin(angle), level.y + up - (outer ? 0 : 0.3 * kThick),
                     -radius * level.flat * std::cos(angle) - 0.01);
    };
    Mesh mesh;
    mesh.name = "cloak";
    mesh.material = material;
    mesh.cage = SubdivisionCage{};
    mesh.cage->level = 1;
    const auto quad = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        add_hanging_face(mesh, {a, b, c, d}, hang);
    };
    const auto both = [&](int r, int d, int r2, int d2) {  // an edge of the slab
        quad(point(r, d, false), point(r, d, true), point(r2, d2, true), point(r2, d2, false));
    };
    for (int d = 0; d < kDown; ++d) {
        for (int r = 0; r < kRound; ++r) {
            quad(point(r, d, true), point(r + 1, d, true), point(r + 1, d + 1, true), point(r, d + 1, true));
            quad(point(r, d, false), point(r, d + 1, false), point(r + 1, d + 1, false),
                 point(r + 1, d, false));
        }
        both(0, d, 0, d + 1);
        both(kRound, d + 1, kRound, d);
    }
    for (int r = 0; r < kRound; ++r) {
        both(r + 1, 0, r, 0);
        both(r, kDown, r + 1, kDown);
    }
    return mesh;
}

}  // namespace

std::vector<std::uint32_t> add_hero_meshes(Builder& b) {
    std::vector<std::uint32_t> meshes;
    const auto add = [&](Mesh mesh) {
        b.scene.meshes.push_back(std::move(mesh));
        meshes.push_back(static_cast<std::uint32_t>(b.scene.meshes.size() - 1));
    };
    const auto dressed = [&](const char* name, const RiggedShape& shape, const vec3& colour) {
        add(edged_mesh(name, shape, b.matte(name, colour)));
    };
    dressed("hero-tunic", tunic(), {0.13f, 0.2f, 0.27f});
    dressed("hero-trousers", trousers(), {0.1f, 0.085f, 0.075f});
    dressed("hero-leather", leather(), {0.2f, 0.105f, 0.05f});
    dressed("hero-skin", skin(), {0.6f, 0.4f, 0.29f});
    dressed("hero-eyes", eyes(), {0.03f, 0.02f, 0.02f});
    dressed("hero-hair", hair(), {0.12f, 0.055f, 0.025f});
    dressed("hero-hat", hat(), {0.15f, 0.24f, 0.25f});
    dressed("hero-scarf", scarf(), {0.5f, 0.09f, 0.06f});
    add(cloak(b.matte("hero-cloak", {0.36f, 0.3f, 0.25f})));
    return meshes;
}

}  // namespace lanthorn::scene_generator
