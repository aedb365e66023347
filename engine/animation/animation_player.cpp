#include "lanthorn/animation/animation_player.h"

#include <algorithm>

namespace lanthorn {
namespace {

double duration_of(const AnimationSet& set, std::uint32_t clip) {
    return set.clips && clip < set.clips->size() ? (*set.clips)[clip].duration : 0.0;
}

AnimationLayer started(const AnimationSet& set, std::uint32_t clip, LoopMode loop, double speed) {
    AnimationLayer layer;
    layer.clip = clip;
    layer.loop = loop;
    layer.speed = speed;
    layer.time = loop == LoopMode::once && speed < 0 ? duration_of(set, clip) : 0;
    return layer;
}

}  // namespace

std::optional<std::uint32_t> find_clip(const AnimationSet& set, std::string_view name) {
    for (std::size_t i = 0; set.clips && i < set.clips->size(); ++i) {
        if ((*set.clips)[i].name == name) {
            return static_cast<std::uint32_t>(i);
        }
    }
    return std::nullopt;
}

AnimationLayer& play(AnimationPlayer& player, const AnimationSet& set, std::uint32_t clip, LoopMode loop,
                     double speed) {
    player.layers.clear();
    return player.layers.emplace_back(started(set, clip, loop, speed));
}

AnimationLayer& cross_fade(AnimationPlayer& player, const AnimationSet& set, std::uint32_t clip,
                           double seconds, LoopMode loop, double speed) {
    if (!(seconds > 0)) {
        return play(player, set, clip, loop, speed);
    }
    const auto found = std::find_if(player.layers.begin(), player.layers.end(),
                                    [&](const AnimationLayer& layer) { return layer.clip == clip; });
    const auto at = static_cast<std::size_t>(found - player.layers.begin());
    if (found == player.layers.end()) {
        player.layers.push_back(started(set, clip, loop, speed));
        player.layers.back().weight = 0;
    }
    for (std::size_t i = 0; i < player.layers.size(); ++i) {
        AnimationLayer& layer = player.layers[i];
        layer.fade_to = i == at ? 1 : 0;
        layer.fade_seconds = seconds;
        layer.leaves_after = i != at;
    }
    player.layers[at].loop = loop;
    player.layers[at].speed = speed;
    return player.layers[at];
}

bool finished(const AnimationLayer& layer, const AnimationSet& set) {
    return layer.loop == LoopMode::once &&
           (layer.speed < 0 ? layer.time <= 0 : layer.time >= duration_of(set, layer.clip));
}

}  // namespace lanthorn
