// Lamps of all brightness, number, shape and colour, and what stands in their way: bars, gaps, a pinhole.
#include <fmt/format.h>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

using gi::test::box;
using gi::test::lambertian;
using gi::test::point_light;

namespace {

Row changed(std::string name, std::function<void(Stage&)> change) {
    Row row;
    row.name = std::move(name);
    row.stage = [change = std::move(change)] {
        Stage stage = room();
        change(stage);
        return stage;
    };
    return row;
}

Row spot(const char* name, float outer) {
    return changed(name, [outer](Stage& stage) {
        LightInstance& lamp = stage.lights[0];
        lamp.light.type = LightType::spot;
        lamp.direction = vec3(0, -1, 0);
        lamp.light.inner_cone = 0;
        lamp.light.outer_cone = outer;
    });
}

// Bars of 1 mm in front of the lamp, 1 cm apart, as a lantern has them.
void add_grille(Stage& stage) {
    for (int i = 0; i < 24; ++i) {
        const float z = 1.38f + 0.01f * static_cast<float>(i);
        stage.meshes.push_back(box(vec3(1.2f, 1.7f, z), vec3(1.201f, 2.4f, z + 1e-3f), false, 0));
    }
}

// A box of 30 cm around the lamp, open by one gap of 3 mm around its lower edge.
void enclose(Stage& stage) {
    const vec3 lamp = stage.lights[0].position;
    const float half = 0.15f, gap = 3e-3f, thick = 5e-3f;
    const auto wall = [&](const vec3& lower, const vec3& upper) {
        stage.meshes.push_back(box(lamp + lower, lamp + upper, false, 0));
    };
    wall(vec3(-half, half, -half), vec3(half, half + thick, half));
    wall(vec3(-half, -half - gap - thick, -half), vec3(half, -half - gap, half));
    wall(vec3(-half - thick, -half, -half - thick), vec3(-half, half + thick, half + thick));
    wall(vec3(half, -half, -half - thick), vec3(half + thick, half + thick, half + thick));
    wall(vec3(-half, -half, -half - thick), vec3(half, half + thick, -half));
    wall(vec3(-half, -half, half), vec3(half, half + thick, half + thick));
}

}  // namespace

std::vector<Row> rows_of_lamps() {
    return {
        changed("1e-6 cd beside 1e9 cd",
                [](Stage& stage) {
                    stage.lights[0].light.intensity = 1e9f;
                    stage.lights.push_back(point_light(vec3(3.2f, 0.4f, 0.4f), 1e-6f));
                }),
        changed("400 lamps",
                [](Stage& stage) {
                    stage.lights.clear();
                    for (int i = 0; i < 400; ++i) {
                        const vec3 at(0.1f + 0.19f * static_cast<float>(i % 20), 2.5f,
                                      0.1f + 0.145f * static_cast<float>(i / 20));
                        stage.lights.push_back(point_light(at, 0.25f));
                        stage.lights.back().id = static_cast<std::uint32_t>(i);
                    }
                }),
        changed("a lamp of pure blue", [](Stage& stage) { stage.lights[0].light.colour = vec3(0, 0, 1); }),
        changed("a range of 1 m", [](Stage& stage) { stage.lights[0].light.range = 1; }),
        spot("a cone of 90 degrees to each side", 1.5707f),
        changed("bars of 1 mm before a lamp", add_grille),
        changed("a lamp in a box with a gap of 3 mm", enclose),
        changed("a checker of black and white",
                [](Stage& stage) {
                    stage.materials.push_back(lambertian(vec3(0)));
                    stage.materials.push_back(lambertian(vec3(0.9f)));
                    for (int i = 0; i < 48; ++i) {
                        const float x = 0.5f * static_cast<float>(i % 8),
                                    z = 0.5f * static_cast<float>(i / 8);
                        stage.meshes.push_back(gi::test::quad(vec3(x, 1e-3f, z + 0.5f), vec3(0.5f, 0, 0),
                                                              vec3(0, 0, -0.5f), 3 + (i / 8 + i) % 2));
                    }
                }),
    };
}

}  // namespace lanthorn::extremes
