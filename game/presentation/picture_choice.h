// How large the picture is, with which preset it is drawn and in what time: what the player has chosen, in
// place of what the command line asks for.
#pragma once

#include <string>

#include "game/presentation/options.h"
#include "game/presentation/preferences.h"

namespace lanthorn::game {

class PictureChoice {
  public:
    // What `options` ask for holds until the player chooses otherwise, and is not kept. `software_gl`: OpenGL
    // runs on the CPU.
    PictureChoice(const Options& options, Preferences preferences, bool software_gl);

    // The player's choice, whose preset and budget are those that she sees: preset() and frame_budget(), or
    // others.
    void choose(const Preferences& chosen);
    const Preferences& preferences() const { return preferences_; }  // to be kept

    std::string preset() const;
    double frame_budget() const;  // milliseconds; 0: as long as it takes
    ivec2 size() const;           // pixels

  private:
    Preferences preferences_;
    std::optional<ivec2> asked_size_;
    std::string asked_preset_;
    ivec2 usual_size_;
    bool software_;
    bool chose_size_ = false, chose_preset_ = false;
};

}  // namespace lanthorn::game
