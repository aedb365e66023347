#include <array>
#include <cmath>
#include <numbers>

#include "tools/scene_generator/rigged_shape.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace dimpled_parts {

constexpr double kHalf = 0.42, kThick = 0.06;  // of the block, metres
constexpr int kCells = 99;                     // to a side, two triangles each

// Dimples 0.14 m apart in three directions, 4 mm deep: each gathers light about a quarter of a metre below.
double height(double x, double z) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double angle = (0.2 + i / 3.0) * std::numbers::pi;
        const double along = x * std::cos(angle) + z * std::sin(angle);
        sum += std::cos(2 * std::numbers::pi * along / 0.14 + 0.7 * std::sin(9 * along + 2 * i));
    }
    // Level at the edges.
    const double edge = std::max(std::abs(x), std::abs(z)) / kHalf;
    const double fade = 1 - std::pow(edge, 8);
    return kThick + 0.0022 * fade * sum;
}

// A closed block: dimples above, flat sides and a flat bottom, each with corners of its own so that its edges
// are sharp.
Mesh block(std::uint32_t material) {
    Mesh mesh;
    mesh.name = "dimpled-glass";
    mesh.material = material;
    const auto at = [](int i) { return kHalf * (2.0 * i / kCells - 1); };
    const auto add = [&](const dvec3& p, const dvec3& n) {
        Vertex vertex;
        vertex.position = vec3(p);
        vertex.normal = vec3(n);
        vertex.uv0 = vec2(p.x, p.z);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (int z = 0; z <= kCells; ++z) {
        for (int x = 0; x <= kCells; ++x) {
            constexpr double kStep = 1e-5;
            const double dx = (height(at(x) + kStep, at(z)) - height(at(x) - kStep, at(z))) / (2 * kStep);
            const double dz = (height(at(x), at(z) + kStep) - height(at(x), at(z) - kStep)) / (2 * kStep);
            add({at(x), height(at(x), at(z)), at(z)}, glm::normalize(dvec3(-dx, 1, -dz)));
        }
    }
    for (int z = 0; z < kCells; ++z) {
        for (int x = 0; x < kCells; ++x) {
            const auto a = static_cast<std::uint32_t>(z * (kCells + 1) + x);
            const std::uint32_t b = a + 1, c = a + kCells + 1, d = c + 1;
            triangle(a, c, b);
            triangle(b, c, d);
        }
    }
    // Round the edge, counter-clockwise seen from below.
    std::vector<glm::dvec2> rim;
    const std::array<glm::dvec2, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (int side = 0; side < 4; ++side) {
        const glm::dvec2 from = corners[static_cast<std::size_t>(side)];
        const glm::dvec2 to = corners[static_cast<std::size_t>((side + 1) % 4)];
        const glm::dvec2 outer = 0.5 * (from + to);
        for (int i = 0; i < kCells; ++i) {
            const auto place = [&](int k) {
                const glm::dvec2 cell = 0.5 * (from + 1.0) * double{kCells} + 0.5 * (to - from) * double(k);
                return glm::dvec2(at(static_cast<int>(std::lround(cell.x))),
                                  at(static_cast<int>(std::lround(cell.y))));
            };
            const glm::dvec2 p = place(i), q = place(i + 1);
            rim.push_back(p);
            const dvec3 n(outer.x, 0, outer.y);
            const std::uint32_t a = add({p.x, 0, p.y}, n), b = add({q.x, 0, q.y}, n);
            const std::uint32_t c = add({q.x, height(q.x, q.y), q.y}, n);
            const std::uint32_t d = add({p.x, height(p.x, p.y), p.y}, n);
            triangle(a, c, b);
            triangle(a, d, c);
        }
    }
    const std::uint32_t middle = add(dvec3(0), {0, -1, 0});
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::dvec2& p : rim) {
        add({p.x, 0, p.y}, {0, -1, 0});
    }
    const auto count = static_cast<std::uint32_t>(rim.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        triangle(middle, first + i, first + (i + 1) % count);
    }
    return mesh;
}

}  // namespace dimpled_parts

// After Yao et al. 2010, Fig. 1 (b): a dimpled surface that throws a net of caustics; here a block of glass
// on four posts above a diffuse floor, 21 k triangles.
SceneData dimpled() {
    using namespace dimpled_parts;
    Builder b;
    constexpr double kRoom = 1.1, kHeight = 1.8, kAbove = 0.3;
    const std::uint32_t floor = b.matte("floor", {0.7f, 0.66f, 0.6f}, 0);
    const std::uint32_t wall = b.matte("wall", {0.66f, 0.65f, 0.63f}, 0);
    const std::uint32_t ochre = b.matte("ochre-wall", {0.62f, 0.38f, 0.1f}, 0);
    const std::uint32_t violet = b.matte("violet-wall", {0.26f, 0.16f, 0.4f}, 0);
    closed_room(b, {-kRoom, 0, -kRoom}, {kRoom, kHeight, kRoom},
                {.floor = {"floor", floor},
                 .ceiling = {"ceiling", wall},
                 .left = {"ochre-wall", ochre},
                 .right = {"violet-wall", violet},
                 .back = {"back-wall", wall},
                 .front = {"front-wall", wall}});

    const std::uint32_t wood = b.matte("post", {0.3f, 0.2f, 0.13f}, 0);
    int post = 0;
    for (const double x : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
            constexpr double kSide = 0.015, kIn = kHalf - 0.03;
            b.solid(
                "post-" + std::to_string(++post),
                box({x * kIn - kSide, 0, z * kIn - kSide}, {x * kIn + kSide, kAbove - 1e-3, z * kIn + kSide}),
                wood);
        }
    }
    const std::uint32_t glass = b.node("dimpled-glass", at({0, kAbove, 0}));
    b.scene.meshes.push_back(
        block(b.glass("glass", 1.5f, static_cast<float>(kThick), {0.75f, 0.93f, 0.88f}, 0.25f)));
    b.scene.nodes[glass].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};

    b.panel("lamp", {-0.35, kHeight - 0.005, 0.1}, {-0.35, 0, 0.1}, 0.2, 0.2,
            vec3(1, 0.93f, 0.82f) * 11000.0f);
    b.camera("camera", looking({0.35, 0.95, 1.05}, {-0.03, 0.12, -0.1}), glm::radians(56.0f), 0.02f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
