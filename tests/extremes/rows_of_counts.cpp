// The ends of the settings' ranges.
#include "lanthorn/emc/emc_settings.h"
#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

Row with(std::string name, void (*alter)(gi::GiSettings&)) {
    Row row;
    row.name = std::move(name);
    row.stage = room;
    row.right = Right::ordinary;
    alter(row.settings);
    return row;
}

// The room twelve times, closed each and with a bulb each: no map sees more than one of them.
Stage twelve_rooms() {
    Stage stage;
    for (int i = 0; i < 12; ++i) {
        const vec3 place(4.2f * static_cast<float>(i % 3), 0, 3.2f * static_cast<float>(i / 3));
        Stage one = room();
        for (Mesh& mesh : one.meshes) {
            mesh.bounds = {};
            for (Vertex& v : mesh.vertices) {
                v.position += place;
                mesh.bounds.add(v.position);
            }
            stage.meshes.push_back(std::move(mesh));
        }
        one.lights[0].position += place;
        stage.lights.push_back(one.lights[0]);
    }
    const Stage first = room();
    stage.materials = first.materials;
    stage.camera = first.camera;
    stage.eye = first.eye;
    stage.target = first.target;
    return stage;
}

// A corridor between two rows of alcoves 28 cm wide.
Stage alcoves() {
    Stage stage = room();
    stage.meshes.resize(1);
    for (int i = 1; i < 14; ++i) {
        const float x = 4.0f * static_cast<float>(i) / 14.0f;
        for (const float z : {0.0f, 2.0f}) {
            stage.meshes.push_back(
                gi::test::box(vec3(x - 0.01f, 0, z), vec3(x + 0.01f, 2.6f, z + 1), false, 1));
        }
    }
    stage.lights[0].position.x = 2;
    stage.eye = vec3(3.9f, 1.6f, 1.6f);
    stage.target = vec3(0, 1.2f, 1.3f);
    return stage;
}

Row one_photon() {
    Row row = with("one photon", [](gi::GiSettings& s) { s.photons = 1; });
    row.error = 20;
    row.flux = 1;
    row.reason =
        "one photon is no picture: one bright splat; its light must stay finite and within what it carries";
    return row;
}

Row million_photons() {
    Row row = with("a million photons", [](gi::GiSettings& s) { s.photons = 1'000'000; });
    row.size = ivec2(48);
    return row;
}

Row one_map() {
    Row row = with("k = 1", [](gi::GiSettings& s) { s.edit<gi::EmcSettings>().count = 1; });
    row.least_maps = 1;
    row.seeds = 8;  // where the map happens to be decides: 0.81 to 1.01 of the flux
    row.error = 2.5;
    row.flux = 0.1;
    row.lost = 0.1;
    row.reason = "what one map does not see behind the block and the shelf";
    return row;
}

Row many_maps(std::string name, Stage (*stage)(), Right right, int least) {
    Row row = with(std::move(name), [](gi::GiSettings& s) {
        s.edit<gi::EmcSettings>().count = 32;
        s.edit<gi::EmcSettings>().candidates = 64;
    });
    row.stage = stage;
    row.right = right;
    row.least_maps = least;
    return row;
}

Row rooms_of_maps() {
    Row row = many_maps("k = 32, twelve rooms", twelve_rooms, Right::ordinary, 24);
    row.size = ivec2(48);
    row.settings.photons *= 12;
    return row;
}

Row narrow_alcoves() {
    Row row = many_maps("k = 32, alcoves of 28 cm", alcoves, Right::traced, 16);
    row.defects = {
        {Bound::error, 0.49, "splats (h 0.5 to 1.1 m) are wider than an alcove, the same with k = 8"},
        {Bound::flux, 0.26, "dark, for the same reason"}};
    return row;
}

}  // namespace

std::vector<Row> rows_of_counts() {
    return {one_photon(), million_photons(), one_map(), rooms_of_maps(), narrow_alcoves()};
}

}  // namespace lanthorn::extremes
