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

}  // namespace lanthorn::render
