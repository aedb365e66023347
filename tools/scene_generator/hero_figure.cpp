#include "tools/scene_generator/hero_figure.h"

#include <cmath>
#include <numbers>

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/hero_meshes.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/walk_cycle.h"

namespace lanthorn::scene_generator {

namespace {

using glm::dquat;
using enum PuppetJoint;

constexpr double kPi = std::numbers::pi;
constexpr double kStride = 1.3;  // metres, of the hero's two steps
constexpr Gait kGait{0.2, 0.09, 0.014};

// A clip of `keys` even spans.
class Keys {
  public:
    Keys(const std::string& name, double seconds, int keys, const PuppetNodes& nodes) : nodes_(nodes) {
        clip_.name = name;
        clip_.duration = static_cast<float>(seconds);
        for (int k = 0; k <= keys; ++k) {
            times_.push_back(static_cast<float>(seconds * k / keys));
        }
    }

    // A rotation by the phase, 0 to 1.
    template <class Rotation>
    void turn(PuppetJoint joint, const Rotation& rotation) {
        AnimationChannel& channel = add(joint, AnimationPath::rotation, 4);
        dquat last(1, 0, 0, 0);
        for (std::size_t k = 0; k < times_.size(); ++k) {
            dquat q = rotation(phase(k));
            q = glm::dot(q, last) < 0 ? -q : q;
            last = q;
            for (const double v : {q.x, q.y, q.z, q.w}) {
                channel.values.push_back(static_cast<float>(v));
            }
        }
    }
    template <class Place>
    void move(PuppetJoint joint, const Place& place) {
        AnimationChannel& channel = add(joint, AnimationPath::translation, 3);
        for (std::size_t k = 0; k < times_.size(); ++k) {
            const dvec3 at = place(phase(k));
            for (int c = 0; c < 3; ++c) {
                channel.values.push_back(static_cast<float>(at[c]));
            }
        }
    }
    AnimationClip take() { return std::move(clip_); }

  private:
    double phase(std::size_t k) const {
        return static_cast<double>(k % (times_.size() - 1)) / static_cast<double>(times_.size() - 1);
    }
    AnimationChannel& add(PuppetJoint joint, AnimationPath path, std::uint32_t width) {
        AnimationChannel channel;
        channel.node = nodes_[static_cast<std::size_t>(joint)];
        channel.path = path;
        channel.interpolation = Interpolation::linear;
        channel.width = width;
        channel.times = times_;
        clip_.channels.push_back(std::move(channel));
        return clip_.channels.back();
    }

