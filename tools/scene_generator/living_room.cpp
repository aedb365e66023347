#include <cmath>

#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace living_room_parts {

// Boards of ten widths, each of its own tone, with grain along them.
dvec3 boards(double x, double y) {
    const auto board = static_cast<std::uint64_t>(10 * y);
    const double tone = uniform(11, board), across = 10 * y - static_cast<double>(board);
    const double end = std::abs(x - uniform(12, board));
    if (across < 0.03 || end < 0.003) {
        return {0.2, 0.12, 0.07};
    }
    const double grain = 0.5 * std::sin(40 * across + 3 * std::sin(6.2831853 * (2 * x + tone))) +
                         0.5 * std::sin(97 * across + 5 * std::sin(6.2831853 * (3 * x + 2 * tone)));
    return dvec3(0.55, 0.36, 0.22) * (0.86 + 0.24 * tone + 0.05 * grain);
}

// Diamonds within a border.
dvec3 rug(double x, double y) {
    const double u = std::abs(2 * x - 1), v = std::abs(2 * y - 1), edge = std::max(u, v);
    if (edge > 0.9) {
        return edge > 0.95 ? dvec3(0.36, 0.08, 0.1) : dvec3(0.85, 0.76, 0.58);
    }
    const double a = std::abs(8 * x - std::round(8 * x)), b = std::abs(8 * y - std::round(8 * y));
    return a + b < 0.25   ? dvec3(0.85, 0.76, 0.58)
           : a + b < 0.36 ? dvec3(0.15, 0.2, 0.36)
                          : dvec3(0.55, 0.13, 0.13);
}

// Hills under an evening sky.
dvec3 painting(double x, double y) {
    if (std::hypot(x - 0.68, y - 0.42) < 0.09) {
        return {1, 0.86, 0.55};
    }
    const double far = 0.62 + 0.05 * std::sin(7 * x) + 0.02 * std::sin(19 * x);
    const double near = 0.78 + 0.07 * std::sin(4 * x + 2) + 0.015 * std::sin(23 * x);
    if (y > near) {
        return {0.1, 0.22, 0.16};
    }
    if (y > far) {
        return {0.24, 0.34, 0.42};
    }
    return glm::mix(dvec3(0.25, 0.3, 0.55), dvec3(0.95, 0.55, 0.3), y / far);
}

void place(Builder& b, const std::string& name, const Shape& shape, std::uint32_t material,
           const dvec3& where) {
    b.solid(name, shape, material, {}, at(where));
}

void sofa(Builder& b, const dvec3& p) {
    const std::uint32_t cloth = b.matte("sofa", {0.2f, 0.32f, 0.36f}, 0.3f);
    const std::uint32_t pillow = b.matte("pillow", {0.72f, 0.45f, 0.12f}, 0.3f);
    place(b, "sofa-base", rounded_box({1.05, 0.12, 0.42}, 0.04, 3), cloth, p + dvec3(0, 0.2, 0));
    place(b, "sofa-back", rounded_box({1.05, 0.3, 0.12}, 0.09, 3), cloth, p + dvec3(0, 0.58, -0.34));
    for (const double side : {-1.0, 1.0}) {
        const std::string which = side < 0 ? "-left" : "-right";
        place(b, "sofa-arm" + which, rounded_box({0.12, 0.26, 0.42}, 0.08, 3), cloth,
              p + dvec3(side * 1.13, 0.34, 0));
        place(b, "sofa-cushion" + which, rounded_box({0.48, 0.09, 0.32}, 0.07, 3), cloth,
              p + dvec3(side * 0.5, 0.405, 0.08));
    }
    Transform leaning = at(p + dvec3(-0.72, 0.66, -0.06));
    leaning.rotation = quat(glm::angleAxis(-0.35, dvec3(1, 0, 0)));
    b.solid("pillow", rounded_box({0.2, 0.2, 0.07}, 0.068, 3), pillow, {}, leaning);
}

