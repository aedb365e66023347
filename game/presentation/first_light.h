// The light behind the title at a first start. On a CPU OpenGL compiles the programs of a level's light for
// longer than anybody waits. Until another process has done that, the title's level is lit by techniques with
// few programs, and stands still.
#pragma once

#include <string>

#include "game/level/level_files.h"
#include "game/presentation/options.h"
#include "game/presentation/preparation.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::game {

class FirstLight {
  public:
    FirstLight(const Options& options, gpu::GlInfo gl);

    // Whether the level is to be drawn so now: behind the title, until the programs of its light are there.
    // Once this was false it stays so, and nothing is prepared any more.
    bool holds(const LevelFile& level, const std::string& preset, bool behind_title);
    // A picture has been shown; the first one is not slowed down by what is prepared.
    void pass();

    // While it holds: direct light alone in the first picture, then the technique with the fewest programs.
    const char* setting() const {
        return state_ == State::prepares ? "gi.technique=coarse-path" : "gi.technique=none";
    }

  private:
    enum class State { unknown, awaits_picture, prepares, over };

    const Options& options_;
    gpu::GlInfo gl_;
    State state_;
    std::string level_, preset_;  // that are prepared
    Preparation preparation_;
};

}  // namespace lanthorn::game
