// A lattice of points on a floor, as a camera above it sees them.
#pragma once

#include "gi_module/techniques/coarse-path/point_history.h"
#include "tests/support/scenes.h"

namespace lanthorn::gi::test {

inline constexpr int kSide = 64;  // pixels

// From 2 m above (x, z), looking down upright.
inline PointView above(float x, float z, const dvec3& origin = dvec3(0)) {
    FrameScene scene;
    support::look(scene, vec3(x, 2, z), vec3(x, 0, z));
    return {render::CameraUniforms::from(scene.camera, 1), origin};
}

// Where the ray through a pixel's centre meets the plane y = `height`.
inline SurfacePoint floor_point(const PointView& view, ivec2 pixel, float height = 0) {
    const vec2 p = (vec2(pixel) + 0.5f) / static_cast<float>(kSide) * 2.0f - 1.0f;
    const render::CameraUniforms& camera = view.camera;
    const vec3 direction = glm::normalize(camera.forward + camera.right * p.x + camera.up * p.y);
    const float distance = (height - camera.position.y) / direction.y;
    return {camera.position + direction * distance, distance, vec3(0, 1, 0),
            static_cast<std::uint32_t>(pixel.x | pixel.y << 16)};
}

inline GridPoints floor_points(const PointView& view, int spacing, float height = 0) {
    GridPoints points{ivec2(kSide), spacing, ivec2((kSide + spacing - 1) / spacing), {}};
    for (int y = 0; y < points.cells.y; ++y) {
        for (int x = 0; x < points.cells.x; ++x) {
            points.points.push_back(floor_point(view, spacing * ivec2(x, y), height));
        }
    }
    return points;
}

}  // namespace lanthorn::gi::test
