#include "tools/editor/window/projector.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::edit_window {

Projector::Projector(const CameraView& look, const dvec3& origin, const Box& box)
    : look_(look), origin_(origin), eye_(origin + dvec3(look.position)), box_(box) {
    axes_ = glm::transpose(glm::dmat3(glm::mat3(look.view)));
    focal_ = look.camera.orthographic
                 ? box.height / (2 * std::max(1e-9, static_cast<double>(look.camera.y_mag)))
                 : box.height / (2 * std::tan(static_cast<double>(look.camera.y_fov) / 2));
}

vec2 Projector::on_screen(const dvec3& view) const {
    const double depth = look_.camera.orthographic ? 1 : -view.z;
    return {static_cast<float>(box_.x + box_.width / 2 + focal_ * view.x / depth),
            static_cast<float>(box_.y + box_.height / 2 - focal_ * view.y / depth)};
}

std::optional<vec2> Projector::at(const dvec3& world) const {
    const dvec3 view = in_view(world);
    if (!look_.camera.orthographic && -view.z < static_cast<double>(look_.camera.z_near)) {
        return std::nullopt;
    }
    return on_screen(view);
}

std::optional<std::pair<vec2, vec2>> Projector::line(const dvec3& from, const dvec3& to) const {
    dvec3 a = in_view(from), b = in_view(to);
    if (!look_.camera.orthographic) {
        const double plane = -static_cast<double>(look_.camera.z_near);
        if (a.z > plane && b.z > plane) {
            return std::nullopt;
        }
        if (a.z > plane) {
            a = glm::mix(a, b, (plane - a.z) / (b.z - a.z));
        } else if (b.z > plane) {
            b = glm::mix(b, a, (plane - b.z) / (a.z - b.z));
        }
    }
    return std::pair(on_screen(a), on_screen(b));
}

double Projector::pixels_a_metre(const dvec3& world) const {
    if (look_.camera.orthographic) {
        return focal_;
    }
    return focal_ / std::max(1e-6, -in_view(world).z);
}

PickRay Projector::ray(const vec2& pixel) const {
    const ivec2 size(std::max(1, static_cast<int>(box_.width)), std::max(1, static_cast<int>(box_.height)));
    return pick_ray(look_, origin_, size, glm::dvec2(pixel.x - box_.x, pixel.y - box_.y));
}

}  // namespace lanthorn::edit_window
