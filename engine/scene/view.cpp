#include "lanthorn/scene/view.h"
#include "engine/core/finite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanthorn {
namespace {

// Of views of whole scenes.
constexpr double kMargin = 1.08;       // of the picture's half side, that what is seen leaves free
constexpr float kFlat = 0.05f;         // height of a floor beside its length
constexpr float kSunk = 0.1f;          // of their height, that things may stand below a floor's top
constexpr float kMuchSmaller = 0.75f;  // of the whole's diagonal

bool unit(dvec3& v) {
    // Scaled first: the square of a very small or large length would not fit.
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) {
        return false;
    }
    v /= largest;
    v /= glm::length(v);
    return true;
}

CameraView view_of(const Camera& camera, const glm::dmat3& basis, const dvec3& position) {
    CameraView result;
    result.camera = camera;
    result.position = vec3(position);
    const glm::dmat3 to_view = glm::transpose(basis);
    dmat4 view(to_view);
    // Of the rounded position, so that both agree.
    view[3] = dvec4(-(to_view * dvec3(result.position)), 1);
    result.view = mat4(view);
    return result;
}

}  // namespace

bool orthonormal_basis(const dmat4& m, glm::dmat3& basis) {
    dvec3 x(m[0]), y(m[1]), z(m[2]);
    const bool have_x = unit(x), have_y = unit(y);
    if (!unit(z)) {
        // A flattened node: its other two axes still say where it faces.
        if (!have_x || !have_y) {
            return false;
        }
        z = glm::cross(x, y);
        if (glm::determinant(glm::dmat3(m)) < 0) {
            z = -z;
        }
        if (!unit(z)) {
            return false;
        }
    }
    if (have_y) {
        y -= glm::dot(y, z) * z;
    }
    if (!have_y || glm::length(y) < 1e-9) {
        y = have_x ? glm::cross(z, x) : dvec3(0);
        if (glm::length(y) < 1e-9) {
            y = glm::cross(z, std::abs(z.y) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 0, 1));
        }
    }
    if (!unit(y)) {
        return false;
    }
    basis = glm::dmat3(glm::cross(y, z), y, z);
    return true;
}

CameraView camera_view(const Camera& camera, const dmat4& world, const dvec3& origin) {
    glm::dmat3 basis(1);
    if (!orthonormal_basis(world, basis)) {
        basis = glm::dmat3(1);
    }
    return view_of(camera, basis, dvec3(world[3]) - origin);
}

CameraView frame_all(const Aabb& bounds) {
    Aabb box = bounds;
    if (box.empty() || !is_finite(box.lower) || !is_finite(box.upper) || !(box.diagonal() > 0)) {
        const vec3 centre =
            !box.empty() && is_finite(box.lower) && is_finite(box.upper) ? box.centre() : vec3(0);
        box = {centre - vec3(1), centre + vec3(1)};
    }
    Camera camera;
    const dvec3 back = glm::normalize(dvec3(0, 0.25, 1));
    const dvec3 right(1, 0, 0);
    const dvec3 up = glm::cross(back, right);
    // As near as its corners allow, and a little farther.
    const double slope = std::tan(0.5 * static_cast<double>(camera.y_fov)) / kMargin;
    const dvec3 half = 0.5 * dvec3(box.size());
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner = half * dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        const double aside = std::max(std::abs(glm::dot(corner, right)), std::abs(glm::dot(corner, up)));
        distance =
            std::max(distance, glm::dot(corner, back) + std::max(aside / slope, 0.1 * glm::length(half)));
    }
    camera.z_near = static_cast<float>(1e-3 * distance);
    return view_of(camera, glm::dmat3(right, up, back), dvec3(box.centre()) + distance * back);
}

// What stands on a floor that is much larger is what a picture is taken of.
CameraView frame_all(const FrameScene& scene) {
    const auto is_flat = [](const Aabb& box) {
        return box.size().y < kFlat * std::max(box.size().x, box.size().z);
    };
    Aabb things;
    float top = -std::numeric_limits<float>::infinity();
    for (const Instance& instance : scene.instances) {
        if (is_flat(instance.bounds)) {
            top = std::max(top, instance.bounds.upper.y);
        } else {
            things.add(instance.bounds);
        }
    }
    const bool on_floors = !things.empty() && top <= things.lower.y + kSunk * things.size().y;
    return frame_all(on_floors && things.diagonal() < kMuchSmaller * scene.bounds.diagonal() ? things
                                                                                             : scene.bounds);
}

mat4 projection_matrix(const Camera& camera, float aspect, float scene_diagonal) {
    const float diagonal = scene_diagonal > 0 && std::isfinite(scene_diagonal) ? scene_diagonal : 1.0f;
    mat4 p(0);
    if (camera.orthographic) {
        // The declared area is all visible; the image shows more of one side if its shape differs.
        float x = camera.x_mag, y = camera.y_mag;
        if (x < y * aspect) {
            x = y * aspect;
        } else {
            y = x / aspect;
        }
        const float z_near = camera.z_near;
        const float z_far = camera.z_far > z_near ? camera.z_far : z_near + 100 * diagonal;
        p[0][0] = 1 / x;
        p[1][1] = 1 / y;
        p[2][2] = -2 / (z_far - z_near);
        p[3][2] = -(z_far + z_near) / (z_far - z_near);
        p[3][3] = 1;
        return p;
    }
    const float z_near = camera.z_near > 0 ? camera.z_near : 1e-4f * diagonal;
    const float f = 1 / std::tan(0.5f * std::clamp(camera.y_fov, 1e-3f, kPi - 1e-3f));
    p[0][0] = f / aspect;
    p[1][1] = f;
    p[2][3] = -1;
    if (camera.z_far > z_near && std::isfinite(camera.z_far)) {
        p[2][2] = -(camera.z_far + z_near) / (camera.z_far - z_near);
        p[3][2] = -2 * camera.z_far * z_near / (camera.z_far - z_near);
    } else {
        p[2][2] = -1;
        p[3][2] = -2 * z_near;
    }
    return p;
}

}  // namespace lanthorn
