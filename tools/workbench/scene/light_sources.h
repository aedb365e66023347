// What shines in a scene, and its strength altered: for measurements of light that changes.
#pragma once

#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::workbench {

// The entities with a punctual light, in the world's order.
std::vector<ecs::Entity> punctual_lights(ecs::World& world);
// Those with a mesh whose material emits.
std::vector<ecs::Entity> emissive_meshes(ecs::World& world);

// Lights and emissive materials, made brighter or darker where they stand. Geometry does not change by it.
class DimmedLights {
  public:
    explicit DimmedLights(ecs::World& world) : world_(&world) {}

    // Adds the entity's punctual light and the emissive materials of its meshes as they are. A material that
    // other entities show changes for them too.
    void add(ecs::Entity entity);
    bool empty() const { return lights_.empty() && materials_.empty(); }

    // Makes their strengths `factor` of what they were when they were added.
    void dim(float factor);

  private:
    struct Lamp {
        ecs::Entity entity;
        float intensity;
    };
    struct Glow {
        MaterialHandle material;
        vec3 emissive;
    };
    ecs::World* world_;
    std::vector<Lamp> lights_;
    std::vector<Glow> materials_;
};

}  // namespace lanthorn::workbench