    const PuppetNodes& nodes_;
    AnimationClip clip_;
    std::vector<float> times_;
};

double wave(double phase, double late = 0) {
    return std::sin(2 * kPi * phase - late);
}

void swing_arm(Keys& keys, bool left, double stride) {
    const double side = left ? 1 : -1;
    keys.turn(left ? arm_l : arm_r, [=](double p) {
        return about_z(0.14 * side) * about_x(-0.05 + side * 0.9 * walk_pose(p, stride, {}, kGait).swing);
    });
    keys.turn(left ? forearm_l : forearm_r, [=](double p) {
        return about_x(-0.38 + 0.25 * std::min(side * walk_pose(p, stride, {}, kGait).swing, 0.0));
    });
    keys.turn(left ? hand_l : hand_r, [](double) { return about_x(-0.1); });
}

void rest_arm(Keys& keys, bool left) {
    const double side = left ? 1 : -1;
    keys.turn(left ? arm_l : arm_r,
              [=](double p) { return about_z((0.13 + 0.012 * wave(p)) * side) * about_x(0.04); });
    keys.turn(left ? forearm_l : forearm_r, [](double p) { return about_x(-0.24 + 0.02 * wave(p, 0.5)); });
    keys.turn(left ? hand_l : hand_r, [](double) { return about_x(-0.1); });
}

// What brings the right hand's hook to `target`, metres from the shoulder joint, elbow below: radians.
struct Bend {
    double aside, shoulder, elbow;
};
Bend bend_to(const dvec3& target) {
    constexpr double kUpper = 0.28, kLower = 0.32;  // metres, shoulder to elbow to hook
    const double forward = std::atan2(target.z, -target.y), reach = std::hypot(target.y, target.z);
    const double at_shoulder =
        std::acos((kUpper * kUpper + reach * reach - kLower * kLower) / (2 * kUpper * reach));
    const double at_elbow =
        std::acos((kUpper * kUpper + kLower * kLower - reach * reach) / (2 * kUpper * kLower));
    return {std::atan2(target.x, reach), forward - at_shoulder, kPi - at_elbow};
}

// With a little rise and fall.
void hold_arm(Keys& keys, const dvec3& target) {
    const auto bend = [=](double p) { return bend_to(target + dvec3(0, 0.012 * wave(2 * p), 0)); };
    const double aside = bend_to(target).aside;
    keys.turn(arm_r, [=](double p) { return about_y(aside) * about_x(-bend(p).shoulder); });
    keys.turn(forearm_r, [=](double p) { return about_x(-bend(p).elbow); });
    keys.turn(hand_r, [](double) { return dquat(1, 0, 0, 0); });
}

// What a clip of the whole body does with the right arm: nothing, where clips of its own move it.
enum class RightArm { alone, swings, holds };
// Where the hand of a puppet is that holds a lantern out, metres from the shoulder.
constexpr dvec3 kBearing{-0.1, -0.3, 0.36};

void swing_cape(Keys& keys, double back, double size) {
    keys.turn(cape_1, [=](double p) { return about_x(0.5 * back + 0.03 * size * wave(2 * p)); });
    keys.turn(cape_2, [=](double p) {
        return about_x(back + 0.06 * size * wave(2 * p, 0.8)) * about_z(0.04 * size * wave(p));
    });
    keys.turn(cape_3, [=](double p) {
        return about_x(back + 0.1 * size * wave(2 * p, 1.6)) * about_z(0.07 * size * wave(p, 0.7));
    });
}

AnimationClip walk(const std::string& name, double seconds, double stride, const PuppetNodes& nodes,
                   RightArm right) {
    Keys keys(name, seconds, 24, nodes);
    const auto pose = [=](double p) { return walk_pose(p, stride, {}, kGait); };
    const dvec3 hip = joint_place(hips);
    keys.move(hips, [&](double p) { return hip + dvec3(0.018 * wave(p), pose(p).lift, 0); });
    keys.turn(hips, [&](double p) { return about_y(pose(p).twist) * about_z(0.035 * wave(p)); });
    keys.turn(spine, [&](double p) { return about_y(-pose(p).twist) * about_x(0.05); });
    keys.turn(chest, [&](double p) { return about_y(-0.8 * pose(p).twist) * about_x(0.03); });
    keys.turn(neck, [&](double p) { return about_y(0.8 * pose(p).twist) * about_x(-0.05); });
    keys.turn(head, [&](double p) { return about_x(-0.02 + 0.02 * wave(2 * p)); });
    for (const std::size_t side : {0u, 1u}) {
        keys.turn(side == 0 ? thigh_l : thigh_r, [&](double p) {
            return about_y(-pose(p).twist) * about_z(-0.035 * wave(p)) * about_x(pose(p).thigh[side]);
        });
        keys.turn(side == 0 ? shin_l : shin_r, [&](double p) { return about_x(pose(p).shin[side]); });
        keys.turn(side == 0 ? foot_l : foot_r, [&](double p) { return about_x(pose(p).foot[side]); });
    }
    swing_arm(keys, true, stride);
    if (right == RightArm::swings) {
        swing_arm(keys, false, stride);
    } else if (right == RightArm::holds) {
        hold_arm(keys, kBearing);
    }
    swing_cape(keys, 0.1, 1);
    return keys.take();
}

// Breathes, shifts its weight and looks about a little.
AnimationClip idle(const std::string& name, double seconds, const PuppetNodes& nodes, RightArm right) {
    Keys keys(name, seconds, 16, nodes);
    const dvec3 hip = joint_place(hips);
    keys.move(hips, [&](double p) { return hip + dvec3(0.006 * wave(p), -0.004 + 0.002 * wave(2 * p), 0); });
    keys.turn(hips, [](double) { return dquat(1, 0, 0, 0); });
    keys.turn(spine, [](double p) { return about_x(0.008 * wave(2 * p)); });
    keys.turn(chest, [](double p) { return about_x(-0.014 * wave(2 * p)); });
    keys.turn(neck, [](double) { return about_x(-0.02); });
    keys.turn(head, [](double p) { return about_y(0.07 * wave(p, 1)) * about_x(0.015 * wave(p)); });
    for (const bool left : {true, false}) {
        const double side = left ? 1 : -1;
        // A straight leg from where the hips have gone to where the foot stands.
        keys.turn(left ? thigh_l : thigh_r,
                  [=](double p) { return about_z(0.03 * side - 0.007 * wave(p)) * about_x(-0.1); });
        keys.turn(left ? shin_l : shin_r, [](double) { return about_x(0.14); });
        keys.turn(left ? foot_l : foot_r,
                  [=](double p) { return about_x(-0.04) * about_z(-0.03 * side + 0.007 * wave(p)); });
    }
    rest_arm(keys, true);
    if (right == RightArm::swings) {
        rest_arm(keys, false);
    } else if (right == RightArm::holds) {
        hold_arm(keys, kBearing);
    }
    swing_cape(keys, 0.03, 0.2);
    return keys.take();
}

void add_arm_clips(Builder& b, const PuppetNodes& nodes, const dvec3& out) {
    const auto add = [&](const char* name, double seconds, int keys_of, const auto& fill) {
        Keys keys(std::string("hero.arm.") + name, seconds, keys_of, nodes);
        fill(keys);
        b.scene.animations.push_back(keys.take());
    };
    const dvec3 shoulder = joint_place(arm_r);
    add("idle", 4, 16, [](Keys& keys) { rest_arm(keys, false); });
    add("walk", 1, 24, [](Keys& keys) { swing_arm(keys, false, kStride); });
    add("reach", 1, 16, [&](Keys& keys) { hold_arm(keys, out - shoulder); });
    add("close", 1, 16, [](Keys& keys) { hold_arm(keys, {0.03, -0.15, 0.2}); });
}

}  // namespace

void add_hero(Builder& b, std::uint32_t player) {
    const std::uint32_t figure = b.node("hero", {}, player);
    b.scene.nodes[figure].extras = R"({"figure":{"idle":"hero.idle","walk":"hero.walk","stride":1.3}})";
    const PuppetNodes nodes = add_puppet_joints(b, "hero", figure);
    const std::uint32_t hook =
        b.node("hero.hook", at({0, -0.07, 0}), nodes[static_cast<std::size_t>(hand_r)]);
    b.scene.nodes[hook].extras =
        R"({"hand":{"idle":"hero.arm.idle","walk":"hero.arm.walk","reach":"hero.arm.reach",)"
        R"("close":"hero.arm.close","out":[-0.26,1.36,0.46]}})";
    for (const std::uint32_t mesh : add_hero_meshes(b)) {
        add_skinned(b, b.scene.meshes[mesh].name, mesh);
    }
    b.scene.animations.push_back(idle("hero.idle", 4, nodes, RightArm::alone));
    b.scene.animations.push_back(walk("hero.walk", 1, kStride, nodes, RightArm::alone));
    add_arm_clips(b, nodes, {-0.26, 1.36, 0.46});
    const std::uint32_t camera = b.camera("view", at({0, 1.7, 0}), glm::radians(56.0f));
    b.scene.nodes[camera].extras = R"({"follow_camera":{}})";
}

namespace {

constexpr float kSmall = 0.54f;  // of a puppet's size, that of one that follows
// Dark enough for a lantern at arm's length not to burn it out.
constexpr PuppetDress kDress{{0.04f, 0.055f, 0.04f}, {0.22f, 0.03f, 0.025f}, {0.13f, 0.085f, 0.055f}};

// A small puppet that stands on `feet`, and its joints.
PuppetNodes add_small_puppet(Builder& b, const std::string& name, const dvec3& feet,
                             const PuppetMeshes& meshes, const std::string& extras, RightArm right) {
    const std::uint32_t root = b.node(name, at(feet));
    b.scene.nodes[root].extras = extras;
    Transform small;
    small.scale = vec3(kSmall);
    const std::uint32_t figure = b.node(name + "-figure", small, root);
    b.scene.nodes[figure].extras =
        R"({"figure":{"idle":")" + name + R"(.idle","walk":")" + name + R"(.walk","stride":0.65}})";
    const PuppetNodes nodes = add_puppet_joints(b, name, figure);
    const std::uint32_t skull = nodes[static_cast<std::size_t>(head)];
    b.scene.nodes[b.node(name + ".face", {}, skull)].meshes = {meshes.head};
    b.scene.nodes[b.node(name + ".eyes", {}, skull)].meshes = {meshes.eyes};
    add_skinned(b, name + ".body", meshes.body);
    add_skinned(b, name + ".cape", meshes.cape);
    b.scene.animations.push_back(idle(name + ".idle", 3, nodes, right));
    b.scene.animations.push_back(walk(name + ".walk", 1, 0.65 / kSmall, nodes, right));
    return nodes;
}

}  // namespace

void add_follower(Builder& b, const std::string& name, const dvec3& feet) {
    add_small_puppet(b, name, feet, add_puppet_meshes(b, kDress), R"({"follower":{}})", RightArm::swings);
}

void add_lamp_bearer(Builder& b, const std::string& name, const dvec3& feet, const vec3& colour,
                     float candela) {
    const PuppetMeshes meshes = add_puppet_meshes(b, kDress);
    const PuppetNodes nodes = add_small_puppet(
        b, name, feet, meshes, R"({"follower":{"near":1.1},"heeds":{"waits":true}})", RightArm::holds);
    // Upright in a hand that is not.
    const Bend bend = bend_to(kBearing);
    Transform upright = at({0, -0.04, 0});
    upright.rotation =
        quat(glm::inverse(about_y(bend.aside) * about_x(-bend.shoulder) * about_x(-bend.elbow)));
    const std::uint32_t grip = b.node(name + ".grip", upright, nodes[static_cast<std::size_t>(hand_r)]);
    constexpr double kLean = 0.45, kAbove = 0.85, kBelow = 0.5, kThick = 0.014;  // radians; metres
    Transform leaning;
    leaning.rotation = quat(about_x(kLean));
    b.solid(name + ".staff", box({-kThick, -kBelow, -kThick}, {kThick, kAbove, kThick}),
            b.matte(name + "-staff", {0.2f, 0.12f, 0.06f}, 0.5f), {}, leaning, grip);
    Transform tip = at({0, kAbove * std::cos(kLean), kAbove * std::sin(kLean) + 0.02});
    tip.scale = vec3(1.5f);
    const std::uint32_t hook = b.node(name + ".hook", tip, grip);
    b.scene.nodes[hook].meshes = {meshes.lantern};
    add_flame(b, name + "-flame", {0, -0.18, 0}, colour, candela, 0.1, hook);
}

}  // namespace lanthorn::scene_generator
