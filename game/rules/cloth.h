// A cloth that hangs: a net of points that fall, keep their distances and make way for the player. Each point
// is a joint, so that the cloth's mesh, a skinned control cage, follows them.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::ecs {
class Registry;
}  // namespace lanthorn::ecs

namespace lanthorn::game {

// On the node of the skinned mesh. The skin's joints are the points, children of this node, row by row from
// the top; those of the top row stay where they are. How they stand in the file is the cloth at rest.
struct Cloth {
    std::uint32_t columns = 2, rows = 2;  // points
    double damping = 1.2;                 // 1/s, of all motion
    double give = 2e-6;                   // m/N, of threads; lengthwise and across
    double bend = 4e-3;                   // m/N, of folds and askew
    double low = -1e3, high = 1e3;        // metres: between which X of the node it is kept by walls

    std::vector<double> lengths;  // metres, of its threads: see cloth_threads()
    std::vector<dvec3> points;    // metres, in the node's space
    std::vector<dvec3> speeds;    // metres a second
    std::uint32_t still = 0;      // steps since it last moved to speak of
    dvec3 met{0};                 // the player's feet as they were then, in the node's space
    bool operator==(const Cloth&) const = default;
};

// A pair of points that keep their distance.
struct Thread {
    std::uint32_t a, b;
    bool soft;  // askew and over two: it gives by `bend`
};
std::vector<Thread> cloth_threads(std::uint32_t columns, std::uint32_t rows);

// An upright capsule in the cloth's space, metres.
struct Pillar {
    dvec3 foot{0};
    double radius = 0.28, height = 1.75;
};

// Hangs anew: threads as long as they are between `points` now, nothing moves.
void start_cloth(Cloth& cloth, std::vector<dvec3> points);

// A fixed step of extended position-based dynamics with small steps (Macklin, Mueller and Chentanez 2016;
// Macklin et al. 2019). `down`: m/s^2, in the cloth's space. Returns whether a point moved: a cloth that has
// come to rest, and that nobody comes near, stays bit for bit as it is. O(threads).
bool step_cloth(Cloth& cloth, const dvec3& down, const Pillar* player);

// The share of the way from one point of the cloth's space to another that is before it, 0 to 1; 1: the way
// does not lead through it. O(points).
double share_before(const Cloth& cloth, const dvec3& from, const dvec3& to);

void declare_cloth(ecs::Registry& registry);

}  // namespace lanthorn::game
