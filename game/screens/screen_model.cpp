#include "game/screens/screen_model.h"

#include "lanthorn/input/key_names.h"

namespace lanthorn::game {

ui::Model screen_model(const GameParts& parts, ui::LevelPictures& pictures) {
    ui::Model model;
    model.screens = parts.screens;
    for (const LevelFile& file : parts.level.files()) {
        const ImTextureID picture =
            parts.screens.at == Screen::levels ? pictures.find(file.picture()) : nullptr;
        model.levels.push_back({file.title, picture, parts.progress.solved(file)});
    }
    model.picture = parts.picture.size();
    if (parts.level.played() != nullptr && is_played(parts.screens.at)) {
        model.hud = look_about(parts.level.played()->world(),
                               static_cast<float>(model.picture.x) / static_cast<float>(model.picture.y));
    }
    model.frame_ms = parts.window.frame_ms();
    model.drawn = parts.window.picture_size();
    model.drawn_preset = parts.window.spending().preset;
    model.notices = parts.notices.lines();
    model.hint = parts.hints.shown();
    const input::Controls& controls = parts.window.devices().controls();
    model.pressed = controls.pressed();
    model.pad = controls.pad();
    for (std::size_t row = 0; row < model.keys.size(); ++row) {
        model.keys[row] = input::key_name(controls.bindings(), row, parts.uses_pad);
    }
    model.symbols = parts.picture.preferences().symbols;
    return model;
}

}  // namespace lanthorn::game
