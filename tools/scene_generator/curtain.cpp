#include "tools/scene_generator/curtain.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "lanthorn/core/turns.h"

namespace lanthorn::scene_generator {

namespace {

constexpr int kClothRows = 12;
constexpr int kColumnsAFold = 4;
constexpr double kFold = 0.15, kDeep = 0.05;  // metres

}  // namespace

std::uint32_t curtain_cloth(Builder& b, const std::string& name, const vec3& colour) {
    const std::uint32_t material = b.matte(name, colour);
    b.scene.materials[material].double_sided = true;
    return material;
}

void add_curtain(Builder& b, const std::string& name, std::uint32_t material, const dvec3& rail, double yaw,
                 double width, double height, double low, double high) {
    const int columns = kColumnsAFold * static_cast<int>(std::lround(width / kFold)) + 1;
    const auto point = [&](int column, int row) {
        const double folds = static_cast<double>(column) / kColumnsAFold;
        return dvec3(width * column / (columns - 1), -height * row / (kClothRows - 1),
                     kDeep * std::sin(2 * std::numbers::pi * folds));
    };
    Transform placed = at(rail);
    placed.rotation = quat(about_y(yaw));
    const std::uint32_t node = b.node(name, placed);
    Skin skin;
    skin.name = name;
    for (int row = 0; row < kClothRows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const dvec3 place = point(column, row);
            skin.joints.push_back(b.node(fmt::format("{}.{}.{}", name, row, column), at(place), node));
            skin.inverse_binds.push_back(glm::translate(mat4(1), -vec3(place)));
        }
    }
    b.scene.skins.push_back(std::move(skin));

    Mesh mesh;
    mesh.name = name;
    mesh.material = material;
    mesh.cage = SubdivisionCage{};
    mesh.cage->level = 2;
    for (int row = 0; row + 1 < kClothRows; ++row) {
        for (int column = 0; column + 1 < columns; ++column) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const dvec3 across = point(column + 1, row + 1) - point(column, row);
            const dvec3 askew = point(column + 1, row) - point(column, row + 1);
            const dvec3 normal = glm::normalize(glm::cross(across, askew));
            for (const auto& [c, r] : {std::pair(column, row), std::pair(column, row + 1),
                                       std::pair(column + 1, row + 1), std::pair(column + 1, row)}) {
                Vertex vertex;
                vertex.position = point(c, r);
                vertex.normal = normal;
                mesh.vertices.push_back(vertex);
                mesh.bounds.add(vertex.position);
                SkinInfluences bound;
                bound.joints[0] = static_cast<std::uint16_t>(r * columns + c);
                bound.weights[0] = 1;
                mesh.skin.push_back(bound);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
                mesh.indices.push_back(first + i);
            }
            mesh.cage->face_sizes.push_back(4);
        }
    }
    b.scene.meshes.push_back(std::move(mesh));
    b.scene.nodes[node].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};
    b.scene.nodes[node].skin = static_cast<std::uint32_t>(b.scene.skins.size() - 1);
    b.scene.nodes[node].extras = fmt::format(R"({{"cloth":{{"columns":{},"rows":{},"low":{},"high":{}}}}})",
                                             columns, kClothRows, low, high);
}

}  // namespace lanthorn::scene_generator
