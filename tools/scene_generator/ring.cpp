#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

constexpr double kInner = 0.2, kOuter = 0.215, kTall = 0.11;  // of the ring, metres

// A pawn: round foot, narrow waist, a ball for a head.
Shape pawn() {
    Outline outline = {{{0, 0}, {0, -1}}, {{0.021, 0}, {0, -1}}};
    add_curve(outline,
              {{0.021, 0},
               {0.024, 0.005},
               {0.0195, 0.014},
               {0.01, 0.029},
               {0.008, 0.049},
               {0.0135, 0.056},
               {0.0085, 0.061},
               {0.0135, 0.0715},
               {0.0155, 0.082},
               {0.0115, 0.094},
               {0.006, 0.0985}},
              6);
    outline.push_back({{0.006, 0.0985}, {0, 1}});
    outline.push_back({{0, 0.0985}, {0, 1}});
    return lathe(outline, 48);
}

}  // namespace

// After Yao et al. 2010, Fig. 10 (c): a polished ring and an occluder that stands within it. The lamp is
// small and stands low enough that the far half of the inner wall throws a cardioid onto the table, the
// pawn's shadow in it.
SceneData ring() {
    Builder b;
    constexpr double kHalf = 1.1, kHeight = 1.5, kWall = kHalf + kWallThickness;
    const std::uint32_t table = b.matte("table", {0.68f, 0.6f, 0.5f});
    const std::uint32_t wall = b.matte("wall", {0.6f, 0.58f, 0.55f});
    const std::uint32_t blue = b.matte("blue-wall", {0.12f, 0.2f, 0.42f});
    const std::uint32_t red = b.matte("red-wall", {0.5f, 0.1f, 0.07f});
    b.solid("table", box({-kWall, -kWallThickness, -kWall}, {kWall, 0, kWall}), table);
    b.solid("ceiling", box({-kWall, kHeight, -kWall}, {kWall, kHeight + kWallThickness, kWall}), wall);
    b.solid("blue-wall", box({-kWall, 0, -kHalf}, {-kHalf, kHeight, kHalf}), blue);
    b.solid("red-wall", box({kHalf, 0, -kHalf}, {kWall, kHeight, kHalf}), red);
    b.solid("back-wall", box({-kWall, 0, -kWall}, {kWall, kHeight, -kHalf}), wall);
    b.solid("front-wall", box({-kWall, 0, kHalf}, {kWall, kHeight, kWall}), wall);

    b.solid("ring", ring_band(kInner, kOuter, kTall, 0.004, 160),
            b.metal("gold", {1.0f, 0.77f, 0.34f}, 0.05f));
    b.solid("pawn", pawn(), b.matte("ivory", {0.75f, 0.7f, 0.6f}), {}, at({0.035, 0, -0.045}));

    b.panel("lamp", {-0.72, 0.7, 0.62}, {0, 0.05, 0}, 0.14, 0.14, vec3(1, 0.93f, 0.82f) * 40000.0f);
    b.camera("camera", looking({0.06, 0.52, 0.52}, {0.01, 0.02, -0.005}), glm::radians(40.0f), 0.02f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
