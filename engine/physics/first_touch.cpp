#include "engine/physics/first_touch.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <LinearMath/btTransformUtil.h>

namespace lanthorn::physics {

namespace {

constexpr int kAdvances = 64;  // a motion that needs more ends where they ended

// False if they overlap.
bool nearest_points(const Mover& a, const Mover& b, double share, btPointCollector& nearest) {
    btVoronoiSimplexSolver simplex;
    btGjkPairDetector detector(a.shape, b.shape, &simplex, nullptr);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = a.at(share);
    input.m_transformB = b.at(share);
    detector.getClosestPoints(input, nearest, nullptr);
    return nearest.m_hasResult && nearest.m_distance > 0;
}

}  // namespace

btTransform Motion::at(double share) const {
    btTransform result;
    btTransformUtil::integrateTransform(from, way, turn, share, result);
    return result;
}

btTransform Mover::at(double share) const {
    btTransform result = motion.at(share);
    result.setOrigin(result * offset);
    return result;
}

bool apart(const Mover& a, const Mover& b, double gap) {
    btPointCollector nearest;
    return nearest_points(a, b, 0, nearest) && nearest.m_distance > gap;
}

std::optional<double> first_touch(const Mover& a, const Mover& b, double near) {
    const btVector3 way = a.motion.way - b.motion.way;
    const double turns = a.motion.turn.length() * a.reach + b.motion.turn.length() * b.reach;
    double share = 0;
    for (int advance = 0; advance < kAdvances; ++advance) {
        btPointCollector nearest;
        if (!nearest_points(a, b, share, nearest) || nearest.m_distance <= near) {
            return share > 0 ? std::optional(share) : std::nullopt;
        }
        // No point of either comes nearer along the normal than this in a whole motion.
        const double closing = turns - nearest.m_normalOnBInWorld.dot(way);
        if (!(nearest.m_distance - 0.5 * near < closing * (1 - share))) {
            return 1;
        }
        share += (nearest.m_distance - 0.5 * near) / closing;
    }
    return share;
}

}  // namespace lanthorn::physics
