#include <algorithm>

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace lantern_room_parts {

// Bricks of 16 x 8 texels with a mortar joint of one, each with its own shade; 64 texels are one metre.
Image brick_image() {
    constexpr std::uint32_t kSize = 64;
    Image image{"bricks", kSize, kSize, {}};
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::uint32_t row = y / 8;
            const std::uint32_t along = (x + (row % 2) * 8) % kSize;
            const bool mortar = y % 8 == 7 || along % 16 == 15;
            const std::uint32_t shade = (row * 7 + (along / 16) * 13) % 5 * 7;  // 0..28
            const std::uint8_t brick[] = {static_cast<std::uint8_t>(150 + shade),
                                          static_cast<std::uint8_t>(118 + shade),
                                          static_cast<std::uint8_t>(96 + shade)};
            for (int c = 0; c < 3; ++c) {
                image.rgba.push_back(mortar ? 196 : brick[c]);
            }
            image.rgba.push_back(255);
        }
    }
    return image;
}

std::uint32_t bricks(Builder& b) {
    b.scene.images.push_back(brick_image());
    b.scene.textures.push_back({static_cast<std::uint32_t>(b.scene.images.size() - 1), {}});
    const std::uint32_t material = b.matte("bricks", vec3(1));
    b.scene.materials[material].base_colour_texture.texture =
        static_cast<std::uint32_t>(b.scene.textures.size() - 1);
    return material;
}

constexpr double kHeight = 3.0, kEnd = 4.0, kSide = 3.0;  // of the room inside: 8 x 3 x 6 m
constexpr Doorway kDoorway{1.0, 2.1};

void shell(Builder& b, std::uint32_t brick) {
    constexpr double kThick = kWallThickness, kOuter = kEnd + kThick, kOuterSide = kSide + kThick;
    const std::uint32_t stone = b.matte("flagstones", {0.45f, 0.43f, 0.4f});
    const std::uint32_t plaster = b.matte("plaster", {0.78f, 0.75f, 0.68f});
    const std::uint32_t red = b.matte("red-plaster", {0.7f, 0.16f, 0.1f});
    b.solid("floor", box({-kOuter, -kThick, -kOuterSide}, {kOuter, 0, kOuterSide}), stone, kBoxCollider);
    b.solid("ceiling", box({-kOuter, kHeight, -kOuterSide}, {kOuter, kHeight + kThick, kOuterSide}), plaster,
            kBoxCollider);
    b.solid("red-wall", box({-kOuter, 0, -kSide}, {-kEnd, kHeight, kSide}), red, kBoxCollider);
    b.solid("lit-back", box({-kOuter, 0, -kOuterSide}, {0, kHeight, -kSide}), brick, kBoxCollider);
    b.solid("lit-front", box({-kOuter, 0, kSide}, {0, kHeight, kOuterSide}), plaster, kBoxCollider);
    b.solid("far-wall", box({kEnd, 0, -kSide}, {kOuter, kHeight, kSide}), plaster, kBoxCollider);
    b.solid("dark-back", box({0, 0, -kOuterSide}, {kOuter, kHeight, -kSide}), brick, kBoxCollider);
    b.solid("dark-front", box({0, 0, kSide}, {kOuter, kHeight, kOuterSide}), plaster, kBoxCollider);
    wall_with_doorway(b, "divider", 2 * kSide, kHeight, kDoorway, plaster, kBoxCollider);
}

constexpr double kOpenAngle = 1.9;  // radians; the extras of the door say the same

// The door's origin is its hinge: turned by a positive angle about +Y it opens into the dark half, clear of
// the jamb. Closed, it laps 4 mm into frame and floor, so that no light slips past.
void door(Builder& b, std::uint32_t wood) {
    constexpr double kLap = 0.004, kThick = 0.05;
    b.solid("door", box({-kThick, -kLap, -kLap}, {-0.001, kDoorway.height + kLap, kDoorway.width + kLap}),
            wood, R"({"door":{"open_angle":1.9},"body":{"type":"kinematic"}})",
            at({0.5 * kWallThickness, 0, -0.5 * kDoorway.width}));
}

