// What the screens show, as plain values: drawing them needs neither window nor game.
#pragma once

#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "game/presentation/preferences.h"
#include "game/rules/actions.h"
#include "game/screens/hud.h"
#include "game/screens/screens.h"
#include "game/screens/style.h"
#include "lanthorn/ui/widgets.h"

namespace lanthorn::game::ui {

using input::Bindings;
using input::PadState;
using input::Trigger;

struct LevelCard {
    std::string title;
    ImTextureID picture = nullptr;  // 16:9; null: there is none
    bool solved = false;
};

// What the player changes on the screens.
struct Choices {
    Preferences preferences;
    Bindings bindings = usual_bindings();
    std::optional<Action> asked;  // the next key or button is to mean this

    bool operator==(const Choices&) const = default;
};

struct Model {
    Screens screens;
    std::vector<LevelCard> levels;
    Hud hud;
    ivec2 picture{0};  // pixels of the picture, as chosen
    ivec2 drawn{0};    // as the frame budget allows
    std::string drawn_preset;
    double frame_ms = 0;
    std::vector<std::string> notices;        // lines that want to be read now
    std::string hint;                        // that the player asked for
    std::array<std::string, kActions> keys;  // what to press for an action, on the device used last
    std::vector<Trigger> pressed;            // since the last frame
    std::optional<PadState> pad;             // as it is now
    bool symbols = false;
    lanthorn::ui::Page page;  // set by Interface

    const std::string& key(Action action) const { return keys[static_cast<std::size_t>(action)]; }
};

}  // namespace lanthorn::game::ui
