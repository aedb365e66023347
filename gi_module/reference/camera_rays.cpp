#include "gi_module/reference/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanthorn::reference {

CameraRays::CameraRays(const CameraView& view, ivec2 size) : position_(view.position), size_(size) {
    const mat3 axes = glm::transpose(mat3(view.view));  // columns: the camera's axes in render space
    const Camera& camera = view.camera;
    const float aspect = size_.x / size_.y;
    const float half_height = camera.orthographic ? camera.y_mag : std::tan(0.5f * camera.y_fov);
    right_ = axes[0] * (half_height * aspect);
    up_ = axes[1] * half_height;
    forward_ = -axes[2];
    orthographic_ = camera.orthographic;
    near_ = camera.z_near;
    far_ = std::numeric_limits<float>::infinity();
    if (orthographic_) {
        far_ = camera.z_far > near_ ? camera.z_far : near_ + 1000 * std::abs(camera.y_mag);
    }
}

CameraRay CameraRays::ray(float x, float y) const {
    const vec3 across = right_ * (2 * x / size_.x - 1) + up_ * (1 - 2 * y / size_.y);
    if (orthographic_) {
        return {position_ + across, forward_, std::max(near_, 0.0f), far_};
    }
    const vec3 d = forward_ + across;
    const float length = glm::length(d);
    return {position_, d / length, std::max(near_, 0.0f) * length, far_};
}

}  // namespace lanthorn::reference
