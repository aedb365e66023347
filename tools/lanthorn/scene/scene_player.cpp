#include "tools/lanthorn/scene/scene_player.h"

#include <fmt/format.h>

#include <charconv>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::tools {

namespace {

std::uint32_t find_wanted(const AnimationSet& set, const std::string& wanted, const std::string& source) {
    if (wanted.empty()) {
        return 0;
    }
    if (const auto named = find_clip(set, wanted)) {
        return *named;
    }
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (error == std::errc() && end == wanted.data() + wanted.size() && number < set.clips->size()) {
        return number;
    }
    std::string known;
    for (std::size_t i = 0; i < set.clips->size(); ++i) {
        known += fmt::format("{} '{}', ", i, (*set.clips)[i].name);
    }
    throw InputError(source, "",
                     fmt::format("found no animation '{}', expected one of {}or none", wanted, known));
}

}  // namespace

ScenePlayer::ScenePlayer(ecs::World& world, const std::string& animation, const std::string& source)
    : world_(world), physics_(world) {
    const std::vector<ecs::Entity> sets = world.query<ecs::With<AnimationSet>>().entities();
    if (sets.empty()) {
        if (!animation.empty() && animation != "none") {
            throw InputError(source, "", fmt::format("found no animation '{}': there is none", animation));
        }
        return;
    }
    if (animation == "none") {
        return;
    }
    player_ = sets.front();
    const AnimationSet& set = world.get<AnimationSet>(player_);
    AnimationPlayer player;
    play(player, set, find_wanted(set, animation, source));
    world.insert(player_, std::move(player));
}

void ScenePlayer::show(double seconds) {
    pose(seconds);
    deform(nullptr);
}

void ScenePlayer::animate(double seconds) {
    if (player_ != ecs::kNullEntity) {
        world_.get_mut<AnimationPlayer>(player_).layers.front().time = seconds;
        animator_.animate(world_, 0);
    }
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
