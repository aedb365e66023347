#include "lanthorn/runtime/deformation_plugin.h"

#include "lanthorn/deformation/deformation.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn {

void DeformationPlugin::build(App& app) {
    app.world().insert_resource(SurfaceDetail());
    app.world().insert_resource(Deformation());
    ecs::Schedule& frame = app.frame_schedule();
    frame.add("morphs", [](ecs::World& world) { world.resource_mut<Deformation>().morph(world); })
        .after("transforms");
    frame
        .add("skinning",
             [](ecs::World& world) {
                 world.resource_mut<Deformation>().skin(world, world.resource<SurfaceDetail>().wanted());
             })
        .after("morphs");
    frame.add("subdivision", [](ecs::World& world) { world.resource_mut<Deformation>().subdivide(); })
        .after("skinning");
    frame.add("bounds", [](ecs::World& world) { world.resource_mut<Deformation>().publish(world); })
        .after("subdivision")
        .before("extract");
}

}  // namespace lanthorn
