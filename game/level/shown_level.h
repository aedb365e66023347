// A level with its picture: what runs behind every screen of the game in a window.
#pragma once

#include <string>
#include <vector>

#include "game/presentation/options.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"

namespace lanthorn::game {

class ShownLevel {
  public:
    // Of the file `options.level`, imported already. The OpenGL context must be current for as long as this
    // lives. Throws InputError as Playthrough and Quality do.
    ShownLevel(const Options& options, const SceneData& scene, const shell::Spending& spending);

    Playthrough& playthrough() { return playthrough_; }
    const session::Session& session() const { return playthrough_.session(); }
    App& app() { return playthrough_.app(); }
    const ecs::World& world() const { return playthrough_.app().world(); }

    void spend(const shell::Spending& spending);

    // The world as it is, and back to it, also by a build with other components (ecs::Snapshot::from_bytes).
    // restore() throws InputError for what is no state; it returns what this build has no place for, for one
    // line.
    std::string state() const;
    std::vector<std::string> restore(std::string_view state, std::string_view source);

    // Instead of the player's eyes the level's node "camera", or without one the eyes, looking about a
    // little; `seconds` since it began. Call before a frame.
    void look_about(double seconds);
    void look_with_eyes() { app().view().placed.reset(); }

  private:
    Playthrough playthrough_;
    Quality quality_;
};

}  // namespace lanthorn::game
