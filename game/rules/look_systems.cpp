#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "game/rules/systems.h"
#include "lanthorn/core/turns.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::game {

namespace {

constexpr double kGone = 0.3, kWhole = 0.66;  // metres from her eyes, at which nothing and all of her is seen
constexpr float kFadeSeconds = 0.25;
constexpr float kFaint = 0.25f;  // share that is seen of what hides her
constexpr double kLargest = 4;   // metres: walls do not fade, lest the picture looks out of the room

// Of her, by which is judged whether she is hidden: metres below her eyes.
constexpr std::array kSeenBy = {0.0, 0.4, 0.8};
constexpr int kHidden = 2;          // of these
constexpr double kAroundHer = 0.3;  // metres
constexpr double kDown = 0.38;  // radians that the camera looks further down where it has no way back at all

struct Seat {
    dvec3 camera{0}, eye{0};
};

// What is met on the way to most of kSeenBy; none: she is seen.
std::vector<Entity> before_her(const physics::Physics& physics, Entity player, const Seat& seat) {
    std::vector<Entity> met;
    for (const double below : kSeenBy) {
        const dvec3 way = seat.eye - dvec3(0, below, 0) - seat.camera;
        if (const auto hit = physics.cast_ray(seat.camera, way, glm::length(way) - kAroundHer, player)) {
            met.push_back(hit->entity);
        }
    }
    if (met.size() < kHidden) {
        met.clear();
    }
    return met;
}

// Whether one of the thing's meshes in `scene` is too large to fade.
bool is_large(const FrameScene& scene, Entity e) {
    const auto first = std::ranges::lower_bound(scene.instances, e.index, {}, &Instance::id);
    const auto last = std::ranges::upper_bound(scene.instances, e.index, {}, &Instance::id);
    return std::any_of(first, last,
                       [](const Instance& instance) { return instance.bounds.diagonal() > kLargest; });
}

}  // namespace

float shown_from(double metres) {
    const auto t = static_cast<float>(std::clamp((metres - kGone) / (kWhole - kGone), 0.0, 1.0));
    return t * t * (3 - 2 * t);
}

float faded(float now, float wanted, double seconds) {
    if (seconds < 0 || seconds > kFadeSeconds) {
        return wanted;
    }
    const float step = static_cast<float>(seconds) / kFadeSeconds;
    return wanted < now ? std::max(wanted, now - step) : std::min(wanted, now + step);
}

void show_looks(Res<Intent> intent, Res<SharedPhysics> physics, Res<View> view, Res<Time> time,
                Res<FrameScene> before, Query<Read<FollowCamera>, Read<WorldTransform>> cameras,
                Query<Read<Eyes>, Read<WorldTransform>> eyes, Query<ecs::With<MeshInstances>> shapes,
                Hierarchy above, ResMut<Fading> fading, ResMut<render::Looks> looks) {
    Seat seat;
    bool follows = false;
    eyes.each([&](const Eyes&, const WorldTransform& at) { seat.eye = dvec3(at.matrix[3]); });
    cameras.each([&](const FollowCamera& camera, const WorldTransform& at) {
        seat.camera = dvec3(at.matrix[3]);
        follows = !camera.first_person && !view->placed;
    });
    const float hers = follows ? shown_from(glm::distance(seat.camera, seat.eye)) : 1;
    const std::vector<Entity> hiding =
        follows ? before_her(**physics, intent->player, seat) : std::vector<Entity>();
    const double seconds = time->moment - fading->moment;
    fading->moment = time->moment;

    std::vector<render::Look> found;
    for (const Entity e : shapes.entities()) {
        bool is_figure = false, is_hers = false, hides = false;
        // Where a skinned mesh is its joints say.
        const SkinInstance* skin = above.try_get<SkinInstance>(e);
        for (Entity up = skin != nullptr && !skin->joints.empty() ? skin->joints.front() : e; up;) {
            is_figure = is_figure || above.try_get<Figure>(up) != nullptr;
            is_hers = is_hers || up == intent->player;
            hides = hides || std::ranges::find(hiding, up) != hiding.end();
            const Parent* parent = above.try_get<Parent>(up);
            up = parent != nullptr ? parent->entity : ecs::kNullEntity;
        }
        const float wanted = is_hers && is_figure ? hers : hides && !is_large(*before, e) ? kFaint : 1;
        const auto now = fading->shown.find(e);
        const float shown = faded(now != fading->shown.end() ? now->second : 1, wanted, seconds);
        if (shown < 1) {
            fading->shown[e] = shown;
        } else {
            fading->shown.erase(e);
        }
        if (is_figure || shown < 1) {
            found.push_back({e.index, shown, is_figure});
        }
    }
    std::ranges::sort(found, {}, &render::Look::id);
    if (found != looks->looks) {
        looks->looks = std::move(found);
    }
}

void look_down_on_her(Query<Read<FollowCamera>, Write<Interpolated>, Mut<LocalTransform>> cameras) {
    cameras.each([](const FollowCamera& camera, Interpolated& pose, ecs::MutRef<LocalTransform> local) {
        const double near = 1 - std::min(camera.back / std::max(camera.distance, 1e-3), 1.0);
        if (camera.first_person || near <= 0 || !pose.started) {
            return;
        }
        // As what lies between two steps is shown: the next step takes it back.
        pose.shown.rotation = quat(glm::dquat(local->value.rotation) * about_x(-kDown * near * near));
        pose.between = true;
        local.write().value = pose.shown;
    });
}

}  // namespace lanthorn::game
