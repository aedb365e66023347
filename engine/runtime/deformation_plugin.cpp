#include "lanthorn/runtime/deformation_plugin.h"

#include "lanthorn/deformation/deformation.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/asset_store.h"

namespace lanthorn {

using ecs::Res;
using ecs::ResMut;

void DeformationPlugin::build(App& app) {
    app.world().insert_resource(SurfaceDetail());
    app.world().insert_resource(Deformation());
    const ecs::World& world = app.world();
    ecs::Schedule& frame = app.frame_schedule();
    frame.add("morphs", [&world](ResMut<Deformation> deformation) { deformation->morph(world); })
        .after("transforms.begin")
        .reads<MeshInstances>()
        .reads<SkinInstance>()
        .reads<MorphWeights>()
        .reads_resource<AssetStore>();
    frame
        .add("skinning", [&world](ResMut<Deformation> deformation,
                                  Res<SurfaceDetail> detail) { deformation->skin(world, detail->wanted()); })
        .after("morphs")
        .reads<SkinInstance>()
        .reads<WorldTransform>();
    frame.add("subdivision", [](ResMut<Deformation> deformation) { deformation->subdivide(); })
        .after("skinning");
    frame
        .add("bounds", [&world](ResMut<Deformation> deformation, Deformation::Writes writes,
                                ecs::Commands& commands) { deformation->publish(world, writes, commands); })
        .after("subdivision")
        .before("extract.begin")
        .reads<Name>();
}

}  // namespace lanthorn
