#include "lanthorn/scene/asset_version.h"

#include <atomic>

namespace lanthorn {

std::uint64_t next_asset_version() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

namespace {

bool cuts(const Material& m) {
    return m.alpha_mode != AlphaMode::opaque;
}

// Factors that are multiplied with the texture's alpha; vertex colours are the mesh's.
bool same_surface(const Material& a, const Material& b) {
    if (a.double_sided != b.double_sided || a.alpha_mode != b.alpha_mode) {
        return false;
    }
    return !cuts(a) || (a.alpha_cutoff == b.alpha_cutoff && a.base_colour.a == b.base_colour.a &&
                        a.base_colour_texture == b.base_colour_texture);
}

// Of what it reflects of even light all but the base colour's factor.
bool same_pattern(const Material& a, const Material& b) {
    return a.metallic == b.metallic && a.roughness == b.roughness && a.transmission == b.transmission &&
           a.ior == b.ior && a.specular == b.specular && a.specular_colour == b.specular_colour &&
           a.unlit == b.unlit && a.base_colour_texture == b.base_colour_texture &&
           a.metallic_roughness_texture == b.metallic_roughness_texture &&
           a.transmission_texture == b.transmission_texture;
}

bool same_emission(const Material& a, const Material& b) {
    return a.emissive == b.emissive && a.emissive_texture == b.emissive_texture;
}

bool same_relief(const Material& a, const Material& b) {
    return a.normal_scale == b.normal_scale && a.normal_texture == b.normal_texture;
}

bool shows(const TextureRef& reference, std::uint32_t texture) {
    return reference.present() && reference.texture == texture;
}

}  // namespace

AssetVersion<Material> AssetVersion<Material>::edited(const Material& before, const Material& now,
                                                      std::uint64_t next) const {
    AssetVersion version = *this;
    version.any = next;
    if (!same_surface(before, now)) {
        version.surface = next;
    }
    if (!same_pattern(before, now)) {
        version.albedo = version.pattern = next;
    }
    if (vec3(before.base_colour) != vec3(now.base_colour)) {
        version.albedo = next;
    }
    if (!same_emission(before, now)) {
        version.emission = next;
    }
    if (!same_relief(before, now)) {
        version.relief = next;
    }
    return version;
}

AssetVersion<Material> AssetVersion<Material>::retextured(const Material& m, std::uint32_t texture,
                                                          std::uint64_t next) const {
    AssetVersion version = *this;
    bool used = false;
    for (const TextureRef* reference : m.textures()) {
        used = used || shows(*reference, texture);
    }
    if (!used) {
        return version;
    }
    version.any = next;
    if (cuts(m) && shows(m.base_colour_texture, texture)) {
        version.surface = next;
    }
    if (shows(m.base_colour_texture, texture) || shows(m.metallic_roughness_texture, texture) ||
        shows(m.transmission_texture, texture)) {
        version.albedo = version.pattern = next;
    }
    if (shows(m.emissive_texture, texture)) {
        version.emission = next;
    }
    if (shows(m.normal_texture, texture)) {
        version.relief = next;
    }
    return version;
}

}  // namespace lanthorn
