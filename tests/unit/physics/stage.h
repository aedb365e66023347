// A world with bodies in it, and its steps.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::physics::test {

class Stage {
  public:
    explicit Stage(const PhysicsSettings& settings = {});

    // A node with `extras` and, if given, a mesh.
    ecs::Entity add(const std::string& name, const std::string& extras, const dvec3& at,
                    const Mesh* mesh = nullptr, const quat& rotation = {1, 0, 0, 0},
                    const vec3& scale = vec3(1));
    // A static box of 200 x 2 x 200 m whose top is at y = `top`.
    ecs::Entity add_floor(double top = 0, const dvec3& at = dvec3(0), double friction = 0.5);
    void step(int count = 1);

    // What was wrong with extras, and what Physics had to say.
    std::vector<std::string> warnings() const;

    // Of a dynamic body; gives it another speed.
    const BodyMotion* motion(ecs::Entity e) const { return world.try_get<BodyMotion>(e); }
    void push(ecs::Entity e, const dvec3& linear, const dvec3& angular = dvec3(0));

    dvec3 place(ecs::Entity e) const { return dvec3(world.get<WorldTransform>(e).matrix[3]); }
    // All places and rotations, in the order of `entities`: to be compared bit by bit.
    std::vector<double> pose(const std::vector<ecs::Entity>& entities) const;

    ecs::Registry registry;
    ecs::World world;
    Physics physics;
    Transforms transforms;

  private:
    std::vector<std::string> extras_warnings_;
};

}  // namespace lanthorn::physics::test
