#include "game/screens/hud.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "game/rules/components.h"
#include "game/rules/systems.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::game {

namespace {

constexpr float kDepth = 100;  // metres; only where things are in the picture matters

// From the world to places in the picture.
class Eye {
  public:
    Eye(const ecs::World& world, float aspect) {
        const ecs::Entity camera = world.resource<View>().camera;
        const CameraComponent* lens = camera ? world.try_get<CameraComponent>(camera) : nullptr;
        if (lens == nullptr) {
            return;
        }
        const dmat4& at = world.get<WorldTransform>(camera).matrix;
        origin_ = dvec3(at[3]);
        Camera seen = lens->camera;
        seen.y_fov = world.resource<View>().y_fov.value_or(seen.y_fov);
        to_picture_ = projection_matrix(seen, aspect, kDepth) * camera_view(seen, at, origin_).view;
    }

    // Of what is before the camera; it may be beside the picture.
    std::optional<vec2> place(const dvec3& point) const {
        const vec4 clip = to_picture_ * vec4(vec3(point - origin_), 1);
        if (clip.w <= 0) {
            return std::nullopt;
        }
        return 0.5f + vec2(0.5f, -0.5f) * vec2(clip) / clip.w;
    }
    double distance(const dvec3& point) const { return glm::distance(point, origin_); }
    const dvec3& origin() const { return origin_; }

  private:
    dvec3 origin_{0};
    mat4 to_picture_{0};  // without a camera nothing is in the picture
};

class Labels {
  public:
    Labels(const ecs::World& world, const Eye& eye)
        : eye_(eye), intent_(world.resource<Intent>()), physics_(*world.resource<SharedPhysics>()) {}

    // The middle of what has a body, else its origin: what Intent::in_reach is asked of.
    dvec3 middle(ecs::Entity e, const WorldTransform& at) const {
        return physics_.centre(e).value_or(dvec3(at.matrix[3]));
    }
    void add_near(const dvec3& at, Action action, const char* words) {
        const std::optional<vec2> place = intent_.in_reach(at) ? eye_.place(at) : std::nullopt;
        if (place) {
            found_.push_back({eye_.distance(at), {glm::clamp(*place, 0.0f, 1.0f), action, words}});
        }
    }
    // Whether she faces along that way, to and fro: what is beside her cannot be pushed.
    bool faces_along(const dvec3& way) const {
        constexpr double kAlong = 0.6;
        const double length = glm::length(way);
        return length > 0 && std::abs(glm::dot(way, intent_.facing)) > kAlong * length;
    }
    std::vector<HudLabel> take() {
        std::ranges::stable_sort(found_, {}, &Found::distance);
        std::vector<HudLabel> labels;
        for (Found& each : found_) {
            labels.push_back(std::move(each.label));
        }
        return labels;
    }

  private:
    struct Found {
        double distance;
        HudLabel label;
    };
    const Eye& eye_;
    const Intent& intent_;
    const physics::Physics& physics_;
    std::vector<Found> found_;
};

constexpr double kPuppet = 0.8;  // metres above a follower's feet, where its words stand

std::vector<HudLabel> labels_of(const ecs::World& world, const Eye& eye) {
    Labels labels(world, eye);
    world.query<ecs::Read<Door>, ecs::Read<WorldTransform>>().each([&](ecs::Entity e, const Door& door,
                                                                       const WorldTransform& at) {
        labels.add_near(labels.middle(e, at), Action::use, door.open ? "close the door" : "open the door");
    });
    world.query<ecs::Read<Shutter>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const Shutter& shutter, const WorldTransform& at) {
            labels.add_near(labels.middle(e, at), Action::use,
                            shutter.open ? "shut the shutter" : "open the shutter");
        });
    world.query<ecs::With<Turntable>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const WorldTransform& at) {
            labels.add_near(labels.middle(e, at), Action::use, "turn it (hold)");
        });
    world.query<ecs::Read<Pushed>, ecs::Read<LocalTransform>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const Pushed& pushed, const LocalTransform& local, const WorldTransform& at) {
            const dmat4 from_parent = at.matrix * glm::inverse(local.value.matrix());
            if (labels.faces_along(glm::dmat3(from_parent) * pushed.rail)) {
                labels.add_near(labels.middle(e, at), Action::forward, "push it");
            }
        });
    world.query<ecs::Read<Lantern>, ecs::Read<WorldTransform>>().each(
        [&](const Lantern& lantern, const WorldTransform& at) {
            const dvec3 place = dvec3(at.matrix[3]);
            if (!lantern.carried) {
                labels.add_near(place, Action::carry, "take the lantern");
                labels.add_near(place, Action::light, lantern.lit ? "put it out" : "light it");
            }
        });
    world.query<ecs::Read<Heeds>, ecs::Read<WorldTransform>>().each(
        [&](const Heeds& heeds, const WorldTransform& at) {
            labels.add_near(dvec3(at.matrix[3]) + dvec3(0, kPuppet, 0), Action::use,
                            heeds.waits ? "come along" : "wait here");
        });
    return labels.take();
}

// Crystals that nothing stands before.
std::vector<HudMark> marks_of(const ecs::World& world, const Eye& eye) {
    constexpr double kSize = 0.4;  // metres: a crystal's own body is not in its way
    const physics::Physics& physics = *world.resource<SharedPhysics>();
    const ecs::Entity player = world.resource<Intent>().player;
    std::vector<HudMark> marks;
    world.query<ecs::Read<Crystal>, ecs::Read<WorldTransform>>().each(
        [&](const Crystal& crystal, const WorldTransform& at) {
            const dvec3 centre(at.matrix[3]);
            const std::optional<vec2> place = eye.place(centre);
            const double distance = eye.distance(centre);
            if (!place || *place != glm::clamp(*place, 0.0f, 1.0f)) {
                return;
            }
            const dvec3 way = (centre - eye.origin()) / std::max(distance, 1e-6);
            const auto met = physics.cast_ray(eye.origin(), way, distance, player);
            if (!met || met->distance > distance - kSize) {
                marks.push_back({*place, static_cast<float>(distance), crystal.symbol,
                                 static_cast<float>(crystal.charge), crystal.awake});
            }
        });
    return marks;
}

}  // namespace

Hud look_about(const ecs::World& world, float aspect) {
    const Eye eye(world, aspect);
    Hud hud{.labels = labels_of(world, eye), .marks = marks_of(world, eye)};
    world.query<ecs::Read<Lantern>>().each([&](const Lantern& lantern) {
        if (lantern.carried) {
            hud.carries = true;
            hud.lit = lantern.lit;
            hud.glasses = static_cast<int>(lantern.slides.size());
        }
    });
    return hud;
}

}  // namespace lanthorn::game
