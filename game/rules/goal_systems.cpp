// What is to be achieved.
#include "game/rules/systems.h"

namespace lanthorn::game {

void reach_goals(Query<Read<LightSensor>, Mut<Goal>> goals) {
    goals.each([](const LightSensor& sensor, ecs::MutRef<Goal> goal) {
        if (!goal->reached && sensor.readings > 0 && static_cast<double>(sensor.lux) >= goal->lux) {
            goal.write().reached = true;
        }
    });
}

}  // namespace lanthorn::game
