#include "game/rules/flames.h"

#include <algorithm>
#include <cmath>

#include "game/rules/systems.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/runtime/time.h"

namespace lanthorn::game {

namespace {

// Of a glow, for each candela of its light: some thousandth of what a flame has, so that its hue is seen.
constexpr float kFlameNits = 1.2f;
constexpr double kSlender = 0.42;                      // its width by its height
constexpr double kQuickCourse = 9, kSlowCourse = 2.3;  // 1/s: how often it takes another course
constexpr double kLean = 0.16;                         // of its height, that the tip goes aside
constexpr double kGrowth = 0.1;                        // of its height, that it grows and shrinks

// -1..1, of number `i` of stream `key`: SplitMix64's finaliser (Steele et al. 2014).
double number(std::uint64_t key, std::int64_t i) {
    std::uint64_t z = (key + 1) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(i) * 0xd1b54a32d192ed03u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

// -1..1, smooth in time.
double waver(std::uint64_t key, double time) {
    const double whole = std::floor(time), t = time - whole;
    const auto i = static_cast<std::int64_t>(whole);
    return glm::mix(number(key, i), number(key, i + 1), t * t * (3 - 2 * t));
}

// Quick on top of slow.
double course(std::uint64_t key, double seconds) {
    return 0.6 * waver(2 * key, kQuickCourse * seconds) + 0.4 * waver(2 * key + 1, kSlowCourse * seconds);
}

}  // namespace

render::Glow still_flame(const Flame& flame, const Light& light, const dvec3& place) {
    const dvec3 half(0, 0.5 * flame.height, 0);
    return {place - half, place + half, static_cast<float>(kSlender * flame.height),
            kFlameNits * light.intensity * light.colour};
}

render::Glow flame_at(const Flame& flame, const Light& light, const dvec3& place, std::uint64_t seed,
                      double seconds) {
    render::Glow glow = still_flame(flame, light, place);
    const std::uint64_t key = 4 * seed;
    const double taller = course(key, seconds);
    glow.tip.y += kGrowth * taller * flame.height;
    glow.tip.x += kLean * course(key + 1, seconds) * flame.height;
    glow.tip.z += kLean * course(key + 2, seconds) * flame.height;
    glow.width *= static_cast<float>(1 - 0.5 * kGrowth * taller);
    glow.nits *= static_cast<float>(1 + flame.flicker * course(key + 3, seconds));
    return glow;
}

void declare_flames(ecs::Registry& registry) {
    registry.component<Flame>(
        "flame", "what is seen of a flame around its node's light, while that shines",
        ecs::field("height", &Flame::height).unit("m").more_than(0, 2).words("as it stands still"),
        ecs::field("flicker", &Flame::flicker).range(0, 1).words("of its brightness, that it wavers by"));
}

void show_flames(Query<Read<Flame>, Read<LightComponent>, Read<WorldTransform>> flames, Res<Time> time,
                 Res<Flicker> flicker, ResMut<render::Glows> shown) {
    shown->glows.clear();
    flames.each([&](Entity e, const Flame& flame, const LightComponent& light, const WorldTransform& at) {
        const dvec3 place(at.matrix[3]);
        shown->glows.push_back(
            flicker->on ? flame_at(flame, light.light, place, e.index, time->moment + flicker->ahead)
                        : still_flame(flame, light.light, place));
    });
}

}  // namespace lanthorn::game
