// What the screens show, taken from the parts of the game in its window.
#pragma once

#include "game/level/hints.h"
#include "game/level/level_in_window.h"
#include "game/level/reveal.h"
#include "game/presentation/languages.h"
#include "game/presentation/picture_choice.h"
#include "game/presentation/progress_file.h"
#include "game/presentation/sound/game_sound.h"
#include "game/screens/level_pictures.h"
#include "game/screens/model.h"
#include "game/screens/notices.h"
#include "game/screens/screens.h"
#include "lanthorn/shell/window.h"

namespace lanthorn::game {

struct GameParts {
    const Screens& screens;
    const LevelInWindow& level;
    const ProgressFile& progress;
    const PictureChoice& picture;
    const Notices& notices;
    const Hints& hints;
    const Lessons& lessons;
    const Reveal& reveal;
    const Languages& languages;
    const Words& words;
    const GameSound& sound;
    shell::Window& window;
    bool uses_pad;      // last
    bool plays_itself;  // nobody is to be taught
};

// `pictures` of the levels, read as they are first shown: the OpenGL context must be current.
ui::Model screen_model(const GameParts& parts, ui::LevelPictures& pictures);

}  // namespace lanthorn::game
