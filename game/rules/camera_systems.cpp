// The camera behind the player: never in a wall, since a ball that is moved back from her head says how far
// it gets.
#include <algorithm>
#include <cmath>

#include "game/rules/place_now.h"
#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/core/turns.h"

namespace lanthorn::game {

namespace {

constexpr double kRadius = 0.16;  // metres: no wall is nearer to the camera, well beyond its near plane
constexpr double kSkin = 0.02;    // metres between the ball and what it has met
constexpr double kRise = 0.3;     // metres that it is higher where there is no room behind her
constexpr double kEase = 0.07;    // of the way out again that a step takes

// The room around the player's head.
class Room {
  public:
    using Cloths = Query<Read<Cloth>, Read<WorldTransform>>;
    Room(const physics::Physics& physics, Entity player, const Cloths& cloths)
        : physics_(physics), player_(player), cloths_(cloths) {}

    // Of `wanted` metres along a unit vector, how many are free.
    double free(const dvec3& from, const dvec3& along, double wanted) const {
        if (wanted <= 0) {
            return 0;
        }
        const double share =
            physics_.sweep_sphere(from, from + along * wanted, kRadius, std::span(&player_, 1)).share;
        return share < 1 ? std::max(share * wanted - kSkin, 0.0) : wanted;
    }
    // The same, and nothing hangs before what is seen, unless she stands in it herself.
    double clear(const dvec3& from, const dvec3& along, double wanted) const {
        constexpr double kInIt = 0.6;  // metres
        double clear = free(from, along, wanted);
        cloths_.each([&](const Cloth& cloth, const WorldTransform& world) {
            const dmat4 to_cloth = glm::inverse(world.matrix);
            const double before = wanted * share_before(cloth, dvec3(to_cloth * dvec4(from, 1)),
                                                        dvec3(to_cloth * dvec4(from + along * wanted, 1)));
            if (before > kInIt) {
                clear = std::min(clear, before < wanted ? before - kRadius : wanted);
            }
        });
        return clear;
    }

  private:
    const physics::Physics& physics_;
    Entity player_;
    const Cloths& cloths_;
};

double eased(double now, double wanted) {
    return std::abs(wanted - now) < kSkin / 4 ? wanted : now + kEase * (wanted - now);
}

struct Axes {
    dvec3 right, behind;
};

// The shoulder over which it sees from furthest behind; another than before only where it gains much.
double best_side(const Room& room, const FollowCamera& camera, const dvec3& head, const Axes& axes) {
    constexpr double kGain = 0.4;  // metres
    const auto back = [&](double side) {
        const dvec3 along = side < 0 ? -axes.right : axes.right;
        const double aside = room.free(head, along, std::abs(side) * camera.aside);
        return room.clear(head + along * aside, axes.behind, camera.distance);
    };
    double best = camera.side, most = back(camera.side);
    for (const double side : {1.0, -1.0, 0.0}) {
        const double there = back(side);
        if (there > most + kGain || (side == 1 && there == camera.distance)) {
            best = side;
            most = there;
        }
    }
    return best;
}

dvec3 behind_her(const Room& room, FollowCamera& camera, const dvec3& eye, const Axes& axes) {
    // The nearer it is the higher, to look over her hat.
    const double near = 1 - std::min(camera.back / std::max(camera.distance, 1e-3), 1.0);
    const dvec3 up(0, 1, 0);
    const dvec3 head = eye + up * room.free(eye, up, camera.above + kRise * near);
    camera.side = best_side(room, camera, head, axes);
    const double wanted = eased(camera.beside, camera.side * camera.aside);
    const dvec3 along = wanted < 0 ? -axes.right : axes.right;
    const double aside = room.free(head, along, std::abs(wanted));
    camera.beside = std::copysign(aside, wanted);
    const dvec3 shoulder = head + along * aside;
    camera.back =
        std::min(room.clear(shoulder, axes.behind, camera.distance), eased(camera.back, camera.distance));
    return shoulder + axes.behind * camera.back;
}

}  // namespace

void follow_with_camera(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Eyes>> eyes,
                        Query<Read<Cloth>, Read<WorldTransform>> cloths,
                        Query<Mut<FollowCamera>, Mut<LocalTransform>> cameras, Places places) {
    Entity seeing;
    Eyes look;
    eyes.each([&](Entity e, const Eyes& found) {
        seeing = e;
        look = found;
    });
    if (!seeing) {
        return;
    }
    const dvec3 eye(place_now(places, seeing)[3]);
    const quat rotation = quat(about_y(look.yaw)) * quat(about_x(look.pitch));
    const Room room(**physics, intent->player, cloths);
    cameras.each([&](ecs::MutRef<FollowCamera> state, ecs::MutRef<LocalTransform> local) {
        FollowCamera camera = *state;
        camera.first_person = camera.first_person != ((intent->pressed & kView) != 0);
        Transform at;
        at.rotation = rotation;
        if (camera.first_person) {
            camera.beside = camera.back = 0;
            at.translation = eye + look.facing() * room.free(eye, look.facing(), camera.ahead);
        } else {
            const Axes axes = {glm::cross(look.facing(), dvec3(0, 1, 0)),
                               glm::dquat(rotation) * dvec3(0, 0, 1)};
            at.translation = behind_her(room, camera, eye, axes);
        }
        if (camera != *state) {
            state.write() = camera;
        }
        if (local->value != at) {
            local.write().value = at;
        }
    });
}

}  // namespace lanthorn::game
