#include "tools/lanthorn/scene/scene_player.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::tools {

namespace {

std::optional<std::uint32_t> find_wanted(const AnimationSet& set, const std::string& wanted) {
    if (wanted.empty()) {
        return set.clips->empty() ? std::nullopt : std::optional<std::uint32_t>(0);
    }
    if (const auto named = find_clip(set, wanted)) {
        return named;
    }
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (error == std::errc() && end == wanted.data() + wanted.size() && number < set.clips->size()) {
        return number;
    }
    return std::nullopt;
}

std::string names_of_clips(const ecs::World& world, const std::vector<ecs::Entity>& sets) {
    std::string known;
    for (const ecs::Entity e : sets) {
        const std::vector<AnimationClip>& clips = *world.get<AnimationSet>(e).clips;
        for (std::size_t i = 0; i < clips.size(); ++i) {
            known += fmt::format("{} '{}', ", i, clips[i].name);
        }
    }
    return known;
}

}  // namespace

ScenePlayer::ScenePlayer(ecs::World& world, const std::string& animation, const std::string& source)
    : world_(world), physics_(world) {
    const std::vector<ecs::Entity> sets = world.query<ecs::With<AnimationSet>>().entities();
    if (animation == "none") {
        return;
    }
    if (sets.empty() && !animation.empty()) {
        throw InputError(source, "", fmt::format("found no animation '{}': there is none", animation));
    }
    for (const ecs::Entity e : sets) {
        const AnimationSet& set = world.get<AnimationSet>(e);
        if (const auto clip = find_wanted(set, animation)) {
            AnimationPlayer player;
            play(player, set, *clip);
            world.insert(e, std::move(player));
            players_.push_back(e);
        }
    }
    if (players_.empty() && !animation.empty()) {
        throw InputError(source, "",
                         fmt::format("found no animation '{}', expected one of {}or none", animation,
                                     names_of_clips(world, sets)));
    }
}

void ScenePlayer::show(double seconds) {
    pose(seconds);
    deform(nullptr);
}

void ScenePlayer::animate(double seconds) {
    for (const ecs::Entity e : players_) {
        world_.get_mut<AnimationPlayer>(e).layers.front().time = seconds;
    }
    animator_.animate(world_, 0);
}

void ScenePlayer::pose(double seconds) {
    if (physics_.moves()) {
        physics_.run_to(seconds, [this](double t) { animate(t); });
    }
    animate(seconds);
    transforms_.update(world_);
}

void ScenePlayer::deform(const DetailHints* hints) {
    deformation_.update(world_, hints);
}

}  // namespace lanthorn::tools
