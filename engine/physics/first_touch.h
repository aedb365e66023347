// When a moving convex shape first touches another: conservative advancement (Mirtich 1996, as in Bullet's
// btContinuousConvexCollision, but with lengths relative to the shapes instead of a fixed millimetre).
#pragma once

#include <btBulletCollisionCommon.h>

#include <optional>

namespace lanthorn::physics {

// From one pose along a straight line, while it turns about its origin at an even rate.
struct Motion {
    btTransform from = btTransform::getIdentity();
    btVector3 way{0, 0, 0};   // metres
    btVector3 turn{0, 0, 0};  // axis times radians, at most a quarter of pi

    btTransform at(double share) const;  // 0..1 of it
};

// A convex shape in motion.
struct Mover {
    const btConvexShape* shape = nullptr;
    Motion motion;
    btVector3 offset{0, 0, 0};  // of the shape's origin, in the moving frame
    double reach = 0;           // metres from the frame's origin to the shape's farthest point

    btTransform at(double share) const;
};

struct Approach {
    double distance = 0;  // metres between the shapes at a moment; 0: they overlap
    double closing = 0;   // metres, the most that a whole motion brings them nearer along the shortest way
};
// After a share of both motions.
Approach approach(const Mover& a, const Mover& b, double share);

// Metres by which any point of one can move against the other in a whole motion, at most.
double most_way(const Mover& a, const Mover& b);

// The share of both motions after which the shapes are not more than `near` metres apart, 1 if they do not
// come so near; nothing where they are as near at the start. Within `near`, never past it. O(vertices).
std::optional<double> first_touch(const Mover& a, const Mover& b, double near);

}  // namespace lanthorn::physics
