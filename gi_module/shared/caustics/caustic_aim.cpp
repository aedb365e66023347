#include "gi_module/shared/caustics/caustic_aim.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/scene/emissive_pieces.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::gi {

namespace {

using std::numbers::pi;

dvec3 corner_of(const Aabb& box, int i) {
    return {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
            (i & 4) != 0 ? box.upper.z : box.lower.z};
}

// Two axes square to unit n (Duff et al. 2017).
void axes_about(const dvec3& n, dvec3& right, dvec3& up) {
    const double s = std::copysign(1.0, n.z);
    const double a = -1 / (s + n.z);
    const double b = n.x * n.y * a;
    right = {1 + s * n.x * n.x * a, s * b, -s * n.x};
    up = {b, s + n.y * n.y * a, -n.y};
}

double distance_to(const Aabb& box, const dvec3& p) {
    return glm::length(glm::max(glm::max(dvec3(box.lower) - p, p - dvec3(box.upper)), dvec3(0)));
}

// How many of the entity's own instances stand before it. Unlike the mesh's slot it does not depend on what
// else was loaded, or on what was there before. O(parts of the entity).
std::uint32_t place_in_entity(const FrameScene& scene, std::uint32_t instance) {
    std::uint32_t place = 0;
    while (place < instance && scene.instances[instance - place - 1].id == scene.instances[instance].id) {
        ++place;
    }
    return place;
}

// Splits `members` at the middle of their centres' longest axis until there are no more than `most` parts.
void share(std::span<std::uint32_t> members, std::size_t most, const FrameScene& scene,
           CausticTargets& result) {
    if (members.size() <= 1 || most <= 1) {
        CausticTarget target{{}, 0};
        std::uint32_t first = CausticTargets::kNone;
        for (const std::uint32_t i : members) {
            target.bounds.add(scene.instances[i].bounds);
            result.of_instance[i] = static_cast<std::uint32_t>(result.targets.size());
            first = std::min(first, i);
        }
        target.key = std::uint64_t{scene.instances[first].id} << 32 | place_in_entity(scene, first);
        result.targets.push_back(target);
        return;
    }
    Aabb centres;
    for (const std::uint32_t i : members) {
        centres.add(scene.instances[i].bounds.centre());
    }
    const vec3 size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::ranges::sort(members, [&](std::uint32_t a, std::uint32_t b) {
        const float x = scene.instances[a].bounds.centre()[axis];
        const float y = scene.instances[b].bounds.centre()[axis];
        return x != y ? x < y : a < b;
    });
    const std::size_t half = members.size() / 2;
    share(members.first(half), most / 2, scene, result);
    share(members.subspan(half), most - most / 2, scene, result);
}

}  // namespace

bool throws_caustics(const Material& m) {
    if (m.unlit || m.alpha_mode == AlphaMode::blend) {  // blended surfaces take no part
        return false;
    }
    return m.transmission > 0 || is_mirror(m);
}

CausticTargets CausticTargets::of(const FrameScene& scene, std::size_t most) {
    CausticTargets result;
    result.of_instance.assign(scene.instances.size(), kNone);
    std::vector<std::uint32_t> members;
    Aabb all;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        all.add(instance.bounds);
        if (throws_caustics(scene.material(instance)) && !instance.bounds.empty()) {
            members.push_back(i);
        }
    }
    result.diagonal = all.empty() ? 0 : static_cast<double>(all.diagonal());
    if (members.size() > most) {
        share(members, most, scene, result);
        return result;
    }
    for (std::uint32_t& i : members) {
        share({&i, 1}, 1, scene, result);
    }
    return result;
}

CausticTargets CausticTargets::everything(const FrameScene& scene) {
    CausticTargets result;
    result.targets.push_back({scene.bounds, 0});
    result.diagonal = static_cast<double>(scene.bounds.diagonal());
    return result;
}

