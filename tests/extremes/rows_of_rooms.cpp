// Rooms that are hard to see, hard to keep light in, or not there.
#include <fmt/format.h>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

using gi::test::box;
using gi::test::quad;

Row row_of(std::string name, std::function<Stage()> stage) {
    Row row;
    row.name = std::move(name);
    row.stage = std::move(stage);
    return row;
}

// Nearly half of the room, and of the candidates, is inside of a pillar.
Stage with_pillar() {
    Stage stage = room();
    stage.meshes[1] = box(vec3(0.02f, 0, 0.02f), vec3(1.9f, 2.6f, 2.98f), false, 1);
    stage.meshes.pop_back();
    stage.lights[0].position.x = 2.8f;
    stage.target = vec3(2.2f, 0.8f, 0.4f);
    return stage;
}

// Every map sees nearly all of floor and ceiling at a grazing angle: (v - x).n of eq. 1 is next to nothing.
Stage crawl_space() {
    Stage stage = room();
    stage.meshes = {box(vec3(0), vec3(8, 0.2f, 8), true, 0)};
    stage.materials[0].emissive = vec3(10);
    stage.lights.clear();
    stage.eye = vec3(6.5f, 0.1f, 6.5f);
    stage.target = vec3(4, 0.1f, 4);
    stage.camera.z_near = 0.01f;
    return stage;
}

// The walls' own planes again, in sheets that overlap.
Stage with_coplanar_walls() {
    Stage stage = room();
    for (const float x : {0.0f, 0.7f, 1.9f}) {
        stage.meshes.push_back(quad(vec3(x, 0, 0.2f), vec3(0, 0, 2.6f), vec3(2, 0, 0), 0));
        stage.meshes.push_back(quad(vec3(x, 0.3f, 0), vec3(1.7f, 0, 0), vec3(0, 2, 0), 0));
    }
    return stage;
}

// Seen through the back of its front wall: the bulb's half on the left, behind the partition a dark one.
Stage divided(float size, std::vector<Mesh> partition) {
    Stage stage = room();
    stage.meshes = {box(vec3(0), size * vec3(4, 2.6f, 3), true, 0)};
    stage.meshes.insert(stage.meshes.end(), partition.begin(), partition.end());
    stage.lights[0].position *= size;
    stage.lights[0].light.intensity *= size * size;
    stage.eye = size * vec3(2, 1.3f, 5.6f);
    stage.target = size * vec3(2, 1.3f, 0);
    return stage;
}

Stage divided_by_millimetre(float size) {
    return divided(
        size, {box(vec3(2 * size - 5e-4f, 0, 0), vec3(2 * size + 5e-4f, 2.6f * size, 3 * size), false, 0)});
}

Stage divided_by_two_sheets() {
    return divided(1, {quad(vec3(2, 0, 0), vec3(0, 2.6f, 0), vec3(0, 0, 3), 0),
                       quad(vec3(2, 0, 0), vec3(0, 0, 3), vec3(0, 2.6f, 0), 0)});
}

Stage divided_by_one_sheet() {
    Stage stage = divided(1, {quad(vec3(2, 0, 0), vec3(0, 2.6f, 0), vec3(0, 0, 3), 1)});
    stage.materials[1].double_sided = true;
    return stage;
}

Stage with_triangle_at(float metres) {
    Stage stage = room();
    stage.meshes.push_back(quad(vec3(metres, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), 0));
    stage.meshes.back().indices.resize(3);
    return stage;
}

// One forgotten triangle far away: lengths are relative to the scene's diagonal.
Row stray_triangle(float metres) {
    Row row =
        row_of(fmt::format("a triangle {:g} m away", metres), [metres] { return with_triangle_at(metres); });
    row.right = Right::ordinary;
    return row;
}

Row half_dark(std::string name, std::function<Stage()> stage) {
    Row row = row_of(std::move(name), std::move(stage));
    row.dark = 0.2;
    return row;
}

Row nothing_at_all() {
    Row row = row_of("no geometry", [] {
        Stage stage = room();
        stage.meshes.clear();
        return stage;
    });
    row.right = Right::constant;
    row.bounces = 0;
    return row;
}

