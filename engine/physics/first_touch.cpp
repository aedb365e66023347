#include "engine/physics/first_touch.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <LinearMath/btTransformUtil.h>

namespace lanthorn::physics {

namespace {

constexpr int kAdvances = 64;  // a motion that needs more ends where they ended

double turning(const Mover& a, const Mover& b) {
    return a.motion.turn.length() * a.reach + b.motion.turn.length() * b.reach;
}

}  // namespace

btTransform Motion::at(double share) const {
    if (share == 0 || (way.isZero() && turn.isZero())) {
        return from;
    }
    btTransform result;
    btTransformUtil::integrateTransform(from, way, turn, share, result);
    return result;
}

btTransform Mover::at(double share) const {
    btTransform result = motion.at(share);
    result.setOrigin(result * offset);
    return result;
}

double most_way(const Mover& a, const Mover& b) {
    return (a.motion.way - b.motion.way).length() + turning(a, b);
}

Approach approach(const Mover& a, const Mover& b, double share) {
    btVoronoiSimplexSolver simplex;
    btGjkPairDetector detector(a.shape, b.shape, &simplex, nullptr);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = a.at(share);
    input.m_transformB = b.at(share);
    btPointCollector nearest;
    detector.getClosestPoints(input, nearest, nullptr);
    if (!nearest.m_hasResult || !(nearest.m_distance > 0)) {
        return {0, most_way(a, b)};
    }
    return {nearest.m_distance, turning(a, b) - nearest.m_normalOnBInWorld.dot(a.motion.way - b.motion.way)};
}

std::optional<double> first_touch(const Mover& a, const Mover& b, double near) {
    double share = 0;
    for (int advance = 0; advance < kAdvances; ++advance) {
        const auto [distance, closing] = approach(a, b, share);
        if (distance <= near) {
            return share > 0 ? std::optional(share) : std::nullopt;
        }
        if (!(distance - 0.5 * near < closing * (1 - share))) {
            return 1;
        }
        share += (distance - 0.5 * near) / closing;
    }
    return share;
}

}  // namespace lanthorn::physics
