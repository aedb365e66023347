#include "engine/render/lamp_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "engine/core/finite.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

// Of the error over closeness^4: what is left once places and second moments are right.
constexpr float kFourth = 0.3f;
constexpr float kAllFar = 1e15f;  // metres; its square is finite
// Up to this share of its range a group is taken for one: where the window that ends it is still flat.
constexpr float kFlatWindow = 0.6f;

struct Group {
    dvec3 centre{0};  // mean place by luminance
    dvec3 intensity{0};
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;  // second moments about it, m^2
    float radius = 0;
    float reach = 0;  // from the centre
    float least_range = std::numeric_limits<float>::max(), most_range = 0;
    vec3 axis{0};               // of all spots, unit; 0: they shine to all sides
    float cosine = -1;          // of the cone about it that holds their cones
    std::uint32_t speaker = 0;  // the lamp that is nearest to the centre
};

double weight_of(const LightData& light) {
    return std::max(static_cast<double>(luminance(light.intensity)), 1e-30);
}

float range_of(const LightData& light) {
    return light.range >= 1e30f ? kAllFar : std::max(light.range, 0.0f);
}

// The cone of a group: its axis is the mean of theirs.
void add_cone(std::span<const LightData> lights, std::span<const std::uint32_t> lamps, Group& group) {
    vec3 sum(0);
    for (const std::uint32_t i : lamps) {
        if (lights[i].type != kLightSpot) {
            return;
        }
        sum += lights[i].direction;
    }
    const float length = glm::length(sum);
    if (length < 1e-3f * static_cast<float>(lamps.size())) {
        return;
    }
    group.axis = sum / length;
    float widest = 0;
    for (const std::uint32_t i : lamps) {
        widest =
            std::max(widest, std::acos(std::clamp(glm::dot(group.axis, lights[i].direction), -1.0f, 1.0f)) +
                                 std::acos(std::clamp(lights[i].cos_outer, -1.0f, 1.0f)));
    }
    group.cosine = std::cos(std::min(widest + 1e-3f, kPi));
}

Group group_of(std::span<const LightData> lights, std::span<const std::uint32_t> lamps) {
    Group group;
    double sum = 0;
    const dvec3 first(lights[lamps.front()].position);
    for (const std::uint32_t i : lamps) {
        const double w = weight_of(lights[i]);
        group.centre += w * (dvec3(lights[i].position) - first);
        group.intensity += dvec3(lights[i].intensity);
        sum += w;
    }
    // As it is stored, so that moments and radius are about that very place.
    group.centre = dvec3(vec3(first + group.centre / sum));
    double nearest = std::numeric_limits<double>::max();
    double radius = 0;
    for (const std::uint32_t i : lamps) {
        const double w = weight_of(lights[i]) / sum;
        const dvec3 d = dvec3(lights[i].position) - group.centre;
        group.xx += w * d.x * d.x;
        group.yy += w * d.y * d.y;
        group.zz += w * d.z * d.z;
        group.xy += w * d.x * d.y;
        group.xz += w * d.x * d.z;
        group.yz += w * d.y * d.z;
        const double off = glm::length(d);
        if (off < nearest) {
            nearest = off;
            group.speaker = i;
        }
        radius = std::max(radius, off);
        const float range = range_of(lights[i]);
        group.reach = std::max(group.reach, static_cast<float>(off) + range);
        group.least_range = std::min(group.least_range, range);
        group.most_range = std::max(group.most_range, range);
    }
    group.radius = static_cast<float>(radius * (1 + 1e-6));
    add_cone(lights, lamps, group);
    return group;
}

// From how far away at most the group may be taken for one.
float taken_within(const Group& group, bool alone) {
    if (alone || group.least_range >= kAllFar) {
        return kAllFar;
    }
    const bool at_one_place = group.radius == 0 && group.least_range == group.most_range;
    return at_one_place ? kAllFar : std::max(kFlatWindow * group.least_range - group.radius, 0.0f);
}

class Builder {
  public:
    Builder(ShiningLights& shining, bool groups) : shining_(shining), groups_(groups) {}

