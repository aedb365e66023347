// What follows the player: straight on while it sees her, else in her footsteps; round what stands before it.
#include <algorithm>
#include <array>
#include <cmath>

#include "game/rules/headings.h"
#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::game {

namespace {

constexpr double kMiddle = 0.45;      // metres above the floor at which it feels its way
constexpr double kFootstep = 0.4;     // metres between two places of the trail
constexpr std::size_t kLongest = 64;  // places
constexpr double kFeels = 0.7;        // metres ahead
constexpr double kYields = 0.65;      // metres from the player at which it steps back
constexpr double kWishTakeUp = 0.1;   // of the difference to a new velocity that a step takes up

class Feet {
  public:
    Feet(const physics::Physics& physics, Entity player, double radius)
        : physics_(physics), player_(player), radius_(radius) {}

    // The share of the way that is free.
    double free(const dvec3& from, const dvec3& to) const {
        const dvec3 up(0, kMiddle, 0);
        return physics_.sweep_sphere(from + up, to + up, radius_, std::span(&player_, 1)).share;
    }
    // A way like `wish` that is free for a bit: the least turn from it, either side.
    dvec3 steer(const dvec3& from, const dvec3& wish) const {
        constexpr std::array<double, 7> kTurns = {0, 0.5, -0.5, 1, -1, 1.6, -1.6};  // radians
        for (const double turn : kTurns) {
            const dvec3 way = about_y(turn) * wish;
            if (free(from, from + kFeels * way) == 1) {
                return way;
            }
        }
        return wish;
    }
    // On the floor below `place`, or as high as it is.
    dvec3 on_floor(const dvec3& place) const {
        const auto floor = physics_.cast_ray(place + dvec3(0, kMiddle, 0), {0, -1, 0}, 2 * kMiddle, player_);
        return floor ? dvec3(place.x, floor->point.y, place.z) : place;
    }

  private:
    const physics::Physics& physics_;
    Entity player_;
    double radius_;
};

dvec3 level(dvec3 way) {
    way.y = 0;
    return way;
}

// Where to walk: to the player, or to the place of her trail nearest to her that is in sight.
dvec3 goal_of(Follower& follower, const dvec3& place, const dvec3& player, const Feet& feet) {
    std::vector<dvec3>& trail = follower.trail;
    if (feet.free(place, player) == 1) {
        trail.clear();
        return player;
    }
    if (trail.empty() || glm::distance(trail.back(), player) > kFootstep) {
        if (trail.size() == kLongest) {
            trail.erase(trail.begin());
        }
        trail.push_back(player);
    }
    for (std::size_t i = trail.size(); i-- > 0;) {
        if (glm::distance(place, trail[i]) < 0.3) {
            trail.erase(trail.begin(), trail.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            break;
        }
        if (feet.free(place, trail[i]) == 1) {
            return trail[i];
        }
    }
    return trail.empty() ? player : trail.front();
}

}  // namespace

void tell_followers(Res<Intent> intent, Query<Mut<Heeds>, Read<WorldTransform>> followers) {
    if ((intent->pressed & kUse) == 0) {
        return;
    }
    followers.each([&](ecs::MutRef<Heeds> state, const WorldTransform& world) {
        if (intent->in_reach(dvec3(world.matrix[3]))) {
            Heeds& heeds = state.write();
            heeds.waits = !heeds.waits;
        }
    });
}

void follow_player(Res<Intent> intent, Res<SharedPhysics> physics, ecs::Lookup<Read<Heeds>> heeds,
                   Query<Write<Follower>, Mut<LocalTransform>> followers) {
    if (!intent->player) {
        return;
    }
    followers.each([&](Entity e, Follower& follower, ecs::MutRef<LocalTransform> local) {
        const Heeds* told = heeds.try_get<Heeds>(e);
        const bool waits = told != nullptr && told->waits;
        const dvec3 place = local->value.translation;
        const Feet feet(**physics, intent->player, follower.radius);
        const dvec3 goal = goal_of(follower, place, intent->feet, feet);
        const double distance = glm::length(level(intent->feet - place));
        // Near is near in sight: a wall between them is a way round.
        const bool in_sight = follower.trail.empty();
        follower.follows = !in_sight || distance > (follower.follows ? follower.near : follower.far);

        dvec3 wish(0);
        const dvec3 way = level(goal - place);
        if (in_sight && distance < kYields && distance > 0) {
            wish = -level(intent->feet - place) / distance * (0.6 * follower.speed);
        } else if (follower.follows && !waits && glm::length(way) > 0.05) {
            wish = feet.steer(place, glm::normalize(way)) * follower.speed;
        }
        follower.velocity += kWishTakeUp * (wish - follower.velocity);
        if (wish == dvec3(0) && glm::length(follower.velocity) < 1e-2) {
            follower.velocity = dvec3(0);
            return;
        }
        const dvec3 step = kStepSeconds * follower.velocity;
        // It slides along what it meets: first one way, then the other.
        dvec3 to = place;
        for (const dvec3& part : {dvec3(step.x, 0, 0), dvec3(0, 0, step.z)}) {
            if (part != dvec3(0) && feet.free(to, to + part) == 1) {
                to += part;
            }
        }
        local.write().value.translation = feet.on_floor(to);
    });
}

// A puppet faces where it walks, and the player when it waits.
void face_followers(Res<Intent> intent, Query<Read<Follower>, Read<LocalTransform>> followers,
                    Query<Write<Figure>, Read<Parent>> figures) {
    figures.each([&](Figure& figure, const Parent& above) {
        followers.each([&](Entity e, const Follower& follower, const LocalTransform& local) {
            if (e != above.entity) {
                return;
            }
            const dvec3 way = level(intent->feet - local.value.translation);
            if (glm::length(follower.velocity) > 0.3) {
                figure.yaw = turned_towards(figure.yaw, heading_of(follower.velocity), 0.16, 0.13);
                figure.turning = false;
            } else if (glm::length(way) > 0.1) {
                const double to = heading_of(way);
                const double away = std::abs(turn_between(figure.yaw, to));
                if (figure.turning || away > 0.6) {
                    figure.yaw = turned_towards(figure.yaw, to, 0.12, 0.07);
                    figure.turning = away > 0.05;
                }
            }
        });
    });
}

}  // namespace lanthorn::game
