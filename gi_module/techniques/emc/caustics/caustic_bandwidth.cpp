#include "gi_module/techniques/emc/caustics/caustic_bandwidth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "gi_module/shared/rays/packed_normal.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kNeighbours = 12;  // that density is taken from
constexpr std::size_t kWindow = 32;      // hits to either side in an order that are looked at
constexpr int kOrders = 3;

// Every third bit of the result is one of x's lower 21.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

// The axis that a normal is nearest to, 0 to 5: neighbours of another do not count.
std::uint32_t side_of(std::uint32_t packed) {
    const vec3 n = unpack_normal(packed);
    const vec3 a = glm::abs(n);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return static_cast<std::uint32_t>(2 * axis + (n[axis] < 0 ? 1 : 0));
}

struct Placed {
    vec3 position;
    std::uint32_t side;
};

}  // namespace

// Neighbours in space are neighbours along a Z-curve, but for where the curve jumps; of several curves, each
// moved a little, one hardly jumps there (Liao et al. 2001, "High dimensional similarity search with space
// filling curves").
void set_bandwidth(std::span<PhotonHit> hits, float c0, float widest) {
    if (hits.empty()) {
        return;
    }
    vec3 lower = hits.front().position, upper = lower;
    for (const PhotonHit& hit : hits) {
        lower = glm::min(lower, hit.position);
        upper = glm::max(upper, hit.position);
    }
    const vec3 size = upper - lower;
    const float side = std::max({size.x, size.y, size.z, 1e-20f});
    std::vector<Placed> by_hit;
    by_hit.reserve(hits.size());
    for (const PhotonHit& hit : hits) {
        by_hit.push_back({hit.position, side_of(hit.normal)});
    }
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(hits.size());
    std::vector<Placed> placed(hits.size());  // in that order
    // Square distances to the nearest, that other orders may have seen before: with the neighbour, not twice.
    std::vector<float> nearest(hits.size(), widest * widest * 1e4f);
    for (int o = 0; o < kOrders; ++o) {
        const vec3 moved = vec3(0.37f, 0.61f, 0.23f) * static_cast<float>(o) / static_cast<float>(kOrders);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const vec3 p = ((hits[i].position - lower) / side + moved) * (0.5f * 2097151.0f);
            const auto key = spread(static_cast<std::uint64_t>(p.x)) |
                             spread(static_cast<std::uint64_t>(p.y)) << 1 |
                             spread(static_cast<std::uint64_t>(p.z)) << 2;
            order[i] = {key, static_cast<std::uint32_t>(i)};
        }
        std::ranges::sort(order);
        for (std::size_t at = 0; at < order.size(); ++at) {
            placed[at] = by_hit[order[at].second];
        }
        std::array<float, 2 * kWindow + 1> distances;
        for (std::size_t at = 0; at < order.size(); ++at) {
            float& least = nearest[order[at].second];
            const Placed own = placed[at];
            const std::size_t first = at > kWindow ? at - kWindow : 0;
            const std::size_t last = std::min(at + kWindow, order.size() - 1);
            std::size_t count = 0;  // of those nearer than the orders before have found
            for (std::size_t k = first; k <= last; ++k) {
                const vec3 d = placed[k].position - own.position;
                const float distance = glm::dot(d, d);
                distances[count] = distance;
                count += placed[k].side == own.side && k != at && distance < least ? 1 : 0;
            }
            if (count >= kNeighbours) {
                const auto nth = distances.begin() + (kNeighbours - 1);
                std::nth_element(distances.begin(), nth,
                                 distances.begin() + static_cast<std::ptrdiff_t>(count));
                least = *nth;
            }
        }
    }
    constexpr float kEven = 1.77245385f / 3.46410162f;  // sqrt(pi / kNeighbours)
    static_assert(kNeighbours == 12);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i].radius = std::clamp(c0 * kEven * std::sqrt(nearest[i]), 1e-5f * widest, widest);
    }
}

}  // namespace lanthorn::gi
