// How large the picture is and with which preset it is drawn: what the player has chosen, in place of what
// the command line asks for, as far as the time for a frame allows.
#pragma once

#include <string>

#include "game/presentation/options.h"
#include "game/presentation/preferences.h"
#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::game {

// Milliseconds that a frame may take where OpenGL runs on the CPU and nobody has chosen how the picture is
// drawn: eight a second.
inline constexpr double kBudgetOnCpu = 125;

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
    // As the budget allows.
    ivec2 drawn_size() const;
    const shell::Spending& drawn() const { return budget_.spending(); }

    shell::FrameBudget& budget() { return budget_; }

  private:
    Preferences preferences_;
    std::optional<ivec2> asked_size_;
    std::string asked_preset_;
    ivec2 usual_size_;
    bool software_;
    bool chose_size_ = false, chose_preset_ = false;
    shell::FrameBudget budget_;
};

}  // namespace lanthorn::game
