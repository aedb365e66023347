// Bullet's world, in which no body passes through another between two steps.
//
// Bullet finds contacts where bodies are at the beginning of a step. A body that moves and turns by more in
// a step than a share of its half thickness may be past a floor by then. Such a body is swept, as it turns:
// where its core, the shape a little smaller about its middle, first touches another, it stays for the rest
// of the step. The contact that the next step finds does the rest: bounce, friction, weight. All other bodies
// move as in Bullet, bit for bit. A kinematic body that would leap over a dynamic one in a step takes it
// along.
//
// A sweep depends on poses and speeds alone, and its result on no order of bodies. Every dynamic body's user
// pointer is the `Core` of its shape.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <utility>
#include <vector>

#include "engine/physics/body_shape.h"
#include "engine/physics/first_touch.h"

namespace lanthorn::physics {

class ContinuousWorld : public btDiscreteDynamicsWorld {
  public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  protected:
    void integrateTransforms(btScalar time_step) override;
    void saveKinematicState(btScalar time_step) override;

  private:
    Motion motion_of(const btRigidBody& body, double time_step) const;
    // Of a motion of the body while others move for `time_step`; `without` is passed through.
    double free_share(const btRigidBody& body, const Motion& motion, double time_step,
                      const btCollisionObject* without);
    void push_ahead(const btRigidBody& pusher, const btTransform& from);

    std::vector<std::pair<btRigidBody*, btTransform>> stopped_;  // of this step, and where
    std::vector<std::pair<btRigidBody*, btTransform>> pushers_;  // kinematic bodies, and where they were
};

}  // namespace lanthorn::physics
