#include "lanthorn/runtime/sensor_plugin.h"

#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn {

namespace {

using ecs::Mut;
using ecs::Query;
using ecs::ResMut;

void read_sensors(ResMut<SensorInbox> inbox, Query<Mut<LightSensor>> sensors) {
    if (inbox.read().samples.empty()) {
        return;
    }
    sensors.each([&](ecs::Entity e, ecs::MutRef<LightSensor> sensor) {
        for (const SensorSample& sample : inbox.read().samples) {
            if (sample.id == e.index) {
                sensor.write().lux = sample.lux;
                ++sensor.write().readings;
            }
        }
    });
    inbox->samples.clear();
}

}  // namespace

void SensorPlugin::build(App& app) {
    app.world().insert_resource(SensorInbox());
    app.fixed_schedule().add("sensors.read", read_sensors).in("gameplay");
}

}  // namespace lanthorn
