// Surfaces that keep all light or none, and lamps that touch them.
#include <fmt/format.h>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

Stage room_of_albedo(float albedo) {
    Stage stage = room();
    for (Material& m : stage.materials) m.base_colour = vec4(vec3(albedo), 1);
    return stage;
}

Row in_sphere(std::string name, float albedo, int bounces) {
    Row row;
    row.name = std::move(name);
    row.stage = [albedo] { return sphere(albedo); };
    row.settings.bounces = bounces;
    row.bounces = bounces;
    row.ordinary = Ordinary::sphere;
    row.right = Right::constant;
    row.lux = sphere_irradiance(albedo, bounces);
    row.least_maps = 1;
    return row;
}

// The irradiance after one reflection and more does not depend on where in the sphere the bulb is.
Row bulb_beside_wall(float metres) {
    Row row = in_sphere(fmt::format("bulb {:g} mm off a sphere's wall", 1e3f * metres), 0.5f, 2);
    row.stage = [metres] {
        Stage stage = sphere(0.5f);
        stage.lights[0].position = vec3(0.6f, 0.64f, -0.48f) * (1 - metres);
        return stage;
    };
    return row;
}

Row black_room() {
    Row row;
    row.name = "albedo 0";
    row.stage = [] { return room_of_albedo(0); };
    row.right = Right::constant;
    row.bounces = 0;
    return row;
}

Row white_room() {
    Row row;
    row.name = "albedo 0.999, 8 bounces, room";
    row.stage = [] { return room_of_albedo(0.999f); };
    row.settings.bounces = 8;
    row.bounces = 8;
    row.spp = 32;
    return row;
}

Row glowing_panel(float nits) {
    Row row;
    row.name = fmt::format("a panel of {:.0e} nits", nits);
    row.stage = [nits] {
        Stage stage = room();
        stage.lights.clear();
        stage.materials.push_back(stage.materials[0]);
        stage.materials.back().emissive = vec3(nits);
        stage.meshes.push_back(gi::test::quad(vec3(0.5f, 2.59f, 1), vec3(1, 0, 0), vec3(0, 0, 1), 3));
        return stage;
    };
    return row;
}

Row bulb_on_ceiling() {
    Row row;
    row.name = "bulb in the ceiling's plane";
    row.stage = [] {
        Stage stage = room();
        stage.lights[0].position.y = 2.6f;
        return stage;
    };
    row.lost = 0.3;
    row.reason = "lost: half of the bulb is outside";
    return row;
}

}  // namespace

std::vector<Row> rows_of_light() {
    return {black_room(),
            in_sphere("ordinary sphere", 0.5f, 2),
            in_sphere("albedo 1, sphere", 1, 2),
            in_sphere("albedo 0.999, 8 bounces, sphere", 0.999f, 8),
            white_room(),
            bulb_beside_wall(0.1f),
            bulb_beside_wall(0.005f),
            bulb_on_ceiling(),
            glowing_panel(1e-4f),
            glowing_panel(1e11f)};
}

}  // namespace lanthorn::extremes
