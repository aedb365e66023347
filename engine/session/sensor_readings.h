// The light sensors of a world, numbered as a recording numbers them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/replay/recording.h"
#include "lanthorn/replay/sensor_check.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn::session {

class SensorReadings {
  public:
    // Those that the world has now, in the order of their entities.
    explicit SensorReadings(const ecs::World& world);

    const std::vector<std::string>& names() const { return names_; }

    // `inbox` enters the simulation with step `step`.
    std::vector<replay::SensorReading> recorded(const SensorInbox& inbox, std::uint64_t step) const;
    SensorInbox replayed(std::span<const replay::SensorReading> readings, std::uint64_t step) const;
    void compare(const SensorInbox& fresh, replay::SensorCheck& check) const;

  private:
    std::uint32_t number_of(const SensorSample& sample) const;

    std::vector<std::uint32_t> ids_;  // entities' indices
    std::vector<std::string> names_;
};

}  // namespace lanthorn::session
