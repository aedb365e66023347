#include "tests/bench/vertex-map/thesis_scene.h"

#include <cmath>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::bench {

namespace {

// The first `faces` faces of a box, cut into side x side squares each.
Mesh cut_box(const Mesh& whole, std::size_t faces, int side) {
    Mesh mesh;
    mesh.material = whole.material;
    mesh.bounds = whole.bounds;
    for (std::size_t f = 0; f < faces; ++f) {
        const vec3 corner = whole.vertices[4 * f].position;
        const vec3 u = whole.vertices[4 * f + 1].position - corner;
        const vec3 v = whole.vertices[4 * f + 3].position - corner;
        // The same for every square that has it, bit for bit.
        const auto point = [&](int x, int y) {
            return corner + static_cast<float>(x) / static_cast<float>(side) * u +
                   static_cast<float>(y) / static_cast<float>(side) * v;
        };
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
                for (const vec3& p : {point(x, y), point(x + 1, y), point(x + 1, y + 1), point(x, y + 1)}) {
                    mesh.vertices.push_back(whole.vertices[4 * f]);
                    mesh.vertices.back().position = p;
                }
                for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
                    mesh.indices.push_back(first + i);
                }
            }
        }
    }
    return mesh;
}

// Without its lower face, on which it stands.
Mesh standing_box(const vec3& lower, const vec3& upper, int side) {
    Mesh whole = support::box(lower, upper, false, 0);
    whole.vertices.erase(whole.vertices.begin() + 8, whole.vertices.begin() + 12);  // y = lower
    return cut_box(whole, 5, side);
}

}  // namespace

FrameScene thesis_scene(int side) {
    FrameScene scene =
        support::scene_of({cut_box(support::box(vec3(-2), vec3(2), true, 0), 6, side),
                           standing_box(vec3(-1.2f, -2, -1.2f), vec3(-0.3f, -0.4f, -0.3f), side),
                           standing_box(vec3(0.4f, -2, 0), vec3(1.2f, -1.2f, 0.8f), side)},
                          {support::lambertian(vec3(0.7f))}, {support::point_light(vec3(1, 1, 0), 100)},
                          vec3(0, 0, 1.95f), vec3(0, -0.4f, 0));
    circle_light(scene, 0);
    return scene;
}

void circle_light(FrameScene& scene, int frame) {
    const float turn = 2 * kPi * static_cast<float>(frame) / 200;
    scene.lights[0].position = vec3(std::cos(turn), 1, std::sin(turn));
    if (frame > 0) {
        scene.changes = {};
        scene.changes.assets = scene.changes.geometry = scene.changes.camera = false;
    }
}

}  // namespace lanthorn::bench
