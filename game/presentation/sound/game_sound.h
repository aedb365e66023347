// What is heard of the game: the level behind the screens, what the player does on them, and music.
#pragma once

#include <cstdint>
#include <vector>

#include "game/presentation/preferences.h"
#include "game/presentation/sound/captions.h"
#include "game/presentation/sound/ear.h"
#include "lanthorn/audio/speaker.h"

namespace lanthorn::game {

class GameSound {
  public:
    // `seed`: of the music.
    explicit GameSound(std::uint64_t seed);

    void set_volumes(const Preferences& preferences) {
        speaker_.set_volumes(preferences.effects, preferences.music);
    }
    // On a screen: a button was pressed, or an option changed.
    void add(SoundKind::Name kind);
    // Another level comes.
    void forget() {
        ear_.forget();
        captions_ = {};
    }

    // Of a frame of so many seconds. `world`: the level's; null without one. While it does not run nothing
    // goes on sounding.
    void play(const ecs::World* world, bool runs, double seconds);

    const Captions& captions() const { return captions_; }  // of what was heard lately

  private:
    Ear ear_;
    Captions captions_;
    audio::Speaker speaker_;
    std::vector<Sound> on_screen_;  // since the frame before
};

}  // namespace lanthorn::game
