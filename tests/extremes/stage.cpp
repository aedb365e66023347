#include "tests/extremes/stage.h"

#include <algorithm>

#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::extremes {

namespace {

quat facing(const vec3& direction) {
    const vec3 d = glm::normalize(direction);
    return glm::quatLookAt(d, std::abs(d.y) > 0.99f ? vec3(0, 0, 1) : vec3(0, 1, 0));
}

NodeData child_of_root(const vec3& position, const quat& rotation) {
    NodeData node;
    node.parent = 0;
    node.local.translation = position;
    node.local.rotation = rotation;
    return node;
}

}  // namespace

float largest_albedo(const Stage& stage) {
    float largest = 0;
    for (const Material& m : stage.materials) {
        largest = std::max({largest, m.base_colour.x, m.base_colour.y, m.base_colour.z});
    }
    return largest;
}

FrameScene frame_of(const Stage& stage, const Placement& placement) {
    SceneData data;
    data.meshes = stage.meshes;
    data.materials = stage.materials;
    NodeData root;
    root.local.translation = placement.offset;
    root.local.scale = vec3(static_cast<float>(placement.scale));
    data.nodes.push_back(root);

    NodeData geometry = child_of_root(vec3(0), quat(1, 0, 0, 0));
    for (std::uint32_t i = 0; i < stage.meshes.size(); ++i) geometry.meshes.push_back(i);
    data.nodes.push_back(geometry);

    for (const LightInstance& light : stage.lights) {
        NodeData node = child_of_root(light.position, facing(light.direction));
        node.light = static_cast<std::uint32_t>(data.lights.size());
        data.nodes.push_back(node);
        data.lights.push_back(light.light);
        if (light.light.type != LightType::directional) {
            data.lights.back().intensity *= static_cast<float>(placement.scale * placement.scale);
        }
    }

    if (stage.sky.image) {
        NodeData node = child_of_root(vec3(0), quat(1, 0, 0, 0));
        node.sky = 0;
        data.nodes.push_back(node);
        data.skies.push_back(stage.sky);
    }

    NodeData camera = child_of_root(stage.eye, facing(stage.target - stage.eye));
    camera.camera = 0;
    data.nodes.push_back(camera);
    data.cameras.push_back(stage.camera);
    data.cameras.back().z_near *= static_cast<float>(placement.scale);

    ecs::World world;
    const std::vector<ecs::Entity> entities = spawn(world, std::move(data));
    Extractor extractor;
    if (placement.walk != dvec3(0)) {
        extractor.extract(world, entities.back());
        world.get_mut<LocalTransform>(entities.front()).value.translation += placement.walk;
        Transforms().update(world);
    }
    FrameScene frame = extractor.extract(world, entities.back());
    frame.changes.assets = true;  // whoever renders has not seen it before
    return frame;
}

}  // namespace lanthorn::extremes
