#include "game/stage.h"

#include "lanthorn/core/error.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::game {

namespace {

const vec3 kUp(0, 1, 0);

dmat4 camera_to_world(const View& view) {
    const quat turn = glm::angleAxis(static_cast<float>(view.yaw), kUp) *
                      glm::angleAxis(static_cast<float>(view.pitch), vec3(1, 0, 0));
    dmat4 m(glm::mat3_cast(glm::dquat(turn)));
    m[3] = dvec4(view.eye, 1);
    return m;
}

}  // namespace

Stage::Stage(const SceneData& scene, const Level& level) {
    const std::vector<ecs::Entity> entities = spawn(world_, scene);
    if (level.door) {
        door_ = entities[level.door->node];
        door_at_rest_ = world_.get<LocalTransform>(door_).value;
    }
    if (level.lantern) {
        lantern_ = entities[level.lantern->node];
        const std::uint32_t light = level.lantern->light_node;
        if (light != kNone && world_.has<LightComponent>(entities[light])) {
            lantern_light_ = entities[light];
            light_ = world_.get<LightComponent>(lantern_light_).light;
        }
    }
    player_camera_.y_fov = glm::radians(62.0f);
}

void Stage::place(ecs::Entity entity, const Transform& transform) {
    if (!(world_.get<LocalTransform>(entity).value == transform)) {
        world_.get_mut<LocalTransform>(entity).value = transform;
    }
}

void Stage::follow(const View& view) {
    if (door_) {
        Transform at = door_at_rest_;
        at.rotation = glm::angleAxis(static_cast<float>(view.door_angle), kUp) * at.rotation;
        place(door_, at);
    }
    if (lantern_) {
        Transform at = world_.get<LocalTransform>(lantern_).value;
        at.translation = view.lantern_position;
        at.rotation = view.lantern_rotation;
        place(lantern_, at);
    }
    if (lantern_light_ && world_.has<LightComponent>(lantern_light_) != view.lantern_lit) {
        if (view.lantern_lit) {
            world_.add(lantern_light_, LightComponent{light_});
        } else {
            world_.remove<LightComponent>(lantern_light_);
        }
    }
    transforms_.update(world_);
}

FrameScene Stage::show(const View& view) {
    follow(view);
    return extractor_.extract(world_, player_camera_, camera_to_world(view));
}

FrameScene Stage::show(const View& view, const std::string& camera) {
    follow(view);
    const ecs::Entity entity = find_by_name(world_, camera);
    if (!entity || !world_.has<CameraComponent>(entity)) {
        throw InputError("camera: found none named '" + camera + "' in the level");
    }
    return extractor_.extract(world_, entity);
}

}  // namespace lanthorn::game
