#include "tools/scene_generator/puppet_figure.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/puppet_joints.h"
#include "tools/scene_generator/walk_cycle.h"

namespace lanthorn::scene_generator {

namespace {

using glm::dquat;

constexpr double kPi = std::numbers::pi;
constexpr int kKeysACycle = 16;

// The angles of a walking puppet beyond its legs.
class Walker {
  public:
    Walker(Builder& b, const PuppetWalk& walk, AnimationClip& clip) : b_(b), walk_(walk), clip_(clip) {
        const int keys = walk.cycles * kKeysACycle;
        for (int k = 0; k <= keys; ++k) {
            times_.push_back(static_cast<float>(walk.seconds * k / keys));
            const double phase = static_cast<double>(k) / kKeysACycle;
            poses_.push_back(walk_pose(phase - std::floor(phase), stride(), {}));
        }
        clip.duration = std::max(clip.duration, times_.back());
    }

    // A rotation, keyed evenly; rotation(k) is key k's.
    template <class Rotation>
    void turn(std::uint32_t node, const Rotation& rotation) {
        AnimationChannel& channel = add(node, AnimationPath::rotation, Interpolation::linear, 4);
        dquat last(1, 0, 0, 0);
        for (std::size_t k = 0; k < times_.size(); ++k) {
            dquat q = rotation(k);
            if (glm::dot(q, last) < 0) {
                q = -q;
            }
            last = q;
            for (const double v : {q.x, q.y, q.z, q.w}) {
                channel.values.push_back(static_cast<float>(v));
            }
        }
    }

    const WalkPose& pose(std::size_t key) const { return poses_[key]; }
    // Of the walk cycle, radians, rising without end.
    double phase(std::size_t key) const { return 2 * kPi * static_cast<double>(key) / kKeysACycle; }
    double stride() const { return 2 * kPi * walk_.radius / walk_.cycles; }

    void lift_hips(std::uint32_t node, const dvec3& place);
    void go_round(std::uint32_t node);
    void move_face(std::uint32_t node);

  private:
    AnimationChannel& add(std::uint32_t node, AnimationPath path, Interpolation interpolation,
                          std::uint32_t width) {
        AnimationChannel channel;
        channel.node = node;
        channel.path = path;
        channel.interpolation = interpolation;
        channel.width = width;
        channel.times = times_;
        clip_.channels.push_back(std::move(channel));
        return clip_.channels.back();
    }

