// A scene's lights, moved by their entities: for measurements of light that changes.
#pragma once

#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::tools {

class MovedLights {
  public:
    explicit MovedLights(ecs::World& world) : world_(&world) {}

    // Adds an entity as it stands. `turns`: move() turns it about +Y instead of moving it along +X. False for
    // one whose parent's world transform cannot be undone.
    bool add(ecs::Entity entity, bool turns);
    bool empty() const { return lights_.empty(); }

    // From where they stood when they were added: metres along the world's +X, radians about the parent's +Y.
    void move(double metres, double radians);

  private:
    struct Moved {
        ecs::Entity entity;
        Transform still;
        glm::dmat3 to_local;  // world directions to the parent's
        bool turns;
    };
    ecs::World* world_;
    std::vector<Moved> lights_;
};

}  // namespace lanthorn::tools
