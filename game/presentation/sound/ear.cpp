#include "game/presentation/sound/ear.h"

#include <algorithm>
#include <cmath>

#include "lanthorn/audio/sound_source.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/time.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::game {

namespace {

constexpr double kMostAFrame = 1;  // metres: farther, she was not walking

dvec3 place_of(const WorldTransform& at) {
    return dvec3(at.matrix[3]);
}

// Calls `hear(e, before, now, at)` for every entity with a T that had one at the call before too, and keeps
// it.
template <class T, class Hear>
void compare(const ecs::World& world, std::map<ecs::Entity, T>& before, Hear hear) {
    world.query<ecs::Read<T>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const T& now, const WorldTransform& at) {
            const auto [found, fresh] = before.try_emplace(e, now);
            if (!fresh) {
                hear(e, found->second, now, place_of(at));
                found->second = now;
            }
        });
}

}  // namespace

Heard Ear::listen(const ecs::World& world) {
    Heard heard;
    const std::uint64_t steps = world.resource<Time>().steps;
    if (began_ && steps == steps_) {
        heard.going = going_;
    } else {
        hear_steps(world, heard);
        hear_leaves(world, heard);
        hear_lanterns(world, heard);
        hear_crystals(world, heard);
        steps_ = steps;
        began_ = true;
        going_ = heard.going;
    }
    heard.ears = audio::ears_of(world);
    return heard;
}

void Ear::hear_steps(const ecs::World& world, Heard& heard) {
    world.query<ecs::With<Player>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const WorldTransform& at) {
            const dvec3 now = place_of(at);
            const auto [found, fresh] = feet_.try_emplace(e, now);
            const dvec3 way = now - found->second;
            found->second = now;
            const double distance = std::hypot(way.x, way.z);
            if (fresh || distance > kMostAFrame) {
                return;
            }
            walked_ = distance > 0 ? walked_ + distance : 0.5 * kStride;  // who starts steps soon
            if (walked_ >= kStride) {
                walked_ = std::fmod(walked_, kStride);
                left_ = !left_;
                heard.begun.push_back(
                    {.kind = left_ ? SoundKind::step_left : SoundKind::step_right, .place = now, .of = e});
            }
        });
}

void Ear::hear_leaves(const ecs::World& world, Heard& heard) {
    compare(world, doors_, [&](ecs::Entity e, const Door& before, const Door& now, const dvec3& at) {
        if (now.angle != before.angle) {
            const double speed = std::min(std::abs(now.speed), 2.0);
            heard.going.push_back({.kind = SoundKind::door_moves,
                                   .place = at,
                                   .gain = static_cast<float>(0.25 + 0.35 * speed),
                                   .pitch = static_cast<float>(0.85 + 0.2 * speed),
                                   .of = e});
            if (now.angle == 0) {
                heard.begun.push_back({.kind = SoundKind::door_shut, .place = at, .of = e});
            }
        }
    });
    compare(world, shutters_, [&](ecs::Entity e, const Shutter& before, const Shutter& now, const dvec3& at) {
        if (now.share == before.share) {
            return;
        }
        if (now.share == 0 || now.share == 1) {
            heard.begun.push_back({.kind = SoundKind::shutter_stops, .place = at, .of = e});
        } else {
            heard.going.push_back({.kind = SoundKind::shutter_slides, .place = at, .of = e});
        }
    });
    compare(world, pushed_, [&](ecs::Entity e, const Pushed& before, const Pushed& now, const dvec3& at) {
        if (now.share != before.share) {
            heard.going.push_back({.kind = SoundKind::pushed, .place = at, .of = e});
        }
    });
    compare(world, turntables_,
            [&](ecs::Entity e, const Turntable& before, const Turntable& now, const dvec3& at) {
                if (now.angle != before.angle) {
                    heard.going.push_back({.kind = SoundKind::turned, .place = at, .of = e});
                }
            });
}

void Ear::hear_lanterns(const ecs::World& world, Heard& heard) {
    compare(world, lanterns_, [&](ecs::Entity e, const Lantern& before, const Lantern& now, const dvec3& at) {
        const auto begin = [&](bool holds, SoundKind::Name kind) {
            if (holds) {
                heard.begun.push_back({.kind = kind, .place = at, .of = e});
            }
        };
        begin(now.carried && !before.carried, SoundKind::take);
        begin(!now.carried && before.carried, SoundKind::put_down);
        begin(now.lit && !before.lit, SoundKind::lantern_on);
        begin(!now.lit && before.lit, SoundKind::lantern_off);
        begin(now.brightness > before.brightness, SoundKind::brighter);
        begin(now.brightness < before.brightness, SoundKind::darker);
        begin(now.slide != before.slide, SoundKind::glass);
    });
}

void Ear::hear_crystals(const ecs::World& world, Heard& heard) {
    compare(world, crystals_, [&](ecs::Entity e, const Crystal& before, const Crystal& now, const dvec3& at) {
        if (now.awake && !before.awake) {
            heard.begun.push_back({.kind = SoundKind::crystal_wakes, .place = at, .of = e});
        } else if (!now.awake && now.charge > before.charge) {
            // A fifth higher when it is full.
            heard.going.push_back({.kind = SoundKind::crystal_charges,
                                   .place = at,
                                   .gain = static_cast<float>(0.2 + 0.8 * now.charge),
                                   .pitch = static_cast<float>(1 + 0.5 * now.charge),
                                   .of = e});
        }
    });
    const bool now = solved(world);
    if (began_ && now && !solved_) {
        heard.begun.push_back({.kind = SoundKind::solved, .placed = false});
    }
    solved_ = now;
}

}  // namespace lanthorn::game
