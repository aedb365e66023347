// What the game's icon is rendered from: its lantern, lit, in a corner of a red, a blue and a pale wall.
#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

SceneData lamplighter_icon() {
    Builder b;
    const Finishes f = finishes(b);
    const std::uint32_t red = b.matte("red", {0.55f, 0.06f, 0.04f});
    const std::uint32_t blue = b.matte("blue", {0.06f, 0.12f, 0.5f});
    const std::uint32_t flame = b.matte("flame", vec3(0.8f));
    b.scene.materials[flame].emissive = vec3(2600, 1700, 700);

    Shape board, back, left, right, top;
    add_box(board, {-0.27, -0.03, -0.3}, {0.27, 0, 0.5});
    add_box(back, {-0.27, 0, -0.33}, {0.27, 0.75, -0.3});
    add_box(left, {-0.30, 0, -0.33}, {-0.27, 0.75, 0.5});
    add_box(right, {0.27, 0, -0.33}, {0.30, 0.75, 0.5});
    add_box(top, {-0.30, 0.75, -0.33}, {0.30, 0.78, 0.5});
    b.solid("board", board, f.oak);
    b.solid("back", back, f.trim);
    b.solid("left", left, red);
    b.solid("right", right, blue);
    b.solid("top", top, f.trim);
    add_lantern(b, f.brass, {0, 0, 0}, kLamplight, 18);
    Shape fire;
    add_box(fire, {-0.014, 0.05, -0.014}, {0.014, 0.1, 0.014});
    b.solid("flame", fire, flame);
    add_spot(b, "moon", {-0.2, 0.6, 0.9}, {0, 0.15, 0}, kMoonlight, 60, 10, 25);
    b.camera("camera", looking({0.1, 0.34, 1.1}, {0, 0.155, 0}), glm::radians(27.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator
