#include "gi_module/techniques/emc/maps/centre_pool.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace lanthorn::gi {

namespace {

constexpr int kBlock = 4;      // cells a side of which one is a place
constexpr int kClearance = 3;  // cells that are told apart
constexpr float kFar = 0.3f;   // of the longest side: what is farther off is reached from centre to centre
// Of what is reached.
constexpr int kBeside = 4;       // that see each other: more are passed over, so that the others get farther
constexpr int kMostPassed = 10;  // centres that are looked at for one that is taken

std::uint32_t hashed(std::uint32_t x) {  // lowbias32 (Wellons 2018)
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

}  // namespace

CentrePool::CentrePool(const FrameScene& scene, const Aabb& bounds) : space_(scene, bounds) {
    // In each block the place with the most air around it.
    const std::vector<std::uint8_t> clearance = space_.clearance(kClearance);
    const ivec3 blocks = (space_.cells() + kBlock - 1) / kBlock;
    for (int b = 0; b < blocks.x * blocks.y * blocks.z; ++b) {
        const ivec3 first = kBlock * ivec3(b % blocks.x, b / blocks.x % blocks.y, b / (blocks.x * blocks.y));
        ivec3 best(0);
        int most = 0;
        for (int k = 0; k < kBlock * kBlock * kBlock; ++k) {
            const ivec3 c = first + ivec3(k % kBlock, k / kBlock % kBlock, k / (kBlock * kBlock));
            if (space_.inside(c) && clearance[space_.index(c)] > most) {
                most = clearance[space_.index(c)];
                best = c;
            }
        }
        if (most > 0) {
            places_.push_back({best, most});
        }
    }
}

// By cell, whether a way through free cells leads there from any of these places; along rows of cells.
std::vector<std::uint8_t> CentrePool::reached_from(std::span<const vec3> from) const {
    const ivec3 cells = space_.cells();
    std::vector<std::uint8_t> reached(space_.index(cells - 1) + 1, 0);
    std::vector<ivec3> front;  // one of each run of cells that are still to be reached
    const auto open = [&](const ivec3& c) { return space_.free(c) && reached[space_.index(c)] == 0; };
    for (const vec3& p : from) {
        const ivec3 c = space_.cell_of(p);
        if (space_.inside(c)) {
            front.push_back(c);
        }
    }
    while (!front.empty()) {
        ivec3 first = front.back();
        front.pop_back();
        if (!open(first)) {
            continue;
        }
        int end = first.x + 1;
        while (first.x > 0 && open(first - ivec3(1, 0, 0))) {
            --first.x;
        }
        while (end < cells.x && open({end, first.y, first.z})) {
            ++end;
        }
        const auto run = reached.begin() + static_cast<std::ptrdiff_t>(space_.index(first));
        std::fill(run, run + (end - first.x), std::uint8_t{1});
        for (const ivec3& step : {ivec3(0, 1, 0), ivec3(0, -1, 0), ivec3(0, 0, 1), ivec3(0, 0, -1)}) {
            ivec3 c = first + step;
            if (!space_.inside(c)) {
                continue;
            }
            for (bool before = false; c.x < end; ++c.x) {
                const bool is_open = open(c);
                if (is_open && !before) {
                    front.push_back(c);
                }
                before = is_open;
            }
        }
    }
    return reached;
}

double CentrePool::seen_share(std::span<const vec3> from, std::span<const vec3> centres) const {
    const std::vector<std::uint8_t> reached = reached_from(from);
    double all = 0, seen = 0;
    for (const Place& place : places_) {
        if (reached[space_.index(place.cell)] != 0) {
            ++all;
            const vec3 middle = space_.middle(place.cell);
            seen += std::ranges::any_of(
                centres, [&](const vec3& c) { return space_.in_sight(c, middle, space_.side()); });
        }
    }
    return all > 0 ? seen / all : 1;
}

bool CentrePool::near_in_sight(const vec3& a, const vec3& b) const {
    const vec3 way = b - a;
    const ivec3 cells = space_.cells();
    const float far = kFar * static_cast<float>(std::max({cells.x, cells.y, cells.z})) * space_.side();
    return glm::dot(way, way) < far * far && space_.in_sight(a, b);
}

void CentrePool::fill(std::uint32_t seed) {
    // Those with much air around them first.
    std::vector<std::tuple<int, std::uint32_t, int>> order;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        order.emplace_back(-places_[i].clearance, hashed(number ^ hashed(seed)), static_cast<int>(i));
    }
    std::ranges::sort(order);
    centres_.clear();
    ways_.clear();
    std::vector<bool> taken(places_.size(), false);
    const auto place = [&](int i) { return space_.middle(places_[static_cast<std::size_t>(i)].cell); };
    for (const auto& [clearance, hash, i] : order) {
        int seen = 0;
        for (auto c = centres_.begin(); c != centres_.end() && seen < kSight; ++c) {
            seen += near_in_sight(place(i), *c) ? 1 : 0;
        }
        if (seen < kSight) {
            taken[static_cast<std::size_t>(i)] = true;
            centres_.push_back(place(i));
        }
    }
    link();
    // Places from which one looks both ways: without them no way leads through a doorway or a hole.
    for (const auto& [clearance, hash, i] : order) {
        if (!taken[static_cast<std::size_t>(i)] && looks_both_ways(place(i))) {
            add(place(i), seen_from(place(i)));
        }
    }
}

