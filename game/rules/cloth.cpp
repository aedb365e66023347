#include "game/rules/cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/registry.h"

namespace lanthorn::game {

namespace {

constexpr int kSubsteps = 6;
constexpr double kStep = kStepSeconds / kSubsteps;
constexpr double kMass = 0.01;        // kilograms, of a point
constexpr double kThick = 0.02;       // metres, of what the cloth keeps from a body
constexpr double kStillSpeed = 0.02;  // metres a second
constexpr std::uint32_t kStillSteps = 30;

// How far each end moves along the thread, by eq. 18 of Macklin, Mueller and Chentanez (2016) with no
// multiplier from an iteration before: there is one iteration a substep. `give`: over the substep's square.
void pull(std::vector<dvec3>& points, const Thread& thread, double length, double give,
          std::uint32_t pinned) {
    const double a = thread.a < pinned ? 0 : 1 / kMass, b = thread.b < pinned ? 0 : 1 / kMass;
    if (a + b == 0) {
        return;
    }
    const dvec3 way = points[thread.b] - points[thread.a];
    const double distance = glm::length(way);
    if (!(distance > 0)) {
        return;
    }
    const dvec3 pulled = way * ((distance - length) / (distance * (a + b + give)));
    points[thread.a] += a * pulled;
    points[thread.b] -= b * pulled;
}

// A cloth's threads with their places in Cloth::lengths, in another order that gives the same bits: threads
// that share a point keep theirs, and most neighbours share none, so that a processor works on several at
// once instead of waiting for the root of each.
struct PlacedThread {
    Thread thread;
    std::uint32_t place;
};
std::vector<PlacedThread> apart(std::uint32_t columns, std::uint32_t rows) {
    const std::vector<Thread> threads = cloth_threads(columns, rows);
    std::vector<std::uint32_t> turns(threads.size()), last(std::size_t{columns} * rows, 0);
    std::vector<PlacedThread> placed;
    for (std::uint32_t i = 0; i < threads.size(); ++i) {
        // The first turn after those of all before it that share a point.
        const auto [a, b, soft] = threads[i];
        turns[i] = last[a] = last[b] = std::max(last[a], last[b]) + 1;
        placed.push_back({threads[i], i});
    }
    std::ranges::stable_sort(placed, {}, [&](const PlacedThread& one) { return turns[one.place]; });
    return placed;
}

// The same, kept: cloths of a level have few sizes.
const std::vector<PlacedThread>& threads_apart(std::uint32_t columns, std::uint32_t rows) {
    thread_local std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<PlacedThread>> kept;
    std::vector<PlacedThread>& threads = kept[{columns, rows}];
    if (threads.empty()) {
        threads = apart(columns, rows);
    }
    return threads;
}

// Out of the player, level where she is upright.
dvec3 pushed_out(const dvec3& point, const Pillar& player) {
    const double top = std::max(player.height - player.radius, player.radius);
    const dvec3 axis = player.foot + dvec3(0, std::clamp(point.y - player.foot.y, player.radius, top), 0);
    const dvec3 way = point - axis;
    const double least = player.radius + kThick;
    if (glm::dot(way, way) > 1.01 * least * least) {
        return point;  // surely, without a root
    }
    const double distance = glm::length(way);
    return distance < least && distance > 0 ? axis + way * (least / distance) : point;
}

// Whether some of the cloth may be in a box.
bool may_meet(const Cloth& cloth, const dvec3& box_low, const dvec3& box_high) {
    constexpr double kMargin = 1e-3;  // metres: more than any rounding
    dvec3 low = cloth.points.front(), high = low;
    for (const dvec3& point : cloth.points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return glm::all(glm::lessThanEqual(low - kMargin, box_high)) &&
           glm::all(glm::greaterThanEqual(high + kMargin, box_low));
}

bool comes_near(const Cloth& cloth, const Pillar& player) {
    const double near = player.radius + kThick + 0.1;
    dvec3 low = cloth.points.front(), high = low;
    for (const dvec3& point : cloth.points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const dvec3 foot = player.foot, head = foot + dvec3(0, player.height, 0);
    return glm::all(glm::greaterThan(head + near, low)) && glm::all(glm::lessThan(foot - near, high)) &&
           glm::distance(foot, cloth.met) > 1e-3;
}

}  // namespace

std::vector<Thread> cloth_threads(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Thread> threads;
    const auto add = [&](std::uint32_t c, std::uint32_t r, int across, std::uint32_t down, bool soft) {
        const int to = static_cast<int>(c) + across;
        if (to >= 0 && to < static_cast<int>(columns) && r + down < rows) {
            threads.push_back({r * columns + c, (r + down) * columns + static_cast<std::uint32_t>(to), soft});
        }
    };
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            add(c, r, 1, 0, false);
            add(c, r, 0, 1, false);
            add(c, r, 1, 1, true);
            add(c, r, -1, 1, true);
            add(c, r, 2, 0, true);
            add(c, r, 0, 2, true);
        }
    }
    return threads;
}

void start_cloth(Cloth& cloth, std::vector<dvec3> points) {
    cloth.points = std::move(points);
    cloth.speeds.assign(cloth.points.size(), dvec3(0));
    cloth.lengths.clear();
    for (const Thread& thread : cloth_threads(cloth.columns, cloth.rows)) {
        cloth.lengths.push_back(glm::distance(cloth.points[thread.a], cloth.points[thread.b]));
    }
    cloth.still = 0;
}

bool step_cloth(Cloth& cloth, const dvec3& down, const Pillar* player) {
    if (cloth.still >= kStillSteps && (player == nullptr || !comes_near(cloth, *player))) {
        return false;
    }
    const std::vector<PlacedThread>& threads = threads_apart(cloth.columns, cloth.rows);
    const std::uint32_t pinned = cloth.columns;
    const double soft = cloth.bend / (kStep * kStep), hard = cloth.give / (kStep * kStep);
    std::vector<dvec3> before;
    for (int substep = 0; substep < kSubsteps; ++substep) {
        before = cloth.points;
        for (std::uint32_t i = pinned; i < cloth.points.size(); ++i) {
            cloth.speeds[i] = (cloth.speeds[i] + kStep * down) * (1 - std::min(cloth.damping * kStep, 1.0));
            cloth.points[i] += kStep * cloth.speeds[i];
        }
        for (const auto& [thread, place] : threads) {
            pull(cloth.points, thread, cloth.lengths[place], thread.soft ? soft : hard, pinned);
        }
        for (std::uint32_t i = pinned; i < cloth.points.size(); ++i) {
            dvec3& point = cloth.points[i];
            point = player != nullptr ? pushed_out(point, *player) : point;
            point.x = std::clamp(point.x, cloth.low, cloth.high);
            cloth.speeds[i] = (point - before[i]) / kStep;
        }
    }
    const bool slow = std::ranges::all_of(
        cloth.speeds, [](const dvec3& speed) { return glm::length(speed) < kStillSpeed; });
    cloth.still = slow ? std::min(cloth.still + 1, kStillSteps) : 0;
    cloth.met = player != nullptr ? player->foot : dvec3(0);
    if (cloth.still == kStillSteps) {
        cloth.speeds.assign(cloth.speeds.size(), dvec3(0));
    }
    return true;
}

double share_before(const Cloth& cloth, const dvec3& from, const dvec3& to) {
    double least = 1;
    const dvec3 way = to - from;
    if (!may_meet(cloth, glm::min(from, to), glm::max(from, to))) {
        return least;
    }
    // Moeller and Trumbore (1997), both sides.
    const auto meet = [&](const dvec3& a, const dvec3& b, const dvec3& c) {
        const dvec3 side = b - a, other = c - a, p = glm::cross(way, other);
        const double det = glm::dot(side, p);
        if (det == 0) {
            return;
        }
        const dvec3 s = from - a, q = glm::cross(s, side);
        const double u = glm::dot(s, p) / det, v = glm::dot(way, q) / det;
        const double share = glm::dot(other, q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && share > 0) {
            least = std::min(least, share);
        }
    };
    for (std::uint32_t r = 0; r + 1 < cloth.rows; ++r) {
        for (std::uint32_t c = 0; c + 1 < cloth.columns; ++c) {
            const dvec3* top = cloth.points.data() + r * cloth.columns + c;
            const dvec3* below = top + cloth.columns;
            meet(top[0], below[0], below[1]);
            meet(top[0], below[1], top[1]);
        }
    }
    return least;
}

void declare_cloth(ecs::Registry& registry) {
    using ecs::field;
    registry
        .component<Cloth>(
            "cloth", "hangs, and makes way for the player",
            field("columns", &Cloth::columns).range(2, 64).words("of points"),
            field("rows", &Cloth::rows).range(2, 64).words("of points, from the top"),
            field("damping", &Cloth::damping).unit("1/s").range(0, 100),
            field("give", &Cloth::give).unit("m/N").range(0, 1).words("of threads lengthwise and across"),
            field("bend", &Cloth::bend).unit("m/N").range(0, 1e3).words("of folds and askew"),
            field("low", &Cloth::low).unit("m").words("the least X of the node that it comes to"),
            field("high", &Cloth::high).unit("m").words("the greatest"),
            field("lengths", &Cloth::lengths).runtime().unit("m").words("of its threads"),
            field("points", &Cloth::points).runtime().unit("m").words("in the node's space"),
            field("speeds", &Cloth::speeds).runtime().unit("m/s"),
            field("still", &Cloth::still).runtime().words("steps since it last moved"),
            field("met", &Cloth::met).runtime().unit("m").words("where the player's feet were then"))
        .check([](const Cloth& cloth) {
            return std::string(cloth.low <= cloth.high ? "" : "low is greater than high");
        });
}

}  // namespace lanthorn::game
