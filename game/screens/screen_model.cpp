#include "game/screens/screen_model.h"

#include "game/level/story.h"
#include "lanthorn/input/bindings.h"

namespace lanthorn::game {

ui::Model screen_model(const GameParts& parts, ui::LevelPictures& pictures) {
    ui::Model model;
    model.screens = parts.screens;
    for (const LevelFile& file : parts.level.files()) {
        const ImTextureID picture =
            parts.screens.at == Screen::levels ? pictures.find(file.picture()) : nullptr;
        model.levels.push_back({parts.words.say(file.title), picture, parts.progress.solved(file)});
    }
    model.picture = parts.picture.size();
    if (parts.level.played() != nullptr && is_played(parts.screens.at)) {
        const ivec2 window = glm::max(parts.window.framebuffer_size(), 1);
        const float aspect = static_cast<float>(window.x) / static_cast<float>(window.y);
        model.hud = look_about(parts.level.played()->world(), aspect);
        if (!parts.plays_itself) {
            model.prompts = parts.lessons.prompts(model.hud);
            if (parts.level.played()->session().steps() < kStorySteps) {
                model.story = story_of(parts.level.file(parts.screens.level).path.stem().string());
            }
        }
    }
    if (parts.reveal.showing() && is_played(parts.screens.at)) {
        model.reveal = {.place = vec2(0.5f),  // the picture looks at it
                        .seconds = static_cast<float>(parts.reveal.seconds()),
                        .awake = parts.reveal.awake(),
                        .all = parts.reveal.all()};
        if (parts.reveal.seconds() < Reveal::kEase) {
            model.reveal->place.reset();
        }
    }
    model.by_pad = parts.uses_pad;
    model.looks_by = parts.uses_pad ? "right stick" : "mouse";
    model.words = &parts.words;
    model.languages = parts.languages.codes();
    model.language = parts.languages.code();
    if (parts.picture.preferences().captions) {
        model.captions = parts.sound.captions().lines();
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
