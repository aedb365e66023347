// A session: an App in play, what drives it, and what is kept of it. Record it, replay it, go back in it.
//
//   App app;
//   add_scene_plugins(app);
//   ...                                             // the program's own plugins, the level
//   session::Session session(app, session::InputStream::of<Keys>("walker-1", read_keys),
//                            {.content = "room.glb", .record = "room.rec"});
//   while (!stop.asked()) {
//       app.step();                                 // or frame(), or show_at()
//   }
//   session.finish();
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/stop_signal.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/replay/player.h"
#include "lanthorn/replay/recording.h"
#include "lanthorn/replay/sensor_check.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/session/input_stream.h"

namespace lanthorn::session {

// How a session begins, and what it is of.
struct Config {
    std::uint64_t seed = 1;  // a replay has its recording's

    // What is played, which a recording must be of to be replayed: the name of the level's file without
    // folders, and a hash of its bytes (replay::hash_file).
    std::string content;
    std::uint64_t content_hash = 0;
    std::string build;  // of the program, for people

    std::string replay;  // file whose inputs and sensor readings drive the session; empty: the source does
    std::string record;  // file to record to while it runs; empty: none
    // Instead of the file's contents, what is in memory; `replay` is then its name in messages.
    std::shared_ptr<const replay::Recording> recording = {};
    replay::Annotations annotations = {};  // that a new recording begins with

    // Takes what a user must know at once, a line each: a recording that is cut off, one that cannot be
    // written on. Without it they go to standard error.
    std::function<void(const std::string& line)> warn;
};

// A session's state after some step, to go back to.
class Moment {
  public:
    std::uint64_t step() const { return step_; }  // steps before it

    // Of a state that is at hand: of another run, or read from a file.
    Moment(std::uint64_t step, ecs::Snapshot world) : step_(step), world_(std::move(world)) {}

  private:
    friend class Session;
    std::uint64_t step_;
    ecs::Snapshot world_;
};

// Adds two systems to the fixed steps: session.begin, before gameplay's, says what comes in; session.end, the
// last, takes down or checks what came of it. So a session is whole however the App is run. Recording and
// replaying cost a hash of the whole state a step.
class Session {
  public:
    // For an App that has ScenePlugin, all its components, systems and sensors, and no step yet; the App must
    // outlive the session, and takes no step after its end. A replay holds fresh sensor readings against
    // the recorded ones, which drive it. Throws InputError if the recording cannot be read, is none of this
    // content, format, parts and sensors, or if the session cannot be recorded; Error for an App without
    // ScenePlugin or with steps.
    Session(App& app, InputStream inputs, Config config);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    App& app() { return app_; }              // that is in play
    const App& app() const { return app_; }  // the same to read

    std::uint64_t seed() const;  // of random numbers: the recording's in a replay
    // By the App's clock, which a rewind() takes back.
    std::uint64_t steps() const { return app_.time().steps; }
    // Steps until the source or the recording ends; none: no end is known. Steps beyond take an empty input
    // and are neither recorded nor checked.
    std::optional<std::uint64_t> length() const;
    bool done() const { return length() && steps() >= *length(); }  // the known end is reached

    // Where a replay first differed, in one line with step and part ("step 12: door: not as recorded ..."),
    // or step and sensor; empty if it did not.
    std::string divergence() const;
    // What a replay has compared so far, all differences too; null where nothing is replayed.
    const replay::Comparison* comparison() const;
    bool apart() const;                               // the last step of a replay was not as recorded
    const replay::SensorCheck* sensor_check() const;  // the same of fresh readings

    // Ends the recording if there is one; it is written while the session runs, and stays without this.
    void finish();
    // Whether the recording broke off, which `warn` was told when it happened.
    bool recording_failed() const;
    // Where `stop` ended the session before its time: one line that says how far it came ("SIGINT: stopped
    // after 12 of 840 steps, which are in a.rec"); else empty.
    std::string stopped(const StopSignal& stop) const;

    // Puts the present aside: O(bytes of components). Throws Error for a component that is not declared.
    Moment keep() const;
    // Back to an earlier moment of this session: world, clock and place in the inputs. Steps from there on
    // take what comes in anew, a replay the recorded inputs again, and are checked but not recorded, until
    // come_back(). What is not declared state starts afresh, the contacts of bodies for one: a world with
    // those may go on a little differently. Throws Error for a moment that is yet to come.
    void rewind(const Moment& moment);
    // To where the first rewind() left; the recording goes on there. Nothing without a rewind.
    void come_back();
    bool in_the_past() const;  // since a rewind() until come_back()
    // To any moment of a session of this content and these inputs, one that is yet to come too, for good.
    // From a key step (runtime/time.h) all goes on to the bit as it did there. Throws Error while a recording
    // is made.
    void jump(const Moment& moment);

  private:
    struct State;

    void begin(ecs::World& world);
    void end();
    void go_to(const Moment& moment);
    void warn_of_failure();

    App& app_;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::session
