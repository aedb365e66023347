#include "game/picture_choice.h"

#include <utility>

namespace lanthorn::game {

PictureChoice::PictureChoice(const Options& options, Preferences preferences, bool software_gl)
    : preferences_(std::move(preferences)),
      asked_size_(options.size),
      asked_preset_(options.preset),
      usual_size_(picture_size(options, software_gl)),
      software_(software_gl) {
    budget_.set(preferences_.frame_budget, preset());
}

void PictureChoice::choose(const Preferences& chosen) {
    chose_size_ = chose_size_ || chosen.picture != preferences_.picture;
    const bool another_preset = chosen.preset != preset();
    const std::string kept_preset = preferences_.preset;
    preferences_ = chosen;
    if (another_preset) {
        chose_preset_ = true;
    } else {
        preferences_.preset = kept_preset;
    }
    budget_.set(preferences_.frame_budget, preset());
}

// Where OpenGL runs on the CPU only the lowest preset leaves time to play.
std::string PictureChoice::preset() const {
    if (!asked_preset_.empty() && !chose_preset_) {
        return asked_preset_;
    }
    return !preferences_.preset.empty() ? preferences_.preset : software_ ? "low" : "medium";
}

ivec2 PictureChoice::size() const {
    const bool chosen = preferences_.picture != ivec2(0) && (chose_size_ || !asked_size_);
    return chosen ? preferences_.picture : usual_size_;
}

ivec2 PictureChoice::drawn_size() const {
    const glm::dvec2 size = glm::round(budget_.spending().scale * glm::dvec2(this->size()));
    return glm::max(ivec2(size), 16);
}

}  // namespace lanthorn::game
