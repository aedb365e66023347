// Lights, cameras, and meshes put together to a FrameScene.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::support {

inline LightInstance point_light(const vec3& position, float candela) {
    LightInstance light;
    light.light.type = LightType::point;
    light.light.intensity = candela;
    light.position = position;
    return light;
}

// Cones in radians from the axis.
inline LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float inner,
                                float outer) {
    LightInstance light = point_light(position, candela);
    light.light.type = LightType::spot;
    light.light.inner_cone = inner;
    light.light.outer_cone = outer;
    light.direction = glm::normalize(direction);
    return light;
}

inline LightInstance directional_light(const vec3& direction, float lux) {
    LightInstance light = point_light(vec3(0), lux);
    light.light.type = LightType::directional;
    light.direction = glm::normalize(direction);
    return light;
}

// The near plane stands at a thousandth of the way to the target.
inline void look(FrameScene& scene, const vec3& eye, const vec3& target) {
    const vec3 up = std::abs(glm::normalize(target - eye).y) > 0.99f ? vec3(0, 0, 1) : vec3(0, 1, 0);
    scene.camera.camera.z_near = 1e-3f * glm::distance(eye, target);
    scene.camera.position = eye;
    scene.camera.view = glm::lookAt(eye, target, up);
}

// An orthographic camera that looks at `target` from `eye` and sees `half_width` to each side.
inline void look_closely(FrameScene& scene, const vec3& eye, const vec3& target, float half_width) {
    look(scene, eye, target);
    scene.camera.camera.orthographic = true;
    scene.camera.camera.x_mag = half_width;
    scene.camera.camera.y_mag = half_width;
    scene.camera.camera.z_far = 1e3f;
}

// All meshes placed untransformed, everything marked changed; seen from `eye`, 60 degrees high.
inline FrameScene scene_of(std::shared_ptr<const SceneAssets> assets, std::vector<LightInstance> lights,
                           const vec3& eye, const vec3& target) {
    FrameScene scene;
    for (std::uint32_t i = 0; i < assets->meshes.size(); ++i) {
        Instance instance;
        instance.id = i;
        instance.mesh = i;
        instance.bounds = assets->meshes[i].bounds;
        scene.bounds.add(instance.bounds);
        scene.instances.push_back(instance);
        scene.changes.moved.push_back(i);
    }
    scene.changes.dirty = scene.bounds;
    scene.assets = assets;
    scene.lights = std::move(lights);
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        scene.lights[i].id = 1000 + i;
    }
    look(scene, eye, target);
    return scene;
}

inline FrameScene scene_of(std::vector<Mesh> meshes, std::vector<Material> materials,
                           std::vector<LightInstance> lights, const vec3& eye, const vec3& target) {
    auto assets = std::make_shared<SceneAssets>();
    assets->meshes = std::move(meshes);
    assets->materials = std::move(materials);
    return scene_of(std::move(assets), std::move(lights), eye, target);
}

}  // namespace lanthorn::support
