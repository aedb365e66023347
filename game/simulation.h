// The game without any picture: a pure function of level, seed and recorded inputs, on any number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "game/components.h"
#include "game/level.h"
#include "game/player_input.h"
#include "lanthorn/ecs/schedule.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/replay/recording.h"
#include "lanthorn/replay/state_hash.h"

namespace lanthorn::game {

// What of the state can be seen.
struct View {
    dvec3 eye{0};
    double yaw = 0, pitch = 0;
    double door_angle = 0;
    dvec3 lantern_position{0};
    quat lantern_rotation{1, 0, 0, 0};
    bool lantern_lit = true;
    bool lantern_carried = false;
    bool far_room_lit = false;
    float far_room_lux = 0;
};

// Between two steps: `share` of the way from `before` to `after`, 0..1.
View between(const View& before, const View& after, double share);

class Simulation {
  public:
    // `threads`: 0 for as many as there are. Same results whatever it is.
    Simulation(const Level& level, std::uint64_t seed, int threads);

    // One step of kStep seconds. `readings` are the light sensors' values that enter with it.
    void step(const PlayerInput& input, std::span<const replay::SensorReading> readings = {});

    View view() const;
    std::uint64_t steps() const { return world_.resource<Clock>().step; }

    // Hashes of the state by part, and the parts' names.
    std::vector<std::uint64_t> hashes() { return hasher_.hash(world_); }
    const std::vector<std::string>& parts() const { return hasher_.names(); }

    // The schedule in Graphviz's language.
    std::string schedule_dot() { return schedule_.to_dot(); }

    ecs::World& world() { return world_; }

  private:
    void add_parts();
    void add_systems(int threads);

    ecs::World world_;
    ecs::Schedule schedule_;
    replay::WorldHasher hasher_;
    ecs::Entity player_, door_, lantern_, far_room_;
};

// What a recording of a session says of its origin.
replay::RecordingHeader recording_header(const Simulation& simulation, const std::string& level_path,
                                         std::uint64_t seed);

}  // namespace lanthorn::game
