#include <cstdint>
#include <numbers>

#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

// A rotation uniform over all (Shoemake 1992).
quat random_rotation(double u, double v, double w) {
    const double a = std::sqrt(1 - u), b = std::sqrt(u), pi2 = 2 * std::numbers::pi;
    return quat(glm::dquat(b * std::cos(pi2 * w), a * std::sin(pi2 * v), a * std::cos(pi2 * v),
                           b * std::sin(pi2 * w)));
}

}  // namespace

SceneData clutter() {
    constexpr std::uint64_t kSeed = 40;
    constexpr int kBoxes = 40;
    const dvec3 half(3, 2, 3);  // the room, centred on (0, 2, 0)

    Builder b;
    const std::uint32_t white = b.matte("white", vec3(0.72f));
    const std::uint32_t wall = b.matte("ochre", {0.65f, 0.5f, 0.25f});
    closed_room(b, {-half.x, 0, -half.z}, {half.x, 2 * half.y, half.z},
                {.floor = {"floor", white},
                 .ceiling = {"ceiling", white},
                 .left = {"left-wall", wall},
                 .right = {"right-wall", white},
                 .back = {"back-wall", white},
                 .front = {"front-wall", wall}});

    const vec3 palette[] = {{0.7f, 0.12f, 0.1f}, {0.12f, 0.5f, 0.15f}, {0.1f, 0.2f, 0.65f},
                            {0.7f, 0.6f, 0.12f}, {0.6f, 0.25f, 0.6f},  {0.15f, 0.55f, 0.6f},
                            {0.8f, 0.8f, 0.8f},  {0.2f, 0.2f, 0.2f}};
    std::vector<std::uint32_t> cubes;
    for (const vec3& colour : palette) {
        const std::string name = "cube-" + std::to_string(cubes.size());
        cubes.push_back(b.mesh(name, box(dvec3(-0.5), dvec3(0.5)), b.matte(name, colour)));
    }

    const dvec3 eye(-2.7, 3.2, 2.7);
    std::vector<dvec4> spheres = {{eye, 0.6}, {0.5, 3.8, 0.3, 0.5}};  // kept free: camera and lamp
    for (std::uint64_t attempt = 0; spheres.size() < kBoxes + 2; ++attempt) {
        const auto random = [&](std::uint64_t dimension) { return uniform(kSeed, 16 * attempt + dimension); };
        const auto between = [&](std::uint64_t d, double low, double high) {
            return low + (high - low) * random(d);
        };
        const dvec3 size(between(0, 0.15, 0.75), between(1, 0.15, 0.75), between(2, 0.15, 0.75));
        const double radius = 0.5 * glm::length(size);
        const dvec3 room = half - radius - 0.05;
        const dvec3 centre(between(3, -room.x, room.x), 2 + between(4, -room.y, room.y),
                           between(5, -room.z, room.z));
        bool free = true;
        for (const dvec4& other : spheres) {
            free = free && glm::distance(centre, dvec3(other)) > radius + other.w;
        }
        if (!free) {
            continue;
        }
        spheres.emplace_back(centre, radius);
        Transform place = at(centre);
        place.rotation = random_rotation(random(6), random(7), random(8));
        place.scale = vec3(size);
        const std::uint32_t node = b.node("box-" + std::to_string(spheres.size() - 2), place);
        b.scene.nodes[node].meshes = {cubes[static_cast<std::size_t>(8 * random(9))]};
    }

    Light lamp;
    lamp.type = LightType::spot;
    lamp.colour = {1, 0.95f, 0.85f};
    lamp.intensity = 900;
    lamp.inner_cone = glm::radians(40.0f);
    lamp.outer_cone = glm::radians(60.0f);
    b.light("lamp", looking({0.5, 3.8, 0.3}, {0.5, 0, 0.3}), lamp);
    b.camera("camera", looking(eye, {0.4, 1.6, -0.4}), glm::radians(65.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
