// A hall with columns and any number of lamps under its ceiling, which together are as bright as one: for
// what direct light of many lamps costs.
#include <cmath>
#include <numbers>
#include <string>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace lamp_hall_parts {

constexpr double kHalf = 20, kHeight = 7;  // metres
constexpr double kAllCandela = 20'000;     // of all lamps

void add_hall(Builder& b) {
    const std::uint32_t white = b.matte("plaster", vec3(0.7f));
    const std::uint32_t floor = b.matte("boards", {0.5f, 0.4f, 0.3f});
    const std::uint32_t red = b.matte("red", {0.6f, 0.15f, 0.1f});
    const std::uint32_t stone = b.matte("stone", vec3(0.55f));
    closed_room(b, {-kHalf, 0, -kHalf}, {kHalf, kHeight, kHalf},
                {.floor = {"floor", floor},
                 .ceiling = {"ceiling", white},
                 .left = {"left-wall", red},
                 .right = {"right-wall", white},
                 .back = {"back-wall", white},
                 .front = {"front-wall", white}},
                0.3);
    const std::uint32_t column = b.mesh("column", cylinder(0.5, kHeight, 24), stone);
    const std::uint32_t block = b.mesh("block", box({-0.8, 0, -0.8}, {0.8, 1.2, 0.8}), red);
    for (int i = 0; i < 16; ++i) {
        const dvec3 place(-15 + 10 * (i % 4), 0, -15 + 10 * (i / 4));
        const std::uint32_t pillar = b.node("column-" + std::to_string(i), at(place));
        b.scene.nodes[pillar].meshes = {column};
        const std::uint32_t low = b.node("block-" + std::to_string(i), at(place + dvec3(3.5, 0, 2)));
        b.scene.nodes[low].meshes = {block};
    }
}

}  // namespace lamp_hall_parts

SceneData lamp_hall(int count, LampKind kind) {
    using namespace lamp_hall_parts;
    Builder b;
    add_hall(b);
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    const double apart = 2 * kHalf / side;
    for (int i = 0; i < count; ++i) {
        const auto random = [&](std::uint64_t k) {
            return uniform(7, 4 * static_cast<std::uint64_t>(i) + k);
        };
        const dvec3 place(-kHalf + apart * (i % side + 0.2 + 0.6 * random(0)), 3.5 + 2.5 * random(2),
                          -kHalf + apart * (i / side + 0.2 + 0.6 * random(1)));
        Light lamp;
        lamp.intensity = static_cast<float>(kAllCandela / count);
        lamp.colour = vec3(1, 0.75 + 0.2 * random(3), 0.6);
        if (kind == LampKind::in_range) {
            lamp.range = static_cast<float>(5 + 2 * apart);
        }
        const std::string name = "lamp-" + std::to_string(i);
        if (kind == LampKind::spot) {
            lamp.type = LightType::spot;
            lamp.inner_cone = 0.3f;
            lamp.outer_cone = 0.6f;
            const double turn = 2 * std::numbers::pi * random(3);
            b.light(name, looking(place, place + dvec3(0.3 * std::cos(turn), -1, 0.3 * std::sin(turn))),
                    lamp);
        } else {
            b.light(name, at(place), lamp);
        }
    }
    b.camera("camera", looking({-18, 2.2, 18}, {4, 1.5, -6}), 1.0f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
