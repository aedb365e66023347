#include "engine/animation/root_motion.h"

#include <array>

#include "engine/animation/key_sampler.h"

namespace lanthorn {
namespace {

RigidMotion operator*(const RigidMotion& a, const RigidMotion& b) {
    return {a.translation + a.turn * b.translation, glm::normalize(a.turn * b.turn)};
}

RigidMotion inverse(const RigidMotion& m) {
    const glm::dquat back = glm::conjugate(m.turn);
    return {-(back * m.translation), back};
}

// m, `rounds` times (backwards if negative), by squaring.
RigidMotion repeated(RigidMotion m, std::int64_t rounds) {
    if (rounds < 0) {
        m = inverse(m);
    }
    RigidMotion result;
    for (auto left = static_cast<std::uint64_t>(rounds < 0 ? -rounds : rounds); left > 0; left >>= 1) {
        if (left & 1) {
            result = result * m;
        }
        m = m * m;
    }
    return result;
}

// The node's place in its parent at `time` seconds of the clip.
RigidMotion place(const AnimationClip& clip, std::uint32_t node, const RigidMotion& rest, double time) {
    RigidMotion result = rest;
    std::uint32_t hint = 0;
    for (const AnimationChannel& channel : clip.channels) {
        if (channel.node != node) {
            continue;
        }
        std::array<double, 4> v{};
        if (channel.path == AnimationPath::translation) {
            sample(channel, time, hint, std::span(v).first(3));
            result.translation = {v[0], v[1], v[2]};
        } else if (channel.path == AnimationPath::rotation) {
            sample(channel, time, hint, v);
            result.turn = {v[3], v[0], v[1], v[2]};
        }
    }
    return result;
}

// What of a place counts as motion; the rest stays as at the clip's start.
RigidMotion counted(const RootMotion& root, RigidMotion at, const RigidMotion& start) {
    if (!root.vertical) {
        at.translation.y = start.translation.y;
    }
    if (!root.rotation) {
        at.turn = start.turn;
    }
    return at;
}

}  // namespace

RigidMotion root_motion(const AnimationClip& clip, const RootMotion& root, const RigidMotion& rest,
                        LoopMode loop, double from, double to) {
    const RigidMotion start = place(clip, root.node, rest, 0);
    const RigidMotion to_start = inverse(start);
    // The parent's motion since the clip's start.
    const auto moved = [&](double time) {
        return counted(root, place(clip, root.node, rest, time), start) * to_start;
    };
    const ClipMoment before = clip_moment(loop, from, clip.duration);
    const ClipMoment after = clip_moment(loop, to, clip.duration);
    RigidMotion between;
    if (after.rounds != before.rounds) {
        between = repeated(moved(clip.duration), after.rounds - before.rounds);
    }
    return inverse(moved(before.time)) * between * moved(after.time);
}

RigidMotion without_motion(const AnimationClip& clip, const RootMotion& root, const RigidMotion& rest,
                           double time) {
    RigidMotion result = place(clip, root.node, rest, 0);
    const RigidMotion now = place(clip, root.node, rest, time);
    if (!root.vertical) {
        result.translation.y = now.translation.y;
    }
    if (!root.rotation) {
        result.turn = now.turn;
    }
    return result;
}

}  // namespace lanthorn