CausticAim aim_at(const Aabb& box, const dvec3& from) {
    CausticAim aim;
    const dvec3 centre = 0.5 * (dvec3(box.lower) + dvec3(box.upper));
    const double distance = glm::length(centre - from);
    const double radius = 0.5 * glm::length(dvec3(box.upper) - dvec3(box.lower));
    aim.one_less_cosine = 2;
    if (!(distance > 0)) {
        return aim;
    }
    aim.axis = (centre - from) / distance;
    if (distance > radius) {
        const double sine2 = radius * radius / (distance * distance);
        aim.one_less_cosine = sine2 / (1 + std::sqrt(1 - sine2));
    }
    if (distance_to(box, from) > 0) {  // a cone of less than a half space that has all corners has the box
        double widest = 0;
        for (int i = 0; i < 8; ++i) {
            const dvec3 d = corner_of(box, i) - from;
            const double along = glm::dot(d, aim.axis);
            const double length = glm::length(d);
            if (!(along > 1e-3 * length)) {
                return aim;
            }
            const dvec3 across = d - along * aim.axis;
            const double sine2 = glm::dot(across, across) / (length * length);
            widest = std::max(widest, sine2 / (1 + along / length));
        }
        aim.one_less_cosine = std::min(aim.one_less_cosine, widest * (1 + 1e-6) + 1e-14);
    }
    return aim;
}

CausticAim aim_beam(const Aabb& box, const dvec3& direction) {
    CausticAim aim;
    aim.axis = direction;
    dvec3 right, up;
    axes_about(direction, right, up);
    dvec3 lower(1e300), upper(-1e300);
    for (int i = 0; i < 8; ++i) {
        const dvec3 c = corner_of(box, i);
        const dvec3 p(glm::dot(c, right), glm::dot(c, up), glm::dot(c, direction));
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    aim.corner = right * lower.x + up * lower.y + direction * lower.z;
    aim.right = right * (upper.x - lower.x);
    aim.up = up * (upper.y - lower.y);
    return aim;
}

dvec3 in_cone(const CausticAim& aim, const glm::dvec2& u) {
    const double less = u.x * aim.one_less_cosine;  // 1 - cos
    const double sine = std::sqrt(std::max(less * (2 - less), 0.0));
    dvec3 right, up;
    axes_about(aim.axis, right, up);
    const double phi = 2 * pi * u.y;
    return aim.axis * (1 - less) + (right * std::cos(phi) + up * std::sin(phi)) * sine;
}

double flux_towards(const LightInstance& placed, const Aabb& box) {
    const Light& light = placed.light;
    const double intensity = luminance(dvec3(light.colour)) * static_cast<double>(light.intensity);
    if (!(intensity > 0) || box.empty()) {
        return 0;
    }
    if (light.type == LightType::directional) {
        return intensity * aim_beam(box, dvec3(placed.direction)).area();
    }
    const dvec3 from(placed.position);
    if (distance_to(box, from) >= static_cast<double>(light.range)) {
        return 0;
    }
    const CausticAim aim = aim_at(box, from);
    if (light.type == LightType::point) {
        return intensity * aim.solid_angle();
    }
    const auto outer = static_cast<double>(light.outer_cone);
    const double half = std::acos(std::clamp(1 - aim.one_less_cosine, -1.0, 1.0));
    const double between = std::acos(std::clamp(glm::dot(dvec3(placed.direction), aim.axis), -1.0, 1.0));
    if (between > outer + half) {
        return 0;
    }
    return intensity * std::min(aim.solid_angle(), 2 * pi * (1 - std::cos(outer)));
}

CausticCause caustic_cause(const FrameScene& scene) {
    const auto throws = [&](const Instance& instance) { return throws_caustics(scene.material(instance)); };
    if (std::ranges::none_of(scene.instances, throws)) {
        return CausticCause::nothing_specular;
    }
    const auto emits = [&](const Instance& instance) { return gives_light(scene.material(instance)); };
    const auto arrives = [&](const LightInstance& light) { return flux_towards(light, scene.bounds) > 0; };
    const auto shines = [](const SkyInstance& sky) { return glm::length(sky.scale()) > 0; };
    const bool lit = (scene.sky && shines(*scene.sky)) || std::ranges::any_of(scene.lights, arrives) ||
                     std::ranges::any_of(scene.instances, emits);
    return lit ? CausticCause::found : CausticCause::no_light;
}

}  // namespace lanthorn::gi
