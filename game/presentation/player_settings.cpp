#include "game/presentation/player_settings.h"

#include <optional>
#include <string_view>

#include "game/rules/actions.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/quality_ladder.h"

namespace lanthorn::game {

namespace {

// What is spared of the preset's picture where it takes too long: its light, then its pixels.
BudgetLadder ladder_of(const std::string& preset, ivec2 size) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings settings(schema);
    settings.apply_preset(preset);
    BudgetLadder ladder = gi::quality_ladder(settings, size, true);
    for (BudgetRung& rung : ladder.rungs) {
        rung.preset = preset;
    }
    return ladder;
}

}  // namespace

PlayerSettings::PlayerSettings(const Options& options, shell::Window& window, const shell::Say& say)
    : window_(window),
      preferences_file_(shell::config_file(kProgram, "options.json"), "options", say),
      bindings_file_(shell::config_file(kProgram, "controls.json"), "keys and buttons", say),
      picture_(options, read_preferences(preferences_file_), window.info().software) {
    const auto kept_bindings = [](std::string_view json, std::string_view source) {
        return std::optional(read_bindings(json, source));
    };
    window_.devices().controls().set_bindings(
        bindings_file_.read_as(kept_bindings).value_or(usual_bindings()));
    apply();
    if (preferences().fullscreen && !options.size) {
        window_.set_full_screen(true);
    }
}

void PlayerSettings::choose(const Preferences& chosen) {
    const bool another_window = chosen.fullscreen != preferences().fullscreen;
    picture_.choose(chosen);
    apply();
    if (another_window) {
        window_.set_full_screen(chosen.fullscreen);
    }
    preferences_file_.write(to_json(preferences()));
}

void PlayerSettings::choose(const input::Bindings& chosen) {
    window_.devices().controls().set_bindings(chosen);
    bindings_file_.write(chosen.to_json());
}

void PlayerSettings::apply() {
    window_.set_picture_size(picture_.size());
    window_.budget().set(picture_.frame_budget(), ladder_of(picture_.preset(), window_.whole_size()));
    window_.devices().set_look(preferences().mouse, preferences().invert_look);
    window_.devices().controls().set_sticks(preferences().stick, preferences().dead_zone);
}

}  // namespace lanthorn::game
