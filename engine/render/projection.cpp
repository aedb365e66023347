#include "engine/render/projection.h"

#include <cmath>

namespace lanthorn::render {

mat4 reversed_projection(const Camera& camera, float aspect) {
    mat4 m(0.0f);
    if (camera.orthographic) {
        const float z_far =
            camera.z_far > camera.z_near ? camera.z_far : camera.z_near + 1000 * std::abs(camera.y_mag);
        const float depth = z_far - camera.z_near;
        m[0][0] = 1 / (camera.y_mag * aspect);
        m[1][1] = 1 / camera.y_mag;
        m[2][2] = 1 / depth;
        m[3][2] = z_far / depth;
        m[3][3] = 1;
        return m;
    }
    const float focal = 1 / std::tan(0.5f * camera.y_fov);
    m[0][0] = focal / aspect;
    m[1][1] = focal;
    m[2][3] = -1;
    m[3][2] = camera.z_near;
    return m;
}

}  // namespace lanthorn::render
