#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

// Two legs, 1.8 m wide and 7 m long, meet in a corner square: the lit one runs along -z from it, the dark one
// along -x. What the camera sees of the dark leg is lit by what the corner reflects.
SceneData corridor() {
    constexpr double kWide = 1.8, kLong = 7, kHeight = 2.5, t = kWallThickness;
    Builder b;
    const std::uint32_t white = b.matte("white", {0.74f, 0.73f, 0.7f});
    const std::uint32_t tiles = b.matte("tiles", {0.45f, 0.42f, 0.4f});
    const std::uint32_t ochre = b.matte("ochre", {0.65f, 0.5f, 0.25f});
    const std::uint32_t red = b.matte("red", {0.6f, 0.15f, 0.12f});
    const std::uint32_t blue = b.matte("blue", {0.15f, 0.25f, 0.55f});
    const std::uint32_t crate = b.matte("crate", {0.5f, 0.34f, 0.19f});

    const auto slab = [&](const std::string& name, double low, double high, std::uint32_t material) {
        b.solid("dark-" + name, box({-kLong - t, low, -t}, {kWide + t, high, kWide + t}), material);
        b.solid("lit-" + name, box({-t, low, -kLong - t}, {kWide + t, high, -t}), material);
    };
    slab("floor", -t, 0, tiles);
    slab("ceiling", kHeight, kHeight + t, white);
    b.solid("outer-wall", box({-kLong - t, 0, kWide}, {kWide + t, kHeight, kWide + t}), white);
    b.solid("facing-wall", box({kWide, 0, -kLong - t}, {kWide + t, kHeight, kWide}), ochre);
    b.solid("dark-end", box({-kLong - t, 0, -t}, {-kLong, kHeight, kWide}), blue);
    b.solid("dark-wall", box({-kLong, 0, -t}, {0, kHeight, 0}), white);
    b.solid("lit-wall", box({-t, 0, -kLong}, {0, kHeight, -t}), white);
    b.solid("lit-end", box({-t, 0, -kLong - t}, {kWide, kHeight, -kLong}), red);

    struct Crate {
        const char* name;
        dvec3 place;  // of the middle of its bottom
        dvec3 size;
        double turn;  // degrees about +Y
        std::uint32_t material;
    };
    for (const Crate& c : {Crate{"crate-1", {-2.1, 0, 1.35}, {0.6, 0.5, 0.6}, 12, crate},
                           Crate{"crate-2", {-2.05, 0.5, 1.4}, {0.4, 0.4, 0.4}, -20, crate},
                           Crate{"crate-3", {-3.9, 0, 0.35}, {0.5, 0.8, 0.4}, 5, red},
                           Crate{"crate-4", {-4.9, 0, 1.45}, {0.9, 0.35, 0.45}, 0, white},
                           Crate{"crate-5", {-0.35, 0, 0.4}, {0.3, 1.1, 0.3}, 30, blue},
                           Crate{"crate-6", {1.3, 0, -1.6}, {0.7, 0.7, 0.6}, -8, crate},
                           Crate{"crate-7", {0.4, 0, -5.0}, {0.5, 0.9, 0.5}, 16, ochre}}) {
        Transform place = at(c.place);
        place.rotation = quat(glm::angleAxis(glm::radians(c.turn), dvec3(0, 1, 0)));
        const dvec3 half(0.5 * c.size.x, 0, 0.5 * c.size.z);
        b.solid(c.name, box(-half, {half.x, c.size.y, half.z}), c.material, {}, place);
    }

    Light lamp;
    lamp.type = LightType::point;
    lamp.colour = {1, 0.9f, 0.75f};
    lamp.intensity = 500;
    b.light("lamp", at({0.9, 2.2, -3.2}), lamp);

    b.camera("camera", looking({-6.6, 1.6, 1.1}, {0.4, 1.0, 0.8}), glm::radians(60.0f));
    b.camera("lit", looking({0.5, 1.6, 1.5}, {1.1, 1.0, -5}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