Row single_triangle() {
    Row row = row_of("a single triangle", [] {
        Stage stage = room();
        stage.meshes = {quad(vec3(0), vec3(0, 0, 3), vec3(4, 0, 0), 0)};
        stage.meshes[0].indices.resize(3);
        return stage;
    });
    row.right = Right::constant;
    row.least_maps = 1;
    row.least_stored = 0;
    row.lost = 1;
    row.reason = "lost: nothing is there to be met";
    return row;
}

// The ordinary room in a closed black box, which gives it nothing: the eye and the bulb are inside.
Row in_a_dome(std::string name, float half, const vec3& off, float nits) {
    Row row = row_of(std::move(name), [half, off, nits] {
        Stage stage = room();
        const vec3 middle = vec3(2, 1.3f, 1.5f) + half * off;
        const int black = static_cast<int>(stage.materials.size());
        stage.meshes.push_back(box(middle - half, middle + half, true, black));
        stage.materials.push_back(gi::test::lambertian(vec3(0)));
        stage.materials.back().emissive = vec3(nits);
        return stage;
    });
    row.right = Right::ordinary;
    row.error = 1.1;
    row.unlike = 2;
    return row;
}

std::vector<Row> domes() {
    std::vector<Row> rows;
    for (const float half : {10.0f, 50.0f, 1e3f, 1e6f}) {
        rows.push_back(in_a_dome(fmt::format("in a box of {:g} m", half), half, vec3(0), 0));
    }
    for (const float half : {10.0f, 1e3f, 1e6f}) {
        rows.push_back(in_a_dome(fmt::format("in a glowing box of {:g} m", half), half, vec3(0), 20));
        rows.back().lost = 1;
        rows.back().error = 2;
        rows.back().reason = "error: half of the photons are the box's, none of which gets in";
    }
    rows.push_back(in_a_dome("in a box of 1e+06 m off its middle", 1e6f, vec3(0.6f, 0.3f, -0.5f), 0));
    return rows;
}

// A hut, open in front, on a plain: its maps are in it.
Row hut_on_a_plain(float half) {
    Row row = row_of(fmt::format("a hut on a plain of {:g} m", half), [half] {
        Stage stage = room();
        stage.meshes = {quad(vec3(-half, 0, -half), vec3(0, 0, 2 * half), vec3(2 * half, 0, 0), 0),
                        box(vec3(-2.2f, 0, -2.2f), vec3(2.2f, 2.5f, -2), false, 0),
                        box(vec3(-2.2f, 0, -2), vec3(-2, 2.5f, 2), false, 1),
                        box(vec3(2, 0, -2), vec3(2.2f, 2.5f, 2), false, 2),
                        box(vec3(-2.2f, 2.5f, -2.2f), vec3(2.2f, 2.7f, 2), false, 0)};
        stage.lights[0].position = vec3(0, 2, 0);
        stage.eye = vec3(0, 1.4f, 1.8f);
        stage.target = vec3(0, 1, -2);
        return stage;
    });
    row.lost = 1;
    row.reason = "lost: light leaves by the front";
    return row;
}

}  // namespace

std::vector<Row> rows_of_rooms() {
    std::vector<Row> rows = domes();
    rows.insert(
        rows.end(),
        {hut_on_a_plain(100), hut_on_a_plain(3000), row_of("candidates inside a solid", with_pillar),
         row_of("crawl space of 8 x 0.2 x 8 m", crawl_space), row_of("coplanar walls", with_coplanar_walls),
         half_dark("a wall of 1 mm, 4 m room", [] { return divided_by_millimetre(1); }),
         half_dark("a wall of 1 mm, 40 m hall", [] { return divided_by_millimetre(10); }),
         half_dark("a wall of two sheets", divided_by_two_sheets),
         half_dark("a wall of one sheet", divided_by_one_sheet), stray_triangle(10), stray_triangle(100),
         stray_triangle(1000), nothing_at_all(), single_triangle()});
    return rows;
}

}  // namespace lanthorn::extremes
