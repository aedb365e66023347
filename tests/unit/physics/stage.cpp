#include "tests/unit/physics/stage.h"

#include <fmt/format.h>

#include "engine/physics/declare_components.h"
#include "engine/scene/declare_components.h"
#include "lanthorn/scene/extras.h"

namespace lanthorn::physics::test {

Stage::Stage(const PhysicsSettings& settings) : physics(settings) {
    declare_scene_components(registry);
    declare_physics_components(registry);
}

ecs::Entity Stage::add(const std::string& name, const std::string& extras, const dvec3& at, const Mesh* mesh,
                       const quat& rotation, const vec3& scale) {
    SceneData scene;
    scene.materials.resize(1);
    NodeData node;
    node.name = name;
    node.extras = extras;
    node.local = {at, rotation, scale};
    if (mesh != nullptr) {
        scene.meshes.push_back(*mesh);
        node.meshes = {0};
    }
    scene.nodes.push_back(node);
    const std::vector<ecs::Entity> made = spawn(world, std::move(scene));
    const std::vector<std::string> wrong = apply_extras(world, registry, made, "", BadExtras::skip);
    extras_warnings_.insert(extras_warnings_.end(), wrong.begin(), wrong.end());
    return made[0];
}

ecs::Entity Stage::add_floor(double top, const dvec3& at, double friction) {
    return add("floor", fmt::format(R"({{"body": {{"size": [200, 2, 200], "friction": {}}}}})", friction),
               at + dvec3(0, top - 1, 0));
}

std::vector<std::string> Stage::warnings() const {
    std::vector<std::string> all = extras_warnings_;
    all.insert(all.end(), physics.warnings().begin(), physics.warnings().end());
    return all;
}

void Stage::push(ecs::Entity e, const dvec3& linear, const dvec3& angular) {
    BodyMotion& motion = world.get_mut<BodyMotion>(e);
    motion.linear = linear;
    motion.angular = angular;
}

void Stage::step(int count) {
    for (int i = 0; i < count; ++i) {
        physics.step(world);
        transforms.update(world);
    }
}

std::vector<double> Stage::pose(const std::vector<ecs::Entity>& entities) const {
    std::vector<double> result;
    for (const ecs::Entity e : entities) {
        const dmat4& m = world.get<WorldTransform>(e).matrix;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) {
                result.push_back(m[column][row]);
            }
        }
    }
    return result;
}

}  // namespace lanthorn::physics::test
