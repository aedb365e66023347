// What the screens show, as plain values: drawing them needs neither window nor game.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "game/hud.h"
#include "game/screens.h"
#include "game/ui/style.h"

namespace lanthorn::game::ui {

struct LevelCard {
    std::string title;
    ImTextureID picture = nullptr;  // 16:9; null: there is none
    bool solved = false;
};

struct Model {
    Screens screens;
    std::vector<LevelCard> levels;
    Hud hud;
    ivec2 picture{0};  // pixels of the picture now
    double frame_ms = 0;
    std::vector<std::string> notices;  // lines that want to be read now
    bool less_motion = false;
    bool symbols = false;
    // From here on set by Interface.
    float unit = 1;
    Fonts fonts;
    bool appearing = false;   // the screen is shown for the first time
    bool pointing = false;    // the mouse was used last, not keys or gamepad
    float shown_seconds = 0;  // since the screen appeared
};

}  // namespace lanthorn::game::ui