    // The nodes of the lamps in `lamps`, which are put in order, from the next free one on.
    void add(std::span<std::uint32_t> lamps) {
        const std::span<const LightData> lights(shining_.lights);
        const Group group = group_of(lights, lamps);
        const bool alone = lamps.size() == 1;
        const bool same = groups_ && group.radius == 0 && group.least_range == group.most_range;
        const std::size_t at = shining_.nodes.size();
        write(group, alone);
        if (!alone && !same) {
            const std::size_t middle = split(lamps);
            add(lamps.first(middle));
            add(lamps.subspan(middle));
        }
        // Behind its children.
        const std::size_t next = shining_.nodes.size() / kLampNodeTexels;
        shining_.nodes[at + 1].z = static_cast<float>(next);
    }

  private:
    void write(const Group& g, bool alone) {
        const LightData& speaker = shining_.lights[g.speaker];
        const vec3 centre(g.centre);
        const float within = groups_ || alone ? taken_within(g, alone) : -1;
        const auto far = [](float metres) { return metres * std::abs(metres); };
        std::vector<vec4>& nodes = shining_.nodes;
        nodes.emplace_back(centre, g.radius);
        nodes.emplace_back(far(g.reach), far(within), 0, static_cast<float>(g.speaker));
        if (!groups_) {
            nodes.emplace_back(g.axis, g.cosine);
            nodes.resize(nodes.size() + kLampNodeTexels - 3, vec4(0));
            return;
        }
        nodes.emplace_back(vec3(g.intensity),
                           std::min(g.least_range >= kAllFar ? 1e30f : g.least_range, 1e30f));
        nodes.emplace_back(speaker.position + speaker.map_offset - centre,
                           static_cast<float>(speaker.first_layer));
        nodes.emplace_back(g.xx, g.yy, g.zz, g.xy);
        nodes.emplace_back(g.xz, g.yz, 0, 0);
    }

    // Halves the widest side of the box around them; where all lie at one place, their number.
    std::size_t split(std::span<std::uint32_t> lamps) const {
        Aabb box;
        for (const std::uint32_t i : lamps) {
            box.add(shining_.lights[i].position);
        }
        const vec3 size = box.upper - box.lower;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const float middle = box.lower[axis] + 0.5f * size[axis];
        const auto second = std::stable_partition(lamps.begin(), lamps.end(), [&](std::uint32_t i) {
            return shining_.lights[i].position[axis] < middle;
        });
        const auto count = static_cast<std::size_t>(second - lamps.begin());
        return count == 0 || count == lamps.size() ? lamps.size() / 2 : count;
    }

    ShiningLights& shining_;
    bool groups_;
};

}  // namespace

float lamp_closeness(float error) {
    return std::sqrt(std::sqrt(std::max(error, 0.0f) / kFourth));
}

void build_lamp_trees(ShiningLights& shining, float error) {
    shining.nodes.clear();
    shining.node_ends = {};
    shining.closeness = lamp_closeness(error);
    for (const LightKind kind : {LightKind::point, LightKind::spot, LightKind::other}) {
        const auto k = static_cast<std::size_t>(kind);
        std::vector<std::uint32_t> lamps;
        for (int i = shining.ends[k - 1]; i < shining.ends[k]; ++i) {
            const LightData& light = shining.lights[static_cast<std::size_t>(i)];
            if (is_finite(light.position) && is_finite(light.intensity) && is_finite(light.direction)) {
                lamps.push_back(static_cast<std::uint32_t>(i));
            }
        }
        if (!lamps.empty()) {
            Builder(shining, kind == LightKind::point).add(lamps);
        }
        shining.node_ends[k] = static_cast<int>(shining.nodes.size() / kLampNodeTexels);
    }
    // Of kinds in between that have none.
    for (std::size_t k = 1; k < kLightKinds; ++k) {
        shining.node_ends[k] = std::max(shining.node_ends[k], shining.node_ends[k - 1]);
    }
}

}  // namespace lanthorn::render
