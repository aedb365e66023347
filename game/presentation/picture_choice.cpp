#include "game/presentation/picture_choice.h"

#include <utility>

#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::game {

PictureChoice::PictureChoice(const Options& options, Preferences preferences, bool software_gl)
    : preferences_(std::move(preferences)),
      asked_size_(options.size),
      asked_preset_(options.preset),
      usual_size_(picture_size(options, software_gl)),
      software_(software_gl) {}

void PictureChoice::choose(const Preferences& chosen) {
    chose_size_ = chose_size_ || chosen.picture != preferences_.picture;
    const bool another_preset = chosen.preset != preset();
    const bool another_budget = chosen.frame_budget != frame_budget();
    const Preferences kept = std::exchange(preferences_, chosen);
    if (another_preset) {
        chose_preset_ = true;
    } else {
        preferences_.preset = kept.preset;
    }
    if (!another_budget) {
        preferences_.frame_budget = kept.frame_budget;
    }
}

std::string PictureChoice::preset() const {
    if (!asked_preset_.empty() && !chose_preset_) {
        return asked_preset_;
    }
    return !preferences_.preset.empty() ? preferences_.preset : shell::usual_preset(software_);
}

// A CPU draws far fewer frames than a GPU: there the picture is made smaller to keep some pace, but not where
// somebody has said how large or how well it is to be drawn.
double PictureChoice::frame_budget() const {
    const bool told = asked_size_ || !asked_preset_.empty() || preferences_.picture != ivec2(0) ||
                      !preferences_.preset.empty();
    return preferences_.frame_budget.value_or(told ? 0 : shell::usual_frame_ms(software_));
}

ivec2 PictureChoice::size() const {
    const bool chosen = preferences_.picture != ivec2(0) && (chose_size_ || !asked_size_);
    return chosen ? preferences_.picture : usual_size_;
}

}  // namespace lanthorn::game
