// Which moment of which clip is shown: how the scene is looked at, and nothing of it is in the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lanthorn/animation/playback.h"
#include "tools/editor/core/scene_clips.h"

namespace lanthorn::edit_window {

struct TimelineShown {
    std::vector<editor::ClipRow> clips;  // of the file
    std::string starts_with;             // the key of the one that it begins with; "none"
    std::optional<std::string> clip;     // that is shown, by its key; null: the one that the file begins with
    double time = 0;                     // seconds that playing has come to, as AnimationLayer::time
    double speed = 1;                    // seconds of the clip a second; negative: backwards
    LoopMode loop = LoopMode::loop;
    bool playing = false;
    bool moved = false;       // the world is to be shown at that moment
    double played_until = 0;  // GLFW's time

    // Null: there is none, or none is shown.
    const editor::ClipRow* shown() const;
    double second() const;  // of the clip, 0 to its length
    // Plays on until `now`; at the end of a clip that plays once it stops.
    void play_on(double now);
    void play(bool on, double now);  // from the start where it has come to its end
    void go_to(double second);
};

}  // namespace lanthorn::edit_window
