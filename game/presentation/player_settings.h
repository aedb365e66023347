// What the player has chosen, kept from one run to the next and applied to window and devices: options, keys.
#pragma once

#include "game/presentation/options.h"
#include "game/presentation/picture_choice.h"
#include "lanthorn/input/bindings.h"
#include "lanthorn/shell/kept_file.h"
#include "lanthorn/shell/window.h"

namespace lanthorn::game {

class PlayerSettings {
  public:
    // Reads both files and applies them; `options` hold until the player chooses otherwise. What is wrong
    // with a file is said. The window must outlive this.
    PlayerSettings(const Options& options, shell::Window& window, const shell::Say& say);

    // Applies and keeps them.
    void choose(const Preferences& chosen);
    void choose(const input::Bindings& chosen);

    const PictureChoice& picture() const { return picture_; }
    const Preferences& preferences() const { return picture_.preferences(); }
    const input::Bindings& bindings() const { return window_.devices().controls().bindings(); }

  private:
    void apply();

    shell::Window& window_;
    shell::KeptFile preferences_file_;
    shell::KeptFile bindings_file_;
    PictureChoice picture_;
};

}  // namespace lanthorn::game
