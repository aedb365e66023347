#include "tools/workbench/measure/measured_scene.h"

#include <limits>

namespace lanthorn::workbench {

bool ExactSurfaces::receives(std::uint32_t instance, bool front) const {
    const reference::MaterialConstants& material = materials[scene.instances()[instance].material];
    return !material.unlit && !material.blend && (front || material.double_sided);
}

std::optional<PhotonArrival> ExactSurfaces::arrival(const vec3& origin, const vec3& direction) const {
    PhotonArrival result;
    const float nearest = 1e-4f * scene.frame().diagonal();
    if (!scene.intersect(origin, direction, nearest, std::numeric_limits<float>::infinity(),
                         reference::Blended::solid, result.hit)) {
        return std::nullopt;
    }
    if (!receives(result.hit.instance, result.hit.front)) {
        scene.prefer_front(origin, direction, reference::Blended::solid, result.hit);
    }
    result.receives = receives(result.hit.instance, result.hit.front);
    return result;
}

}  // namespace lanthorn::workbench
