#include "engine/render/shared_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "engine/core/finite.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

constexpr std::uint32_t kNoMap = ~0u;

struct MapCandidate {
    vec3 position{0};
    float weight = 0;  // how bright it is; 0: it is off and needs no map
    bool has_map = false;
};

struct MapGroup {
    std::span<std::uint32_t> lamps;
    Aabb box;
    double urgency = 0;
    std::uint32_t first = 0;  // decides between equals
};

MapGroup map_group_of(std::span<const MapCandidate> all, std::span<std::uint32_t> lamps) {
    MapGroup group{lamps, {}, 0, lamps.front()};
    double weight = 0;
    for (const std::uint32_t i : lamps) {
        group.box.add(all[i].position);
        weight += static_cast<double>(all[i].weight);
    }
    const dvec3 size(group.box.upper - group.box.lower);
    group.urgency = weight * glm::dot(size, size);
    return group;
}

bool less_urgent(const MapGroup& a, const MapGroup& b) {
    return a.urgency != b.urgency ? a.urgency < b.urgency : a.first > b.first;
}

// Halves the widest side of its box.
std::size_t halve(std::span<const MapCandidate> all, const MapGroup& group) {
    const vec3 size = group.box.upper - group.box.lower;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const float middle = group.box.lower[axis] + 0.5f * size[axis];
    const auto second = std::stable_partition(group.lamps.begin(), group.lamps.end(), [&](std::uint32_t i) {
        return all[i].position[axis] < middle;
    });
    const auto count = static_cast<std::size_t>(second - group.lamps.begin());
    return count == 0 || count == group.lamps.size() ? group.lamps.size() / 2 : count;
}

// The one of a group whose map the others use: that which is nearest to their middle, of those that have one.
std::uint32_t owner_of(std::span<const MapCandidate> all, const MapGroup& group) {
    dvec3 centre(0);
    double sum = 0;
    for (const std::uint32_t i : group.lamps) {
        centre += static_cast<double>(all[i].weight) * dvec3(all[i].position);
        sum += static_cast<double>(all[i].weight);
    }
    centre /= sum;
    const bool any = std::ranges::any_of(group.lamps, [&](std::uint32_t i) { return all[i].has_map; });
    std::uint32_t owner = group.lamps.front();
    double nearest = std::numeric_limits<double>::max();
    for (const std::uint32_t i : group.lamps) {
        const double d = glm::distance(dvec3(all[i].position), centre);
        if ((!any || all[i].has_map) && d < nearest) {
            nearest = d;
            owner = i;
        }
    }
    return owner;
}

// For each lamp the index of the one whose map it uses, at most `maps` of them; kNoMap for those without.
std::vector<std::uint32_t> owners_of(std::span<const MapCandidate> lamps, std::size_t maps) {
    std::vector<std::uint32_t> owners(lamps.size(), kNoMap);
    std::vector<std::uint32_t> shining;
    for (std::uint32_t i = 0; i < lamps.size(); ++i) {
        if (is_finite(lamps[i].position) && std::isfinite(lamps[i].weight) && lamps[i].weight > 0) {
            shining.push_back(i);
        }
    }
    if (shining.empty() || maps == 0) {
        return owners;
    }
    std::priority_queue<MapGroup, std::vector<MapGroup>, decltype(&less_urgent)> groups(&less_urgent);
    groups.push(map_group_of(lamps, shining));
    while (groups.size() < maps && groups.top().lamps.size() > 1 && groups.top().urgency > 0) {
        const MapGroup group = groups.top();
        groups.pop();
        const std::size_t middle = halve(lamps, group);
        groups.push(map_group_of(lamps, group.lamps.first(middle)));
        groups.push(map_group_of(lamps, group.lamps.subspan(middle)));
    }
    for (; !groups.empty(); groups.pop()) {
        const std::uint32_t owner = owner_of(lamps, groups.top());
        for (const std::uint32_t i : groups.top().lamps) {
            owners[i] = owner;
        }
    }
    return owners;
}

// Layers of the cubes that lights had, by id.
std::unordered_map<std::uint32_t, std::uint32_t> cubes_before(std::span<const LightData> before) {
    std::unordered_map<std::uint32_t, std::uint32_t> layers;
    for (const LightData& light : before) {
        if (light.layers == 6 && light.shares_map == 0 && light.type != kLightAreaSample) {
            layers.emplace(light.id, light.first_layer);
        }
    }
    return layers;
}

// A place of six layers for each owner, from `first` on: that which it had, or the first free one.
class Places {
  public:
    Places(std::uint32_t first, std::uint32_t cubes) : first_(first), taken_(cubes, false) {}

    // Whether the place that begins at `layer` was free.
    bool take(std::uint32_t layer) {
        const bool within =
            layer >= first_ && (layer - first_) % 6 == 0 && (layer - first_) / 6 < taken_.size();
        if (!within || taken_[(layer - first_) / 6]) {
            return false;
        }
        taken_[(layer - first_) / 6] = true;
        return true;
    }
    std::uint32_t take_next() {
        while (!take(first_ + 6 * next_)) {
            ++next_;
        }
        return first_ + 6 * next_;
    }

  private:
    std::uint32_t first_, next_ = 0;
    std::vector<bool> taken_;
};

}  // namespace

void share_maps(std::vector<LightData>& lights, std::span<const LightData> before, std::uint32_t most,
                int resolution) {
    const auto single = [](const LightData& light) { return light.layers == 1; };
    const bool spots_alone = std::ranges::count_if(lights, single) <= static_cast<std::ptrdiff_t>(most / 2);
    const std::unordered_map<std::uint32_t, std::uint32_t> had = cubes_before(before);
    std::uint32_t layers = 0;
    std::vector<std::size_t> sharing;
    std::vector<MapCandidate> candidates;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        LightData& light = lights[i];
        if (single(light) && (spots_alone || light.type == kLightDirectional)) {
            light.first_layer = layers;
            light.layers = layers < most ? 1 : 0;
            layers += light.layers;
            continue;
        }
        sharing.push_back(i);
        candidates.push_back({light.position, luminance(light.intensity), had.contains(light.id)});
    }
    const std::uint32_t cubes = (most - layers) / 6;
    for (const std::size_t i : sharing) {
        LightData& light = lights[i];
        light.first_layer = layers;
        light.layers = cubes > 0 ? 6 : 0;
        light.extent = 1;
        light.texel = 2.0f / static_cast<float>(resolution);
        light.shares_map = 1;
    }
    const std::vector<std::uint32_t> owners = owners_of(candidates, cubes);
    Places places(layers, cubes);
    std::vector<std::uint32_t> fresh;
    for (std::uint32_t k = 0; k < owners.size(); ++k) {
        if (owners[k] != k) {
            continue;
        }
        LightData& light = lights[sharing[k]];
        light.shares_map = 0;
        const auto kept = had.find(light.id);
        light.layers = 6;
        light.extent = 1;
        light.texel = 2.0f / static_cast<float>(resolution);
        if (kept != had.end() && places.take(kept->second)) {
            light.first_layer = kept->second;
        } else {
            fresh.push_back(k);
        }
    }
    for (const std::uint32_t k : fresh) {
        lights[sharing[k]].first_layer = places.take_next();
    }
    for (std::uint32_t k = 0; k < owners.size(); ++k) {
        if (owners[k] != k && owners[k] != kNoMap) {
            LightData& light = lights[sharing[k]];
            const LightData& owner = lights[sharing[owners[k]]];
            light.first_layer = owner.first_layer;
            light.map_offset = owner.position - light.position;
        }
    }
}

}  // namespace lanthorn::render