void furniture(Builder& b, std::uint32_t wood) {
    const std::uint32_t crate = b.matte("crate", {0.55f, 0.38f, 0.2f});
    const std::uint32_t stone = b.matte("column", {0.6f, 0.6f, 0.58f});
    const std::uint32_t blue = b.matte("blue-crate", {0.16f, 0.25f, 0.5f});
    b.table("table", {-0.5, 0, 2.2}, 0.8, 1.2, 0.78, wood, kBoxCollider);
    b.solid("column", cylinder(0.2, kHeight, 24), stone, kBoxCollider, at({-2.4, 0, -1.6}));
    const auto put = [&](const char* name, double size, const dvec3& position, double degrees,
                         std::uint32_t material) {
        Transform place = at(position);
        place.rotation = quat(about_y(glm::radians(degrees)));
        const dvec3 half(0.5 * size, 0, 0.5 * size);
        b.solid(name, box(-half, half + dvec3(0, size, 0)), material, kBoxCollider, place);
    };
    put("crate-1", 0.7, {-3.2, 0, -2.3}, 12, crate);
    put("crate-2", 0.5, {-3.25, 0.7, -2.3}, 40, blue);
    put("crate-3", 0.6, {-0.8, 0, -2.4}, -20, crate);
    put("crate-4", 0.7, {2.9, 0, 2.1}, 25, crate);
    put("crate-5", 0.55, {2.2, 0, -2.2}, -10, blue);
    put("crate-6", 0.45, {3.0, 0, -1.7}, 35, crate);
}

// Hangs over the doorway and shines away from it, so that not one direct ray enters the dark half.
void lamp(Builder& b, std::uint32_t iron) {
    Light light;
    light.type = LightType::spot;
    light.colour = {1, 0.88f, 0.7f};
    light.intensity = 1500;
    light.inner_cone = glm::radians(30.0f);
    light.outer_cone = glm::radians(45.0f);
    const std::uint32_t node = b.light("lamp", looking({-0.6, 2.7, 0}, {-1.4, 2.1, 0}), light);
    b.solid("lamp-housing", box({-0.08, -0.08, 0.02}, {0.08, 0.08, 0.2}), iron, {}, {}, node);
}

// Carried by the player: a cage of four posts between two plates, its light in the middle. On the table it
// stands so close to the dividing wall that it does not shine through the doorway.
void lantern(Builder& b, std::uint32_t iron) {
    Shape cage;
    add_box(cage, {-0.07, 0, -0.07}, {0.07, 0.015, 0.07});
    add_box(cage, {-0.07, 0.205, -0.07}, {0.07, 0.22, 0.07});
    for (const double x : {-0.065, 0.055}) {
        for (const double z : {-0.065, 0.055}) {
            add_box(cage, {x, 0.015, z}, {x + 0.01, 0.205, z + 0.01});
        }
    }
    const std::uint32_t node =
        b.solid("lantern", cage, iron, R"({"lantern":{"handle":0.22}})", at({-0.25, 0.78, 2.2}));
    Light light;
    light.type = LightType::point;
    light.colour = {1, 0.7f, 0.4f};
    light.intensity = 15;
    b.light("lantern-light", at({0, 0.11, 0}), light, node);
}

// On the floor of the lit half, facing the dividing wall.
void player(Builder& b) {
    const std::uint32_t node = b.node("player", at({-2.6, 0, 0.8}));
    b.scene.nodes[node].extras = R"({"player":{},"character":{"radius":0.28,"height":1.75}})";
    const std::uint32_t eyes =
        b.camera("player-eyes", looking({0, 1.62, 0}, {1, 1.62, 0}), glm::radians(62.0f));
    b.scene.nodes[eyes].parent = node;
    b.scene.nodes[eyes].extras = R"({"eyes":{}})";
}

}  // namespace lantern_room_parts

SceneData lantern_room() {
    using namespace lantern_room_parts;
    Builder b;
    shell(b, bricks(b));
    const std::uint32_t wood = b.matte("wood", {0.4f, 0.25f, 0.13f});
    const std::uint32_t iron = b.matte("iron", {0.12f, 0.12f, 0.13f});
    door(b, wood);
    furniture(b, wood);
    lamp(b, iron);
    lantern(b, iron);

    // A white plate on the far wall, opposite the doorway; its -Z looks into the room. What comes through the
    // open door alone gives it 0.9 lux.
    b.solid("far_sensor", box({-0.1, -0.1, 0}, {0.1, 0.1, 0.02}), b.matte("sensor", vec3(0.8f)),
            R"({"light_sensor":{"radius":1},"goal":{"lux":3}})", looking({kEnd - 0.02, 1.2, 0}, {0, 1.2, 0}));

    b.camera("camera", looking({-3.5, 1.7, 2.4}, {0.2, 1.1, -0.5}), glm::radians(65.0f));
    b.camera("dark", looking({3.7, 1.6, 2.6}, {0.3, 1.0, -0.6}), glm::radians(65.0f));
    player(b);
    return b.scene;
}

SceneData lantern_room_open() {
    using namespace lantern_room_parts;
    SceneData scene = lantern_room();
    const auto door = std::ranges::find(scene.nodes, "door", &NodeData::name);
    door->local.rotation = quat(about_y(kOpenAngle));
    return scene;
}

}  // namespace lanthorn::scene_generator
