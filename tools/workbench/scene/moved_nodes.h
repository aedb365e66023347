// Nodes of a scene, lights above all, moved by their entities: for measurements of what changes.
#pragma once

#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::workbench {

class MovedNodes {
  public:
    explicit MovedNodes(ecs::World& world) : world_(&world) {}

    // Adds an entity as it stands. `turns`: move() turns it about +Y instead of moving it. False for one
    // whose parent's world transform cannot be undone.
    bool add(ecs::Entity entity, bool turns);
    bool empty() const { return nodes_.empty(); }

    // From where they stood when they were added: metres in the world, radians about the parent's +Y.
    void move(const dvec3& metres, double radians);

  private:
    struct Moved {
        ecs::Entity entity;
        Transform still;
        glm::dmat3 to_local;  // world directions to the parent's
        bool turns;
    };
    ecs::World* world_;
    std::vector<Moved> nodes_;
};

}  // namespace lanthorn::workbench
