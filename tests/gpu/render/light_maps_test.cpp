// Lights' maps that pay for change alone show what maps drawn anew show.
#include "lanthorn/render/light_maps.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace light_maps_test {

constexpr ivec2 kSize{32, 32};
constexpr std::size_t kBlock = 5;  // of small_room
constexpr std::size_t kOther = 8;  // one more; the last
constexpr int kUntilLightsAreSteady = 5;

// A room lit by a lamp in the ceiling (four samples), a point light, a spot and the sun through a wall that
// is not there; two boxes.
FrameScene room() {
    testing::SceneBuilder b = testing::small_room(1, true);
    b.add_box(1, vec3(-0.3f, 0.08f, 0.35f), vec3(0.06f), 0.2f);
    b.add_point(vec3(0.2f, 0.8f, 0.2f), 1);
    b.add_spot(vec3(-0.2f, 0.8f, 0), vec3(0, -1, 0), 1, 0.2f, 0.5f);
    b.add_directional(glm::normalize(vec3(0.1f, -0.3f, -1)), 1);
    return b.build();
}

FrameScene next(FrameScene scene) {
    ++scene.frame;
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

void move(FrameScene& scene, std::size_t instance, const vec3& by) {
    Instance& moved = scene.instances[instance];
    scene.changes.geometry = true;
    scene.changes.moved.push_back(static_cast<std::uint32_t>(instance));
    scene.changes.dirty.add(moved.bounds);
    const mat4 shift = glm::translate(mat4(1), by);
    moved.transform = shift * moved.transform;
    moved.bounds = transformed(moved.bounds, shift);
    moved.is_static = false;
    scene.changes.dirty.add(moved.bounds);
}

std::vector<std::vector<float>> shown(const render::FrameRenderer& renderer) {
    const render::LightMaps& maps = renderer.light_maps();
    return {maps.distance().read_floats(1), maps.normals().read_floats(2), maps.albedo().read_floats(4),
            maps.area_distance().read_floats(1), maps.area_normals().read_floats(2)};
}

render::RenderSettings small_maps() {
    render::RenderSettings settings;
    settings.shadow_resolution = 128;
    settings.area_lights_resolution = 64;
    return settings;
}

std::vector<std::vector<float>> drawn_anew(FrameScene scene) {
    scene.changes = {};
    render::FrameRenderer renderer;
    renderer.settings = small_maps();
    testing::render_once(renderer, scene, kSize);
    return shown(renderer);
}

class LightMapMovers : public ::testing::Test {
  protected:
    LightMapMovers() {
        renderer.settings = small_maps();
        for (int i = 0; i < kUntilLightsAreSteady; ++i) {
            show(i == 0 ? scene : next(scene));
        }
    }
    void show(FrameScene now) {
        scene = std::move(now);
        testing::render_once(renderer, scene, kSize);
    }
    int layers_drawn() const { return renderer.light_maps().layers_drawn(); }
    std::size_t still_bytes() const { return renderer.light_maps().still_bytes(); }

    gpu::Context& context = testing::context();
    render::FrameRenderer renderer;
    FrameScene scene = room();
};

TEST_F(LightMapMovers, AreDrawnOverWhatStandsStill) {
    EXPECT_EQ(still_bytes(), 0u) << "nothing moves";
    const int all = 6 + 1 + 1 + 4 * 6;
    FrameScene moved = next(scene);
    move(moved, kBlock, vec3(0.01f, 0, 0));
    show(moved);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    const std::size_t bytes = still_bytes();
    EXPECT_GT(bytes, 0u);
    for (const float step : {0.02f, 0.05f, 0.2f, -0.3f}) {
        moved = next(scene);
        move(moved, kBlock, vec3(step, 0.1f, 0));
        show(moved);
        EXPECT_EQ(shown(renderer), drawn_anew(scene)) << step;
        EXPECT_GT(layers_drawn(), 0);
        EXPECT_LT(layers_drawn(), all) << "only faces that see the box, now or before";
    }
    // Another begins to move, while the first waits to be called static.
    moved = next(scene);
    move(moved, kOther, vec3(0, 0.1f, 0.05f));
    show(moved);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    // The first comes to rest: into the still layers, and no map is touched.
    moved = next(scene);
    moved.instances[kBlock].is_static = true;
    show(moved);
    EXPECT_EQ(layers_drawn(), 0);
    moved = next(scene);
    move(moved, kOther, vec3(-0.1f, 0, 0.05f));
    show(moved);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    // So does the other; nothing is kept for what no longer comes.
    moved = next(scene);
    moved.instances[kOther].is_static = true;
    show(moved);
    EXPECT_EQ(layers_drawn(), 0);
    EXPECT_EQ(still_bytes(), 0u);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
}

// Its map is drawn when it shines, and stays as it was if nothing has moved meanwhile. Others' are not
// touched.
TEST_F(LightMapMovers, ALampThatIsOutIsNotFollowed) {
    const float intensity = scene.lights[0].light.intensity;
    const auto shine = [&](float share) {
        FrameScene now = next(scene);
        now.lights[0].light.intensity = share * intensity;
        now.changes.lights = true;
        return now;
    };
    show(shine(0));
    EXPECT_EQ(layers_drawn(), 0);
    show(shine(1));
    EXPECT_EQ(layers_drawn(), 0);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    show(shine(0));
    FrameScene moved = next(scene);
    move(moved, kBlock, vec3(0.01f, 0, 0));
    show(moved);
    const int of_the_others = layers_drawn();
    moved = next(scene);
    move(moved, kBlock, vec3(0.02f, 0, 0));
    show(moved);
    EXPECT_LE(layers_drawn(), of_the_others);
    show(shine(1));
    EXPECT_EQ(layers_drawn(), 6) << "all of the lamp's own, no others'";
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
}

TEST_F(LightMapMovers, ThatComeAndGoAreSeen) {
    FrameScene now = next(scene);
    const Instance other = now.instances[kOther];
    now.instances.pop_back();
    now.changes.geometry = true;
    now.changes.dirty = other.bounds;
    show(now);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    now = next(scene);
    now.instances.push_back(other);
    now.changes.geometry = true;
    now.changes.moved = {kOther};
    now.changes.dirty = other.bounds;
    show(now);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
    EXPECT_GT(still_bytes(), 0u);
    // Gone again, and back, in frames that are not rendered; what was told of them is lost.
    now = next(next(scene));
    now.instances.pop_back();
    show(now);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
}

// A light that moves has no use for a still layer, whatever moves with it.
TEST_F(LightMapMovers, CostALightThatMovesNoMemory) {
    scene.lights.erase(scene.lights.begin() + 1, scene.lights.end());
    for (int i = 0; i < kUntilLightsAreSteady; ++i) {
        show(next(scene));
    }
    const auto area_only = [&] {
        FrameScene now = next(scene);
        move(now, kBlock, vec3(0.01f, 0, 0));
        now.lights[0].position.x -= 0.01f;
        now.changes.lights = true;
        show(now);
        EXPECT_EQ(shown(renderer), drawn_anew(scene));
        return still_bytes();
    };
    area_only();
    const std::size_t with_moving_light = area_only();
    EXPECT_GT(with_moving_light, 0u) << "the lamp stays where it is";
    // It stops: some frames later its faces have still layers too.
    for (int i = 0; i < kUntilLightsAreSteady; ++i) {
        FrameScene now = next(scene);
        move(now, kBlock, vec3(0.01f, 0, 0));
        show(now);
        EXPECT_EQ(shown(renderer), drawn_anew(scene)) << i;
    }
    EXPECT_GT(still_bytes(), with_moving_light);
    area_only();
    EXPECT_EQ(still_bytes(), with_moving_light);
}

// Beyond a light's range its map need not be right, until the range grows.
TEST_F(LightMapMovers, BeyondTheRangeAreSeenWhenItGrows) {
    FrameScene now = next(scene);
    now.lights[0].light.range = 0.3f;
    now.changes.lights = true;
    show(now);
    now = next(scene);
    move(now, kBlock, vec3(0.1f, 0, 0));
    show(now);
    now = next(scene);
    now.lights[0].light.range = 10;
    now.changes.lights = true;
    show(now);
    EXPECT_EQ(shown(renderer), drawn_anew(scene));
}

}  // namespace light_maps_test
}  // namespace lanthorn
