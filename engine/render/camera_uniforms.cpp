#include "lanthorn/render/camera_uniforms.h"

#include <cmath>

#include "engine/render/projection.h"

namespace lanthorn::render {

CameraUniforms CameraUniforms::from(const CameraView& view, float aspect) {
    CameraUniforms u;
    const mat3 axes = glm::transpose(mat3(view.view));  // columns: the camera's axes in render space
    const float half_height =
        view.camera.orthographic ? view.camera.y_mag : std::tan(0.5f * view.camera.y_fov);
    u.position = view.position;
    u.right = axes[0] * (half_height * aspect);
    u.up = axes[1] * half_height;
    u.forward = -axes[2];
    u.orthographic = view.camera.orthographic;
    u.clip_from_relative = reversed_projection(view.camera, aspect) * mat4(mat3(view.view));
    return u;
}

CameraUniforms CameraUniforms::shifted(vec2 pixels, ivec2 size) const {
    CameraUniforms u = *this;
    const vec2 by = 2.0f * pixels / vec2(size);  // of half the picture
    const vec3 aside = by.x * right + by.y * up;
    u.shift += pixels;
    if (orthographic) {
        u.position += aside;
        return u;
    }
    u.forward += aside;
    for (int column = 0; column < 4; ++column) {
        u.clip_from_relative[column].x -= by.x * clip_from_relative[column].w;
        u.clip_from_relative[column].y -= by.y * clip_from_relative[column].w;
    }
    return u;
}

}  // namespace lanthorn::render
