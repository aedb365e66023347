#include "engine/runtime/transform_system.h"

#include <utility>

#include "lanthorn/scene/transforms.h"

namespace lanthorn {

ecs::Schedule::Config add_transforms(App& app, ecs::Schedule& schedule, std::string name) {
    const ecs::World& world = app.world();
    return schedule
        .add(std::move(name),
             [&world](ecs::ResMut<Transforms> transforms, Transforms::Writes writes, ecs::SystemTicks ticks) {
                 transforms->update(world, writes, ticks.now);
             })
        .reads<LocalTransform>()
        .reads<Shear>()
        .reads<Parent>()
        .reads<Children>();
}

}  // namespace lanthorn
