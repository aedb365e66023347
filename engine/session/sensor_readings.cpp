#include "engine/session/sensor_readings.h"

#include <algorithm>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::session {

SensorReadings::SensorReadings(const ecs::World& world) {
    std::vector<ecs::Entity> sensors = world.query<ecs::With<LightSensor>>().entities();
    std::ranges::sort(sensors);
    for (const ecs::Entity sensor : sensors) {
        const Name* name = world.try_get<Name>(sensor);
        ids_.push_back(sensor.index);
        names_.push_back(name != nullptr ? name->value : ecs::to_string(sensor));
    }
}

std::vector<replay::SensorReading> SensorReadings::recorded(const SensorInbox& inbox,
                                                            std::uint64_t step) const {
    std::vector<replay::SensorReading> readings;
    for (const SensorSample& sample : inbox.samples) {
        const std::uint32_t number = number_of(sample);
        if (number < ids_.size()) {
            readings.push_back({number, static_cast<std::uint32_t>(step - sample.step), sample.lux});
        }
    }
    return readings;
}

SensorInbox SensorReadings::replayed(std::span<const replay::SensorReading> readings,
                                     std::uint64_t step) const {
    SensorInbox inbox;
    for (const replay::SensorReading& reading : readings) {
        inbox.samples.push_back({ids_[reading.sensor], step - reading.age, reading.value});
    }
    return inbox;
}

void SensorReadings::compare(const SensorInbox& fresh, replay::SensorCheck& check) const {
    for (const SensorSample& sample : fresh.samples) {
        check.check(number_of(sample), sample.step, static_cast<double>(sample.lux));
    }
}

std::uint32_t SensorReadings::number_of(const SensorSample& sample) const {
    return static_cast<std::uint32_t>(std::ranges::find(ids_, sample.id) - ids_.begin());
}

}  // namespace lanthorn::session
