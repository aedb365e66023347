#include "tools/scene_generator/level_furnishings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

void add_carpet(Builder& b, const std::string& name, const dvec3& low, const dvec3& high,
                const CarpetColours& colours) {
    const std::uint32_t wool = b.matte(name + "-wool", vec3(1), 0);
    const double size = 0.4;
    b.texture(wool, 32, size, [&](double x, double y) {
        const double d = std::abs(x - 0.5) + std::abs(y - 0.5);
        return d < 0.14 ? colours.figure : d < 0.3 ? colours.ground : colours.field;
    });
    const std::uint32_t hem = b.matte(name + "-hem", colours.hem, 0);
    constexpr double kHem = 0.09;
    const dvec3 in(kHem, 0, kHem);
    b.solid(name, box(low + in, high - in), wool);
    Shape edge;
    add_box(edge, low, {high.x, high.y, low.z + kHem});
    add_box(edge, {low.x, low.y, high.z - kHem}, high);
    add_box(edge, {low.x, low.y, low.z + kHem}, {low.x + kHem, high.y, high.z - kHem});
    add_box(edge, {high.x - kHem, low.y, low.z + kHem}, {high.x, high.y, high.z - kHem});
    b.solid(name + "-hem", edge, hem);
}

void add_bookshelf(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot,
                   const dvec3& size, int levels, std::uint64_t seed) {
    std::vector<double> boards;
    const std::uint32_t node =
        b.solid(name, whole(shelf_parts(size, levels, &boards)), f.oak, kBoxCollider, at(foot));
    constexpr std::array<vec3, 3> kLeather = {vec3(0.2f, 0.05f, 0.035f), vec3(0.06f, 0.09f, 0.05f),
                                              vec3(0.3f, 0.2f, 0.09f)};
    std::array<Shape, kLeather.size()> books;
    const double gap = size.y / levels, inside = 0.5 * size.x - 0.03;
    std::uint64_t counter = 0;
    const auto any = [&] { return uniform(seed, counter++); };
    for (const double board : boards) {
        // A row from one side, to some place.
        const bool from_left = any() < 0.5;
        const double row = 2 * inside * (0.35 + 0.6 * any());
        double x = 0;
        while (true) {
            const double thick = 0.025 + 0.04 * any(), high = gap * (0.5 + 0.3 * any());
            const double deep = size.z * (0.5 + 0.25 * any());
            Shape& shape = books[std::min<std::size_t>(static_cast<std::size_t>(3 * any()), 2)];
            if (x + thick > row) {
                break;
            }
            const double left = from_left ? -inside + x : inside - x - thick;
            add_box(shape, {left, board, 0.04}, {left + thick, board + high, 0.04 + deep});
            x += thick + 0.002;
        }
    }
    for (std::size_t i = 0; i < books.size(); ++i) {
        if (!books[i].corners.empty()) {
            const std::string part = name + "-books-" + std::to_string(i + 1);
            b.scene.nodes[node].meshes.push_back(b.mesh(part, books[i], b.matte(part, kLeather[i], 0.4f)));
        }
    }
}

void add_still_life(Builder& b, const std::string& name, const dvec3& foot) {
    Outline jug = {{{0, 0}, {0, -1}}, {{0.05, 0}, {0, -1}}};
    add_curve(jug, {{0.05, 0}, {0.085, 0.06}, {0.08, 0.12}, {0.04, 0.18}, {0.05, 0.24}}, 6);
    jug.push_back({{0.05, 0.24}, {0, 1}});
    jug.push_back({{0, 0.24}, {0, 1}});
    b.solid(name + "-jug", lathe(jug, 20), b.matte(name + "-glaze", {0.09f, 0.2f, 0.19f}, 0.9f), {},
            at(foot));
    b.solid(
        name + "-books",
        whole({{"a", {0.14, 0, -0.1}, {0.42, 0.045, 0.1}}, {"b", {0.17, 0.045, -0.09}, {0.41, 0.08, 0.08}}}),
        b.matte(name + "-leather", {0.2f, 0.05f, 0.035f}, 0.5f), {}, at(foot));
}

}  // namespace lanthorn::scene_generator
