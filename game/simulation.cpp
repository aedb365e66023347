#include "game/simulation.h"

#include <filesystem>

#include "game/systems.h"

namespace lanthorn::game {

View between(const View& before, const View& after, double share) {
    View view = after;
    constexpr double kTurn = 2 * 3.14159265358979323846;
    view.eye = glm::mix(before.eye, after.eye, share);
    view.yaw = before.yaw + share * std::remainder(after.yaw - before.yaw, kTurn);
    view.pitch = glm::mix(before.pitch, after.pitch, share);
    view.door_angle = glm::mix(before.door_angle, after.door_angle, share);
    view.lantern_position = glm::mix(before.lantern_position, after.lantern_position, share);
    view.lantern_rotation =
        glm::slerp(before.lantern_rotation, after.lantern_rotation, static_cast<float>(share));
    return view;
}

Simulation::Simulation(const Level& level, std::uint64_t seed, int threads) : schedule_("simulation") {
    world_.insert_resource(Clock{0, seed});
    world_.insert_resource(PlayerInput{});
    world_.insert_resource(StepIntent{});
    world_.insert_resource(SensorInput{});

    player_ = world_.create(Player{.position = level.start, .yaw = level.start_yaw});
    if (level.door) {
        door_ = world_.create(Door{}, DoorFrame{level.door->hinge, level.door->open_angle, level.door->leaf,
                                                level.door->middle});
    }
    if (level.lantern) {
        lantern_ = world_.create(Lantern{.position = level.lantern->position, .yaw = level.lantern->yaw},
                                 LanternShape{level.lantern->handle});
    }
    if (level.far_sensor) {
        far_room_ = world_.create(FarRoom{});
    }
    for (const Box& box : level.walls) {
        world_.create(Wall{box});
    }
    add_parts();
    add_systems(threads);
}

void Simulation::add_parts() {
    using replay::StateHash;
    hasher_.part("clock", [](StateHash& h, const ecs::World& world) {
        const Clock& clock = world.resource<Clock>();
        h.add_all(clock.step, clock.seed, std::uint64_t{world.size()});
    });
    hasher_.component<Player>("player", [](StateHash& h, const Player& p) {
        h.add_all(p.position, p.velocity, p.yaw, p.pitch, p.held);
    });
    hasher_.component<Door>("door", [](StateHash& h, const Door& d) { h.add_all(d.angle, d.speed, d.open); });
    hasher_.component<Lantern>("lantern", [](StateHash& h, const Lantern& l) {
        h.add_all(l.position, l.yaw, l.sway.x, l.sway.y, l.sway_speed.x, l.sway_speed.y, l.hand,
                  l.hand_velocity, l.carried, l.lit);
    });
    hasher_.component<FarRoom>("far_room", [](StateHash& h, const FarRoom& r) { h.add_all(r.lux, r.lit); });
}

void Simulation::add_systems(int threads) {
    schedule_.set_threads(threads);
    schedule_.add("count_step", count_step);
    schedule_.add("intend", intend).before("walk");
    schedule_.add("swing_door", swing_door).after("intend").before("walk");
    schedule_.add("walk", walk);
    schedule_.add("carry_lantern", carry_lantern);
    schedule_.add("sense", sense);
    schedule_.build();
}

void Simulation::step(const PlayerInput& input, std::span<const replay::SensorReading> readings) {
    world_.resource_mut<PlayerInput>() = input;
    world_.resource_mut<SensorInput>().readings.assign(readings.begin(), readings.end());
    schedule_.run(world_);
}

View Simulation::view() const {
    View view;
    const Player& player = world_.get<Player>(player_);
    view.eye = player.eye();
    view.yaw = player.yaw;
    view.pitch = player.pitch;
    if (door_) {
        view.door_angle = world_.get<Door>(door_).angle;
    }
    if (lantern_) {
        const Lantern& lantern = world_.get<Lantern>(lantern_);
        view.lantern_position = lantern.position;
        view.lantern_rotation = lantern.rotation();
        view.lantern_lit = lantern.lit;
        view.lantern_carried = lantern.carried;
    }
    if (far_room_) {
        view.far_room_lit = world_.get<FarRoom>(far_room_).lit;
        view.far_room_lux = world_.get<FarRoom>(far_room_).lux;
    }
    return view;
}

replay::RecordingHeader recording_header(const Simulation& simulation, const std::string& level_path,
                                         std::uint64_t seed) {
    replay::RecordingHeader header;
    header.level = std::filesystem::path(level_path).filename().string();
    header.level_hash = replay::hash_file(level_path);
    header.seed = seed;
    header.step_rate = 60;
    header.build = LANTHORN_BUILD;
    header.input_format = kInputFormat;
    header.input_size = sizeof(PlayerInput);
    header.parts = simulation.parts();
    header.sensors = {"far_sensor"};
    return header;
}

}  // namespace lanthorn::game
