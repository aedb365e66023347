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
#include "game/screens/lessons.h"
#include "game/screens/screens.h"
#include "game/screens/style.h"
#include "game/screens/words.h"
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

// A crystal that has just woken and is looked at.
struct RevealMark {
    std::optional<vec2> place;  // in the picture, 0..1 from the left and from the top
    float seconds = 0;          // since it began to be shown
    int awake = 0, all = 0;
};

struct Model {
    Screens screens;
    std::vector<LevelCard> levels;
    Hud hud;
    std::vector<Prompt> prompts;
    std::optional<RevealMark> reveal;
    ivec2 picture{0};  // pixels of the picture, as chosen
    ivec2 drawn{0};    // as the frame budget allows
    std::string drawn_preset;
    double frame_ms = 0;
    std::vector<std::string> notices;        // lines that want to be read now
    std::vector<std::string> captions;       // of what is heard, in English
    std::string hint;                        // that the player asked for, in English
    std::string story;                       // of a level that has just begun, in English
    std::string looks_by = "mouse";          // what looks about, in English
    bool by_pad = false;                     // keys are those of a gamepad
    std::array<std::string, kActions> keys;  // what to press for an action, on the device used last
    std::vector<Trigger> pressed;            // since the last frame
    std::optional<PadState> pad;             // as it is now
    bool symbols = false;
    std::vector<std::string> languages;  // codes of those that there are
    std::string language;                // the code of the one that is spoken
    const Words* words = nullptr;        // of it; null: English as the code has it
    lanthorn::ui::Page page;             // set by Interface

    const std::string& key(Action action) const { return keys[static_cast<std::size_t>(action)]; }
    // In the player's language.
    std::string say(std::string_view english) const {
        return words != nullptr ? words->say(english) : std::string(english);
    }
    // The same, with the name of an action's key in the place of "{light}" and its like.
    std::string say_with_keys(std::string_view english) const;
};

}  // namespace lanthorn::game::ui