    Builder& b_;
    const PuppetWalk& walk_;
    AnimationClip& clip_;
    std::vector<float> times_;
    std::vector<WalkPose> poses_;
};

void Walker::lift_hips(std::uint32_t node, const dvec3& place) {
    AnimationChannel& channel = add(node, AnimationPath::translation, Interpolation::linear, 3);
    for (std::size_t k = 0; k < times_.size(); ++k) {
        const dvec3 at = place + dvec3(0.02 * std::sin(phase(k)), poses_[k].lift, 0);
        for (int c = 0; c < 3; ++c) {
            channel.values.push_back(static_cast<float>(at[c]));
        }
    }
}

// Round the circle as a spline with the circle's own tangents, facing along it.
void Walker::go_round(std::uint32_t node) {
    constexpr int kKeys = 32;
    const double speed = 2 * kPi / walk_.seconds;  // radians/s
    AnimationChannel& place = add(node, AnimationPath::translation, Interpolation::cubic_spline, 3);
    AnimationChannel heading;
    heading.node = node;
    heading.path = AnimationPath::rotation;
    heading.width = 4;
    place.times.clear();
    for (int k = 0; k <= kKeys; ++k) {
        place.times.push_back(static_cast<float>(walk_.seconds * k / kKeys));
        const double angle = walk_.angle + 2 * kPi * k / kKeys;
        const dvec3 at = walk_.centre + walk_.radius * dvec3(std::sin(angle), 0, std::cos(angle));
        const dvec3 tangent = walk_.radius * speed * dvec3(std::cos(angle), 0, -std::sin(angle));
        for (const dvec3& v : {tangent, at, tangent}) {
            for (int c = 0; c < 3; ++c) {
                place.values.push_back(static_cast<float>(v[c]));
            }
        }
        const dquat q = about_y(angle + 0.5 * kPi);
        for (const double v : {q.x, q.y, q.z, q.w}) {
            heading.values.push_back(static_cast<float>(v));
        }
    }
    heading.times = place.times;
    clip_.channels.push_back(std::move(heading));
    NodeData& data = b_.scene.nodes[node];
    data.local = at(walk_.centre + walk_.radius * dvec3(std::sin(walk_.angle), 0, std::cos(walk_.angle)));
    data.local.rotation = quat(about_y(walk_.angle + 0.5 * kPi));
}

// It talks, smiles twice a round, and raises its brows in between. Weights of jaw, smile, brows.
void Walker::move_face(std::uint32_t node) {
    AnimationChannel& channel = add(node, AnimationPath::weights, Interpolation::linear, 3);
    for (std::size_t k = 0; k < times_.size(); ++k) {
        const double round = 2 * kPi * static_cast<double>(k) / static_cast<double>(times_.size() - 1);
        const double talk = std::max(0.0, std::sin(round)) * (0.5 - 0.5 * std::cos(1.5 * phase(k)));
        const double smile = std::pow(std::max(0.0, -std::sin(2 * round)), 2);
        const double brows = std::pow(std::max(0.0, std::cos(3 * round)), 4);
        for (const double weight : {talk, smile, brows}) {
            channel.values.push_back(static_cast<float>(weight));
        }
    }
}

void move_body(Walker& walker, const PuppetNodes& nodes) {
    using enum PuppetJoint;
    const auto turn = [&](PuppetJoint joint, const auto& rotation) {
        walker.turn(nodes[static_cast<std::size_t>(joint)], rotation);
    };
    const auto pose = [&](std::size_t k) -> const WalkPose& { return walker.pose(k); };
    turn(hips,
         [&](std::size_t k) { return about_y(pose(k).twist) * about_z(0.03 * std::sin(walker.phase(k))); });
    turn(spine, [&](std::size_t k) { return about_y(-pose(k).twist) * about_x(0.03); });
    turn(chest, [&](std::size_t k) { return about_y(-0.8 * pose(k).twist) * about_x(0.02); });
    turn(neck, [&](std::size_t k) { return about_y(0.8 * pose(k).twist) * about_x(-0.05); });
    turn(head, [&](std::size_t k) {
        return about_y(0.35 * std::sin(0.25 * walker.phase(k))) *
               about_x(0.04 * std::sin(2 * walker.phase(k)));
    });
    for (const std::size_t side : {0u, 1u}) {
        turn(side == 0 ? thigh_l : thigh_r, [&](std::size_t k) {
            return about_y(-pose(k).twist) * about_z(-0.03 * std::sin(walker.phase(k))) *
                   about_x(pose(k).thigh[side]);
        });
        turn(side == 0 ? shin_l : shin_r, [&](std::size_t k) { return about_x(pose(k).shin[side]); });
        turn(side == 0 ? foot_l : foot_r, [&](std::size_t k) { return about_x(pose(k).foot[side]); });
    }
    // The left arm carries the lantern before it, the right one swings.
    turn(arm_l, [&](std::size_t k) { return about_z(0.18) * about_x(-0.35 + 0.12 * pose(k).swing); });
    turn(forearm_l, [&](std::size_t) { return about_x(-1.15); });
    turn(hand_l, [&](std::size_t) { return about_x(-0.1); });
    turn(arm_r, [&](std::size_t k) { return about_z(-0.12) * about_x(-pose(k).swing); });
    turn(forearm_r, [&](std::size_t k) { return about_x(-0.25 + 0.3 * std::min(pose(k).swing, 0.0)); });
    turn(hand_r, [&](std::size_t) { return about_x(-0.1); });
    turn(cape_1, [&](std::size_t k) { return about_x(0.10 + 0.04 * std::sin(2 * walker.phase(k))); });
    turn(cape_2, [&](std::size_t k) {
        return about_x(0.10 + 0.08 * std::sin(2 * walker.phase(k) - 0.8)) *
               about_z(0.06 * std::sin(walker.phase(k)));
    });
    turn(cape_3, [&](std::size_t k) {
        return about_x(0.08 + 0.14 * std::sin(2 * walker.phase(k) - 1.6)) *
               about_z(0.1 * std::sin(walker.phase(k) - 0.7));
    });
}

// The hook hangs straight down from the tilted hand, and swings.
void swing_hook(Walker& walker, std::uint32_t hook) {
    walker.turn(hook, [&](std::size_t k) {
        const dquat arm = about_y(-0.8 * walker.pose(k).twist) * about_x(0.05) * about_z(0.18) *
                          about_x(-0.35 + 0.12 * walker.pose(k).swing - 1.25);
        return glm::inverse(arm) * about_x(0.22 * std::sin(walker.phase(k) + 0.6)) *
               about_z(0.15 * std::sin(walker.phase(k) - 0.3));
    });
}

}  // namespace

PuppetNodes add_puppet_joints(Builder& b, const std::string& name, std::uint32_t parent_node) {
    Skin skin;
    skin.name = name;
    PuppetNodes nodes{};
    for (std::size_t j = 0; j < kPuppetJoints; ++j) {
        const PuppetJointPlace& joint = puppet_joints()[j];
        const bool root = joint.parent < 0;
        const auto parent = static_cast<std::size_t>(root ? 0 : joint.parent);
        nodes[j] = b.node(name + "." + joint.name,
                          at(joint.place - (root ? dvec3(0) : puppet_joints()[parent].place)),
                          root ? parent_node : nodes[parent]);
        skin.joints.push_back(nodes[j]);
        skin.inverse_binds.push_back(glm::translate(mat4(1), -vec3(joint.place)));
    }
    b.scene.skins.push_back(std::move(skin));
    return nodes;
}

// glTF 2.0, 3.7.3.1: a skinned mesh's own place does not matter; it stands at the root.
void add_skinned(Builder& b, const std::string& name, std::uint32_t mesh) {
    const std::uint32_t node = b.node(name, {});
    b.scene.nodes[node].meshes = {mesh};
    b.scene.nodes[node].skin = static_cast<std::uint32_t>(b.scene.skins.size() - 1);
}

std::uint32_t add_puppet(Builder& b, const std::string& name, const PuppetMeshes& meshes,
                         const PuppetWalk& walk, AnimationClip& clip) {
    Walker walker(b, walk, clip);
    const std::uint32_t puppet = b.node(name, {});
    walker.go_round(puppet);
    const PuppetNodes nodes = add_puppet_joints(b, name, puppet);
    walker.lift_hips(nodes[0], puppet_joints()[0].place);
    move_body(walker, nodes);

    const std::uint32_t head = nodes[static_cast<std::size_t>(PuppetJoint::head)];
    const std::uint32_t face = b.node(name + ".face", {}, head);
    b.scene.nodes[face].meshes = {meshes.head};
    walker.move_face(face);
    b.scene.nodes[b.node(name + ".eyes", {}, head)].meshes = {meshes.eyes};
    const std::uint32_t hand = nodes[static_cast<std::size_t>(PuppetJoint::hand_l)];
    const std::uint32_t hook = b.node(name + ".hook", at({0, -0.07, 0.01}), hand);
    b.scene.nodes[hook].meshes = {meshes.lantern};
    swing_hook(walker, hook);

    add_skinned(b, name + ".body", meshes.body);
    add_skinned(b, name + ".cape", meshes.cape);
    return hook;
}

}  // namespace lanthorn::scene_generator