// A top of glass on four steel legs, and what stands on it.
void glass_table(Builder& b, const dvec3& p) {
    constexpr double kTall = 0.4, kHalfTop = 0.008, kX = 0.6, kZ = 0.36;
    const std::uint32_t steel = b.metal("steel", {0.66f, 0.65f, 0.63f}, 0.15f);
    place(b, "table-top", box({-kX, -kHalfTop, -kZ}, {kX, kHalfTop, kZ}),
          b.glass("table-glass", 1.5f, static_cast<float>(2 * kHalfTop), {0.45f, 0.85f, 0.75f}, 0.1f),
          p + dvec3(0, kTall + kHalfTop, 0));
    int leg = 0;
    for (const double x : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
            place(b, "table-leg-" + std::to_string(++leg), cylinder(0.018, kTall - 1e-3, 32), steel,
                  p + dvec3(x * (kX - 0.08), 0, z * (kZ - 0.08)));
        }
    }
    const dvec3 top = p + dvec3(0, kTall + 2 * kHalfTop + 1e-3, 0);
    place(b, "ball", icosphere(0.085, 4), b.glass("ball-glass", 1.5f, 0.17f), top + dvec3(0.26, 0.086, 0.12));

    Outline vase = {{{0, 0}, {0, -1}}, {{0.045, 0}, {0, -1}}};
    add_curve(vase,
              {{0.045, 0},
               {0.055, 0.008},
               {0.07, 0.06},
               {0.06, 0.14},
               {0.035, 0.2},
               {0.04, 0.25},
               {0.053, 0.278},
               {0.0505, 0.284},
               {0.0455, 0.279},
               {0.034, 0.25},
               {0.029, 0.2},
               {0.054, 0.14},
               {0.063, 0.06},
               {0.04, 0.022}},
              9);
    vase.push_back({{0.04, 0.022}, {0, 1}});
    vase.push_back({{0, 0.022}, {0, 1}});
    place(b, "glass-vase", lathe(vase, 48), b.glass("vase-glass", 1.5f, 0.006f, {0.3f, 0.55f, 0.9f}, 0.02f),
          top + dvec3(-0.3, 0, -0.08));
    const std::uint32_t covers[] = {b.matte("book-red", {0.5f, 0.08f, 0.06f}),
                                    b.matte("book-cream", {0.75f, 0.68f, 0.52f})};
    place(b, "book-1", box({-0.12, 0, -0.085}, {0.12, 0.028, 0.085}), covers[0], top + dvec3(-0.02, 0, 0.12));
    place(b, "book-2", box({-0.1, 0, -0.075}, {0.11, 0.022, 0.07}), covers[1],
          top + dvec3(-0.02, 0.029, 0.125));
}

// A bulb in a shade of brass that is open above and below, on a pole.
void lamp(Builder& b, const dvec3& p) {
    const std::uint32_t brass = b.metal("brass", {0.89f, 0.71f, 0.4f}, 0.22f);
    Outline foot = {{{0, 0}, {0, -1}}, {{0.15, 0}, {0, -1}}};
    add_quarter(foot, {0.138, 0.012}, 0.012, -90, 4);
    add_quarter(foot, {0.138, 0.012}, 0.012, 0, 4);
    foot.push_back({{0, 0.024}, {0, 1}});
    foot.erase(foot.begin() + 1);  // the edge begins with the quarter
    place(b, "lamp-foot", lathe(foot, 64), brass, p);
    place(b, "lamp-pole", cylinder(0.012, 1.34, 24), brass, p + dvec3(0, 0.025, 0));
    constexpr double kThick = 0.0025;
    const glm::dvec2 low(0.2, 1.32), high(0.11, 1.62), way = glm::normalize(high - low);
    const glm::dvec2 out(way.y, -way.x);
    const Outline shade = {{low, out},
                           {high, out},
                           {high, way},
                           {high - 2 * kThick * out, way},
                           {high - 2 * kThick * out, -out},
                           {low - 2 * kThick * out, -out},
                           {low - 2 * kThick * out, -way},
                           {low, -way}};
    place(b, "lamp-shade", lathe(shade, 96, true), brass, p);
    const std::uint32_t bulb = b.matte("bulb", vec3(0), 0);
    b.scene.materials[bulb].emissive = vec3(1, 0.82f, 0.58f) * 16000.0f;
    place(b, "bulb", icosphere(0.05, 2), bulb, p + dvec3(0, 1.46, 0));
}