// Whether it sees a centre to which the first that it sees has no way, and no way to one that has one. A look
// is what costs: most centres are near the first, and need none.
bool CentrePool::looks_both_ways(const vec3& place) const {
    const auto sees = [&](const vec3& centre) { return near_in_sight(place, centre); };
    const auto first = std::ranges::find_if(centres_, sees);
    if (first == centres_.end()) {
        return false;
    }
    std::vector<bool> near(centres_.size(), false);
    const auto begin = static_cast<std::size_t>(first - centres_.begin());
    near[begin] = true;
    for (const Way& way : ways_[begin]) {
        near[static_cast<std::size_t>(way.to)] = true;
        for (const Way& next : ways_[static_cast<std::size_t>(way.to)]) {
            near[static_cast<std::size_t>(next.to)] = true;
        }
    }
    for (std::size_t c = begin + 1; c < centres_.size(); ++c) {
        if (!near[c] && sees(centres_[c])) {
            return true;
        }
    }
    return false;
}

std::vector<int> CentrePool::seen_from(const vec3& place) const {
    std::vector<int> seen;
    for (std::size_t c = 0; c < centres_.size(); ++c) {
        if (near_in_sight(place, centres_[c])) {
            seen.push_back(static_cast<int>(c));
        }
    }
    return seen;
}

void CentrePool::add(const vec3& centre, std::span<const int> in_sight) {
    const auto own = static_cast<int>(centres_.size());
    centres_.push_back(centre);
    ways_.emplace_back();
    for (const int c : in_sight) {
        const float length = glm::distance(centre, centres_[static_cast<std::size_t>(c)]);
        ways_[static_cast<std::size_t>(c)].push_back({own, length});
        ways_.back().push_back({c, length});
    }
}

void CentrePool::link() {
    const std::vector<vec3> centres = std::exchange(centres_, {});
    ways_.clear();
    for (const vec3& centre : centres) {
        add(centre, seen_from(centre));
    }
}

bool CentrePool::leave_out(const FrameScene& scene, std::span<const std::uint32_t> moved) {
    const bool any = space_.leave_out(scene, moved);
    if (any && filled()) {
        link();
    }
    return any;
}

void CentrePool::carry(const vec3& by) {
    space_.carry(by);
    for (vec3& centre : centres_) {
        centre += by;
    }
}

std::vector<CentrePool::Reached> CentrePool::reach(const vec3& eye, int count) const {
    constexpr float kNever = std::numeric_limits<float>::infinity();
    std::vector<float> distance(centres_.size(), kNever);
    using Step = std::pair<float, int>;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
    const auto go = [&](int centre, float d) {
        if (d < distance[static_cast<std::size_t>(centre)]) {
            distance[static_cast<std::size_t>(centre)] = d;
            front.emplace(d, centre);
        }
    };
    int nearest = 0;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
        const float d = glm::distance(eye, centres_[i]);
        nearest = d < glm::distance(eye, centres_[static_cast<std::size_t>(nearest)]) ? static_cast<int>(i)
                                                                                      : nearest;
        if (space_.eye_sees(eye, centres_[i], space_.side())) {
            go(static_cast<int>(i), d);
        }
    }
    if (front.empty() && !centres_.empty()) {
        go(nearest, glm::distance(eye, centres_[static_cast<std::size_t>(nearest)]));
    }
    std::vector<Reached> result;
    std::vector<bool> taken(centres_.size(), false);
    int left = kMostPassed * count;
    while (!front.empty() && static_cast<int>(result.size()) < count && left-- > 0) {
        const auto [d, centre] = front.top();
        front.pop();
        const auto c = static_cast<std::size_t>(centre);
        if (d > distance[c]) {
            continue;
        }
        int beside = 0;
        for (const Way& way : ways_[c]) {
            beside += taken[static_cast<std::size_t>(way.to)] ? 1 : 0;
            go(way.to, d + way.length);
        }
        if (beside < kBeside) {
            taken[c] = true;
            result.push_back({centre, d});
        }
    }
    return result;
}

}  // namespace lanthorn::gi
