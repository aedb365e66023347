// Meshes as they come from the wild: the same surfaces in worse triangles.
#include <utility>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

Vertex between(const Vertex& a, const Vertex& b, float t) {
    Vertex v = a;
    v.position = glm::mix(a.position, b.position, t);
    return v;
}

// Every triangle as a fan of `count` slivers from one corner; each second one is 1e-5 of the far edge wide.
Mesh cut_into_slivers(const Mesh& mesh, int count) {
    constexpr float kWidth = 1e-5f;
    Mesh cut = mesh;
    cut.indices.clear();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t apex = mesh.indices[i];
        const std::uint32_t last = mesh.indices[i + 2];
        std::uint32_t from = mesh.indices[i + 1];
        const Vertex& b = mesh.vertices[from];
        const Vertex& c = mesh.vertices[last];
        const auto to = [&](std::uint32_t vertex) {
            cut.indices.insert(cut.indices.end(), {apex, from, vertex});
            from = vertex;
        };
        for (int k = 1; k < count; ++k) {
            const float t = static_cast<float>(k / 2 * 2 + 1) / static_cast<float>(count);
            cut.vertices.push_back(
                between(b, c, k % 2 == 1 ? t : t - 2.0f / static_cast<float>(count) + kWidth));
            to(static_cast<std::uint32_t>(cut.vertices.size() - 1));
        }
        to(last);
    }
    return cut;
}

Stage of_slivers() {
    Stage stage = room();
    for (Mesh& mesh : stage.meshes) mesh = cut_into_slivers(mesh, 100);
    return stage;
}

// Triangles of one point, of an edge there and back, and of three points in line, all over the room.
Stage with_zero_area() {
    Stage stage = room();
    for (Mesh& mesh : stage.meshes) {
        const std::vector<std::uint32_t> indices = mesh.indices;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const std::uint32_t a = indices[i];
            const std::uint32_t b = indices[i + 1];
            const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(between(mesh.vertices[a], mesh.vertices[b], 0.5f));
            mesh.indices.insert(mesh.indices.end(), {a, a, a, a, b, a, a, middle, b});
        }
    }
    return stage;
}

// A lamp all of whose triangles have no area sends out no light, and takes no photon from the bulb.
Stage with_lamp_of_no_area() {
    Stage stage = room();
    Material lamp = gi::test::lambertian(vec3(0));
    lamp.emissive = vec3(1000);
    stage.materials.push_back(lamp);
    Mesh mesh = gi::test::quad(vec3(1, 2, 1), vec3(1, 0, 0), vec3(0, 0, 1), 3);
    mesh.indices = {0, 0, 0, 0, 1, 0, 2, 2, 3};
    stage.meshes.push_back(mesh);
    return stage;
}

Stage twice() {
    Stage stage = room();
    for (Mesh& mesh : stage.meshes) {
        const std::vector<std::uint32_t> indices = mesh.indices;
        mesh.indices.insert(mesh.indices.end(), indices.begin(), indices.end());
    }
    const std::vector<Mesh> meshes = stage.meshes;
    stage.meshes.insert(stage.meshes.end(), meshes.begin(), meshes.end());
    return stage;
}

Mesh inside_out(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (Vertex& v : mesh.vertices) v.normal = -v.normal;
    return mesh;
}

Stage with_block_inside_out() {
    Stage stage = room();
    stage.meshes[1] = inside_out(stage.meshes[1]);
    return stage;
}

Row row_of(std::string name, Stage (*stage)(), Right right) {
    Row row;
    row.name = std::move(name);
    row.stage = stage;
    row.right = right;
    return row;
}

Row block_inside_out() {
    Row row = row_of("a block inside out", with_block_inside_out, Right::traced);
    row.dark = 0.01;
    row.seeds = 8;
    row.defects = {{Bound::flux, 0.065, "light leaks through map texels on the block's edges"}};
    return row;
}

// The area that bandwidths are chosen by counts every copy: splats are twice as wide.
Row every_triangle_four_times() {
    return row_of("every triangle four times", twice, Right::ordinary);
}

}  // namespace

std::vector<Row> rows_of_triangles() {
    return {row_of("slivers, 1 : 1e5", of_slivers, Right::ordinary),
            row_of("zero-area triangles", with_zero_area, Right::ordinary),
            row_of("a lamp of no area", with_lamp_of_no_area, Right::ordinary), every_triangle_four_times(),
            block_inside_out()};
}

}  // namespace lanthorn::extremes
