// How a character gets from one place to the next: an upright capsule swept through the world that slides
// along what it meets, climbs steps and stays on the ground (after Rose 2021 and Fauerby 2003, "Improved
// Collision detection and Response": move, and what is left of the way goes along the surface met).
#pragma once

#include <btBulletCollisionCommon.h>

#include "lanthorn/physics/components.h"

namespace lanthorn::physics {

class CharacterMotion {
  public:
    // `self` is passed over. Both must outlive this.
    CharacterMotion(const btCollisionWorld& world, const btCollisionObject& self,
                    const Character& description);

    // The feet after `dt` seconds. Everything in metres and seconds, +Y up.
    dvec3 step(const dvec3& feet, const CharacterInput& input, double gravity, double dt,
               CharacterState& state) const;

  private:
    struct Contact {
        bool met = false;
        double share = 1;  // of the way
        dvec3 normal{0};   // off what was met
        dvec3 point{0};
    };
    Contact sweep(const dvec3& feet, const dvec3& way) const;
    // As far as it goes along `way`, short of what it meets by a skin.
    dvec3 advance(const dvec3& feet, const dvec3& way, Contact& contact) const;
    dvec3 walk(const dvec3& feet, const dvec3& way, bool on_ground) const;
    bool climb(const dvec3& feet, const dvec3& way, dvec3& result) const;
    dvec3 settle(const dvec3& feet, double reach, bool& landed) const;
    bool foothold(const dvec3& feet, const Contact& contact, const dvec3& side) const;
    bool carries(const dvec3& feet, const Contact& contact) const;
    dvec3 leave_solids(const dvec3& feet) const;
    bool walkable(const dvec3& normal) const { return normal.y >= walkable_; }
    btTransform placed(const dvec3& feet) const;

    const btCollisionWorld& world_;
    const btCollisionObject& self_;
    Character description_;
    btCapsuleShape capsule_;
    double walkable_;  // least Y of a normal that can be stood on
    double skin_;      // metres kept between the capsule and what it touches
};

}  // namespace lanthorn::physics