// A low board with vases.
void sideboard(Builder& b, const dvec3& p) {
    const std::uint32_t wood = b.matte("walnut", {0.22f, 0.13f, 0.08f}, 0.6f);
    b.scene.materials[wood].roughness = 0.45f;
    place(b, "sideboard", rounded_box({0.8, 0.3, 0.22}, 0.012, 3), wood, p + dvec3(0, 0.31, 0));
    const std::uint32_t glaze = b.matte("glaze", {0.1f, 0.28f, 0.42f});
    b.scene.materials[glaze].roughness = 0.12f;
    const std::uint32_t copper = b.metal("copper", {0.95f, 0.64f, 0.54f}, 0.2f);
    Outline jar = {{{0, 0}, {0, -1}}, {{0.06, 0}, {0, -1}}};
    add_curve(jar,
              {{0.06, 0},
               {0.072, 0.02},
               {0.12, 0.1},
               {0.125, 0.17},
               {0.085, 0.25},
               {0.057, 0.3},
               {0.068, 0.33},
               {0.066, 0.35},
               {0.053, 0.352},
               {0.047, 0.332},
               {0.044, 0.3},
               {0.072, 0.24},
               {0.113, 0.165},
               {0.06, 0.03}},
              8);
    jar.push_back({{0.06, 0.03}, {0, 1}});
    jar.push_back({{0, 0.03}, {0, 1}});
    const dvec3 top = p + dvec3(0, 0.611, 0);
    place(b, "jar", lathe(jar, 56), glaze, top + dvec3(-0.45, 0, 0));
    place(b, "copper-bowl", lathe(jar, 56), copper, top + dvec3(0.5, 0, 0.02));
    place(b, "plaster-ball", icosphere(0.1, 3), b.matte("plaster", {0.78f, 0.76f, 0.72f}),
          top + dvec3(0.1, 0.101, 0));
}

}  // namespace living_room_parts

// After Yao et al. 2010, Fig. 1 (c): a living room with glossy, metal and glass things, and some caustics
// under the ball.
SceneData living_room() {
    using namespace living_room_parts;
    Builder b;
    constexpr double kX = 2.6, kZ = 2.2, kHeight = 2.6;
    const std::uint32_t floor = b.matte("floorboards", vec3(1));
    b.scene.materials[floor].roughness = 0.25f;
    b.texture(floor, 256, 1.4, boards);
    const std::uint32_t plaster = b.matte("walls", {0.74f, 0.71f, 0.65f}, 0);
    const std::uint32_t green = b.matte("green-wall", {0.16f, 0.27f, 0.2f}, 0);
    const std::uint32_t white = b.matte("ceiling", vec3(0.78f), 0);
    closed_room(b, {-kX, 0, -kZ}, {kX, kHeight, kZ},
                {.floor = {"floor", floor},
                 .ceiling = {"ceiling", white},
                 .left = {"left-wall", plaster},
                 .right = {"right-wall", plaster},
                 .back = {"back-wall", green},
                 .front = {"front-wall", plaster}});

    const std::uint32_t woven = b.matte("rug", vec3(1), 0);
    b.texture(woven, 256, 2, rug);
    place(b, "rug", box({0, 0, 0}, {2, 0.012, 2}), woven, {-1.1, 0.0005, -0.9});
    sofa(b, {-0.1, 0, -1.5});
    glass_table(b, {-0.05, 0.013, 0.1});
    lamp(b, {-1.75, 0, -1.55});
    sideboard(b, {1.7, 0, -1.9});
    const std::uint32_t canvas = b.matte("painting", vec3(1), 0);
    b.texture(canvas, 256, 0.8, painting);
    place(b, "frame", box({-0.03, -0.03, 0}, {0.83, 0.83, 0.025}),
          b.metal("gilt", {1.0f, 0.77f, 0.34f}, 0.35f), {-0.5, 1.35, -kZ + 1e-3});
    place(b, "painting", box({0, 0, 0}, {0.8, 0.8, 0.01}), canvas, {-0.5, 1.35, -kZ + 0.0265});

    b.panel("window", {kX - 0.005, 1.5, 0.5}, {0, 0.9, 0.2}, 1.1, 1.2, vec3(0.8f, 0.9f, 1) * 900.0f);
    b.camera("camera", looking({0.55, 1.35, 2.1}, {-0.25, 0.55, -0.5}), glm::radians(62.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
