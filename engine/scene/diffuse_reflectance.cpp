#include "lanthorn/scene/diffuse_reflectance.h"

#include <algorithm>

namespace lanthorn {

MaterialReflectance MaterialReflectance::of(const Material& m) {
    const float r = (m.ior - 1) / (m.ior + 1);
    const float f0 =
        std::min(r * r * glm::dot(m.specular_colour, vec3(0.2126f, 0.7152f, 0.0722f)), 1.0f) * m.specular;
    // As in brdf.glsl: a dielectric without specular reflection has none at grazing angles either.
    const float f90 = std::min(50 * f0, 1.0f);
    const vec2 share = mean_brdf_share(m.roughness);
    MaterialReflectance result;
    if (!m.unlit) {
        const float metallic = m.metallic_roughness_texture.present() ? 0.0f : m.metallic;
        const float transmission = m.transmission_texture.present() ? 0.0f : m.transmission;
        result.boundary = (1 - metallic) * (1 - transmission) * (f0 * share.x + f90 * share.y);
    }
    // The mean of (1 - cos)^5 over even light is 1 / 21.
    const float passes = 1 - f0 - (f90 - f0) / 21;
    result.transmittance = passes * passes;
    result.evenly = is_mirror(m) ? 0.0f : 1.0f;
    return result;
}

}  // namespace lanthorn
