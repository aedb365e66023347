// A level that is shown, and the session that it is played in: what the command line asks for.
#pragma once

#include <functional>
#include <utility>

#include "game/presentation/options.h"
#include "game/rules/player_input.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/session/session.h"

namespace lanthorn::game {

class Playthrough {
  public:
    // Rules and level in an App without pictures. The player's input comes from the recording that options
    // name, else from the level's tour where options ask for one or there is no window, else from the
    // devices. Lines for the user go to stderr. Throws InputError as load_level() and Session do.
    Playthrough(const Options& options, const SceneData& scene);
    Playthrough(const Playthrough&) = delete;
    Playthrough& operator=(const Playthrough&) = delete;

    // Asked in every step that the devices drive; without it the player does nothing.
    void set_devices(std::function<PlayerInput()> devices) { devices_ = std::move(devices); }

    // The level: its App and state.
    ShownScene& shown() { return shown_; }
    const ShownScene& shown() const { return shown_; }
    App& app() { return shown_.app(); }
    const ecs::World& world() const { return shown_.world(); }
    session::Session& session() { return session_; }
    const session::Session& session() const { return session_; }

    // Where `stop` ended the session before its time, says on stderr how far it came.
    void say_stopped(const StopSignal& stop) const;

  private:
    session::InputStream inputs(const Options& options);

    ShownScene shown_;
    std::function<PlayerInput()> devices_;
    session::Session session_;
};

}  // namespace lanthorn::game
