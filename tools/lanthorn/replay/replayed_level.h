// A recorded session of the game that is played again: the level's App and the session that drives it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/session/session.h"
#include "tools/lanthorn/replay/level_file.h"

namespace lanthorn::tools {

// How it is played.
struct ReplayChoice {
    int threads = 1;                        // of the simulation; 0: as many as there are
    std::string record = {};                // file to record the replay to; empty: none
    std::function<void(App&)> extend = {};  // called before the session begins: systems of a test
};

class ReplayedLevel {
  public:
    // Throws InputError where the recording is of another level, input or set of sensors. `file`: its name in
    // messages.
    ReplayedLevel(const LevelFile& level, const std::string& file,
                  std::shared_ptr<const replay::Recording> recording, const ReplayChoice& choice = {});
    ReplayedLevel(const ReplayedLevel&) = delete;
    ReplayedLevel& operator=(const ReplayedLevel&) = delete;

    App& app() { return shown_.app(); }
    const App& app() const { return shown_.app(); }
    const ecs::World& world() const { return shown_.world(); }
    session::Session& session() { return session_; }
    const session::Session& session() const { return session_; }
    const replay::Comparison& comparison() const { return *session_.comparison(); }

  private:
    ShownScene shown_;
    session::Session session_;
};

}  // namespace lanthorn::tools
