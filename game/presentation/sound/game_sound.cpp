#include "game/presentation/sound/game_sound.h"

#include <memory>
#include <span>

#include "game/presentation/sound/music.h"

namespace lanthorn::game {

namespace {

audio::Repertoire repertoire(std::uint64_t seed) {
    const auto music = std::make_shared<Music>(seed);
    return {effects, [music](std::span<float> stereo) { music->next(stereo); }};
}

}  // namespace

GameSound::GameSound(std::uint64_t seed) : speaker_(repertoire(seed)) {}

void GameSound::add(SoundKind::Name kind) {
    on_screen_.push_back({.kind = static_cast<audio::Kind>(kind), .placed = false});
}

void GameSound::play(const ecs::World* world, bool runs, double seconds) {
    Heard heard;
    if (world != nullptr) {
        heard = ear_.listen(*world);
        if (!runs) {
            heard.going.clear();
        }
    }
    if (runs) {
        captions_.pass(seconds);
        captions_.hear(heard);
    }
    heard.begun.insert(heard.begun.end(), on_screen_.begin(), on_screen_.end());
    on_screen_.clear();
    speaker_.play(heard);
}

}  // namespace lanthorn::game
