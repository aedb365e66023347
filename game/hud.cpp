#include "game/hud.h"

#include <algorithm>
#include <optional>

#include "game/components.h"
#include "game/systems.h"
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
        to_picture_ =
            projection_matrix(lens->camera, aspect, kDepth) * camera_view(lens->camera, at, origin_).view;
    }

    std::optional<vec2> place(const dvec3& point) const {
        const vec4 clip = to_picture_ * vec4(vec3(point - origin_), 1);
        if (clip.w <= 0) {
            return std::nullopt;
        }
        const vec2 place = 0.5f + vec2(0.5f, -0.5f) * vec2(clip) / clip.w;
        const bool inside =
            glm::all(glm::greaterThan(place, vec2(0))) && glm::all(glm::lessThan(place, vec2(1)));
        return inside ? std::optional(place) : std::nullopt;
    }
    double distance(const dvec3& point) const { return glm::distance(point, origin_); }

  private:
    dvec3 origin_{0};
    mat4 to_picture_{0};  // without a camera nothing is in the picture
};

class Labels {
  public:
    explicit Labels(const Eye& eye) : eye_(eye) {}

    void add(const dvec3& at, Button button, const char* words) {
        if (const std::optional<vec2> place = eye_.place(at)) {
            found_.push_back({eye_.distance(at), {*place, button, words}});
        }
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
    std::vector<Found> found_;
};

void add_doors(const ecs::World& world, const Intent& intent, Labels& labels) {
    world.query<ecs::Read<Door>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const Door& door, const WorldTransform& at) {
            const dvec3 middle = world.resource<SharedPhysics>()->centre(e).value_or(dvec3(at.matrix[3]));
            if (intent.in_reach(middle)) {
                labels.add(middle, kUse, door.open ? "close the door" : "open the door");
            }
        });
}

void add_lanterns(const ecs::World& world, const Intent& intent, Labels& labels) {
    world.query<ecs::Read<Lantern>, ecs::Read<WorldTransform>>().each(
        [&](const Lantern& lantern, const WorldTransform& at) {
            const dvec3 place = dvec3(at.matrix[3]);
            if (!lantern.carried && intent.in_reach(place)) {
                const dvec3 handle = place + dvec3(0, lantern.handle, 0);
                labels.add(handle, kCarry, "take the lantern");
            }
        });
}

}  // namespace

Hud look_about(const ecs::World& world, float aspect) {
    const Eye eye(world, aspect);
    const Intent& intent = world.resource<Intent>();
    Labels labels(eye);
    add_doors(world, intent, labels);
    add_lanterns(world, intent, labels);
    return {labels.take()};
}

}  // namespace lanthorn::game
