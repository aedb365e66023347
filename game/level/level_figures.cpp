// Figures of a level that begins.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "game/level/level_starts.h"
#include "game/rules/components.h"
#include "game/rules/figures.h"
#include "game/rules/headings.h"
#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"

namespace lanthorn::game {

namespace {

using ecs::Entity;
using ecs::World;

const Eyes* eyes_below(const World& world, Entity e) {
    for (const Entity child : children_of(world, e)) {
        if (const Eyes* eyes = world.try_get<Eyes>(child)) {
            return eyes;
        }
    }
    return nullptr;
}

// The file's clips, and the nodes that they move; null: it has none.
const AnimationSet* clips_of(World& world) {
    const std::vector<Entity> found = world.query<ecs::With<AnimationSet>>().entities();
    return found.empty() ? nullptr : world.try_get<AnimationSet>(found.front());
}

// The named clips of the file, on `e` itself; the first of them shows.
void give_clips(World& world, Entity e, const AnimationSet& set, const std::string& source,
                const std::vector<std::string>& names) {
    AnimationPlayer player;
    for (const std::string& name : names) {
        const std::optional<std::uint32_t> clip = find_clip(set, name);
        if (!clip) {
            fail(world, e, source, "names a clip '" + name + "', which the file has not");
        }
        AnimationLayer layer;
        layer.clip = *clip;
        layer.weight = player.layers.empty() ? 1 : 0;
        player.layers.push_back(layer);
    }
    world.insert(e, AnimationSet(set));
    world.insert(e, std::move(player));
}

void start_bodies(World& world, const std::string& source) {
    const AnimationSet* found = clips_of(world);
    const AnimationSet set = found != nullptr ? *found : AnimationSet{};
    const auto check = [&](Entity e) {
        if (!set.clips || !parent_of(world, e)) {
            fail(world, e, source, "is a figure's, expected it below another node in a file with clips");
        }
    };
    for (const Entity e : world.query<ecs::With<Figure>>().entities()) {
        check(e);
        Figure& figure = world.get_mut<Figure>(e);
        figure.place = dvec3(world.get<WorldTransform>(e).matrix[3]);
        if (const Eyes* eyes = eyes_below(world, parent_of(world, e))) {
            figure.yaw = eyes->yaw;
        } else {
            const dvec3 front = world.get<LocalTransform>(e).value.rotation * vec3(0, 0, 1);
            figure.yaw = heading_of(front);
        }
        give_clips(world, e, set, source, {figure.idle, figure.walk});
        world.insert(e, Interpolated{});
    }
    for (const Entity e : world.query<ecs::With<Hand>>().entities()) {
        check(e);
        Entity above = parent_of(world, e);
        while (above && !world.has<Figure>(above)) {
            above = parent_of(world, above);
        }
        if (!above) {
            fail(world, e, source, "has a hand, expected {\"figure\": {}} above it");
        }
        Hand& hand = world.get_mut<Hand>(e);
        hand.figure = above;
        const std::vector<std::string> names = {hand.idle, hand.walk, hand.reach, hand.close};
        give_clips(world, e, set, source, names);
    }
}

void start_followers(World& world, const std::string& source) {
    for (const Entity e : world.query<ecs::With<Follower>>().entities()) {
        if (parent_of(world, e)) {
            fail(world, e, source, "has a follower and is below another node, expected a root node");
        }
        const Follower& follower = world.get<Follower>(e);
        if (follower.near > follower.far) {
            fail(world, e, source,
                 fmt::format(
                     "has a follower that stops at {} m and follows from {} m on, expected near <= far",
                     follower.near, follower.far));
        }
        world.insert(e, Interpolated{});
    }
}

// From there on the player sees with it.
void start_camera(World& world, const std::string& source) {
    const std::vector<Entity> found = world.query<ecs::With<FollowCamera>>().entities();
    if (found.empty()) {
        return;
    }
    const Entity e = found.front();
    if (found.size() > 1 || !world.has<CameraComponent>(e) || parent_of(world, e)) {
        fail(world, e, source, "has a follow_camera, expected one a level, on a camera below no other node");
    }
    FollowCamera& camera = world.get_mut<FollowCamera>(e);
    camera.beside = camera.aside;
    camera.back = camera.distance;
    world.insert(e, Interpolated{});
    world.resource_mut<View>().camera = e;
}

}  // namespace

void start_clip(World& world, const std::string& source) {
    if (!named_clip(world).empty()) {
        play_clip(world, "", source);
        return;
    }
    std::vector<std::string> taken;
    world.query<ecs::Read<Figure>>().each([&](const Figure& figure) {
        taken.insert(taken.end(), {figure.idle, figure.walk});
    });
    world.query<ecs::Read<Hand>>().each([&](const Hand& hand) {
        taken.insert(taken.end(), {hand.idle, hand.walk, hand.reach, hand.close});
    });
    const AnimationSet* set = clips_of(world);
    for (std::size_t i = 0; set != nullptr && i < set->clips->size(); ++i) {
        if (std::ranges::find(taken, (*set->clips)[i].name) == taken.end()) {
            play_clip(world, std::to_string(i), source);
            return;
        }
    }
}

void start_figures(World& world, const std::string& source) {
    start_bodies(world, source);
    start_followers(world, source);
    start_camera(world, source);
}

}  // namespace lanthorn::game
