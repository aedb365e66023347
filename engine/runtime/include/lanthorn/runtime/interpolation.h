// Motion between two steps: what the simulation moves is shown where it is between its last two poses, and is
// put back, bit for bit, before the next step.
#pragma once

#include <utility>
#include <vector>

#include "lanthorn/ecs/lookup.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/runtime/time.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// The component, on what moves by steps: a body, a character, what gameplay moves. An entity without it jumps
// from step to step. Nothing to be set from outside.
struct Interpolated {
    Transform previous, current;  // LocalTransform at the end of the step before and of the last one
    Transform shown;              // what the picture has made of LocalTransform
    bool started = false;         // `previous` and `current` are there
    bool between = false;         // LocalTransform is `shown`
};

// After declare_scene_components.
void declare_interpolation(ecs::Registry& registry);

// `share` of the way from one pose to the other: 0 and 1 give the poses themselves. Turns go the short way
// round.
Transform between(const Transform& from, const Transform& to, double share);

// Takes down the pose at the end of a step.
void remember_pose(Interpolated& pose, const Transform& local);
// Writes the pose to show; returns whether `local` changed.
bool show_pose(Interpolated& pose, double blend, Transform& local);
// Puts the simulation's pose back, unless something else has written `local` since: then it jumps there.
// Returns whether `local` changed.
bool restore_pose(Interpolated& pose, Transform& local);

// What the picture's animation has overwritten: a resource. What was kept first is put back last.
class SimulatedPose {
  public:
    // Notes that the entity's transform is `shown`, and is to be `simulated` again after restore().
    void keep(ecs::Entity e, const Transform& simulated, const Transform& shown) {
        transforms_.push_back({e, simulated, shown});
    }
    // The same of morph weights.
    void keep(ecs::Entity e, const std::vector<float>& simulated, const std::vector<float>& shown) {
        weights_.push_back({e, simulated, shown});
    }
    // The same of a light.
    void keep(ecs::Entity e, const Light& simulated, const Light& shown) {
        lights_.push_back({e, simulated, shown});
    }
    // The same of a camera.
    void keep(ecs::Entity e, const Camera& simulated, const Camera& shown) {
        cameras_.push_back({e, simulated, shown});
    }
    // Puts back what nothing else has written since.
    using Poses = ecs::Lookup<ecs::Write<LocalTransform>, ecs::Write<MorphWeights>,
                              ecs::Write<LightComponent>, ecs::Write<CameraComponent>>;
    // The last kept first; what something else has written since stays. O(kept).
    void restore(const Poses& poses);

  private:
    template <class T>
    struct Kept {
        ecs::Entity entity;
        T simulated, shown;
    };
    std::vector<Kept<Transform>> transforms_;
    std::vector<Kept<std::vector<float>>> weights_;
    std::vector<Kept<Light>> lights_;
    std::vector<Kept<Camera>> cameras_;
};

}  // namespace lanthorn
