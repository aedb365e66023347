#include <string>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

// Its back on the plane z = `place.z`. Heights of the boards' upper sides.
std::vector<double> shelf(Builder& b, const std::string& name, const dvec3& place, const dvec3& size,
                          int levels, std::uint32_t material) {
    std::vector<double> heights;
    for (const Part& part : shelf_parts(size, levels, &heights)) {
        b.solid(name + '-' + part.name, box(place + part.low, place + part.high), material);
    }
    for (double& height : heights) {
        height += place.y;
    }
    return heights;
}

void chair(Builder& b, const std::string& name, const Transform& place, std::uint32_t material) {
    const std::uint32_t node = b.node(name, place);
    for (const Part& part : chair_parts()) {
        b.solid(name + '-' + part.name, box(part.low, part.high), material, {}, {}, node);
    }
}

}  // namespace

SceneData furnished() {
    constexpr double kHeight = 2.6;
    const dvec3 half(2.5, 0, 2);
    constexpr std::uint64_t kSeed = 7;

    Builder b;
    const std::uint32_t white = b.matte("white", {0.76f, 0.75f, 0.72f});
    const std::uint32_t floor = b.matte("floorboards", {0.48f, 0.36f, 0.25f});
    const std::uint32_t wall = b.matte("sage", {0.45f, 0.55f, 0.42f});
    const std::uint32_t wood = b.matte("wood", {0.52f, 0.36f, 0.2f});
    const std::uint32_t dark = b.matte("dark-wood", {0.22f, 0.13f, 0.08f});
    const std::uint32_t rug = b.matte("rug", {0.5f, 0.14f, 0.14f});

    closed_room(b, {-half.x, 0, -half.z}, {half.x, kHeight, half.z},
                {.floor = {"floor", floor},
                 .ceiling = {"ceiling", white},
                 .left = {"left-wall", wall},
                 .right = {"right-wall", white},
                 .back = {"back-wall", white},
                 .front = {"front-wall", white}});

    // Forty things on two shelves: ten boards, four things each.
    const vec3 palette[] = {{0.7f, 0.12f, 0.1f},   {0.12f, 0.5f, 0.15f}, {0.1f, 0.2f, 0.65f},
                            {0.75f, 0.62f, 0.15f}, {0.8f, 0.8f, 0.78f},  {0.15f, 0.5f, 0.55f}};
    std::vector<std::uint32_t> paints;
    for (const vec3& colour : palette) {
        paints.push_back(b.matte("paint-" + std::to_string(paints.size()), colour));
    }
    int things = 0;
    for (const double x : {-1.35, 0.05}) {
        const dvec3 size(1.2, 1.9, 0.32);
        const std::string name = x < 0 ? "left-shelf" : "right-shelf";
        for (const double y : shelf(b, name, {x, 0, -half.z}, size, 5, wood)) {
            for (int i = 0; i < 4; ++i) {
                const auto random = [&](std::uint64_t k) {
                    return uniform(kSeed, 8 * static_cast<std::uint64_t>(things) + k);
                };
                const double height = 0.08 + 0.18 * random(0), radius = 0.03 + 0.05 * random(1);
                const dvec3 place(x - 0.42 + 0.28 * i + 0.06 * (random(2) - 0.5), y,
                                  -half.z + 0.17 + 0.06 * (random(3) - 0.5));
                const std::uint32_t paint = paints[static_cast<std::size_t>(6 * random(4))];
                const std::string thing = "thing-" + std::to_string(++things);
                switch (static_cast<int>(3 * random(5))) {
                    case 0:
                        b.solid(thing, box({-radius, 0, -radius}, {radius, height, radius}), paint, {},
                                at(place));
                        break;
                    case 1:
                        b.solid(thing, cylinder(radius, height, 16), paint, {}, at(place));
                        break;
                    default:
                        b.solid(thing, icosphere(radius, 2), paint, {}, at(place + dvec3(0, radius, 0)));
                }
            }
        }
    }

    b.solid("rug", box({-0.4, 0, -0.7}, {2.0, 0.01, 1.3}), rug);
    b.table("table", {0.8, 0.01, 0.3}, 1.3, 0.8, 0.73, dark);
    const auto facing = [](const dvec3& place, double turn) {
        Transform result = at(place);
        result.rotation = quat(glm::angleAxis(glm::radians(turn), dvec3(0, 1, 0)));
        return result;
    };
    chair(b, "chair-1", facing({0.5, 0.01, 0.95}, 8), wood);
    chair(b, "chair-2", facing({1.15, 0.01, 0.9}, -6), wood);
    chair(b, "chair-3", facing({0.75, 0.01, -0.35}, 174), wood);
    chair(b, "chair-4", facing({-1.4, 0, 0.9}, -120), dark);
    b.solid("bowl", cylinder(0.12, 0.06, 24), paints[4], {}, at({0.7, 0.74, 0.3}));
    b.solid("bottle", cylinder(0.035, 0.28, 16), paints[1], {}, at({1.1, 0.74, 0.15}));
    b.solid("sideboard", box({2.1, 0, -1.6}, {2.5, 0.75, -0.2}), dark);
    b.solid("globe", icosphere(0.14, 2), paints[2], {}, at({2.3, 0.89, -0.6}));

    Light lamp;
    lamp.type = LightType::point;
    lamp.colour = {1, 0.88f, 0.7f};
    lamp.intensity = 250;
    b.light("lamp", at({0.9, 2.1, 0.5}), lamp);
    b.camera("camera", looking({-2.2, 1.6, 1.8}, {0.4, 0.8, -0.8}), glm::radians(62.0f));
    b.camera("shelves", looking({-0.9, 1.3, -0.1}, {-0.7, 0.95, -2}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
