#include "engine/assets/gltf_pointers.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace lanthorn {

namespace {

using enum AnimatedProperty;

struct Entry {
    std::string_view list, member;
    AnimatedProperty property;
};

constexpr std::string_view kLights = "/extensions/KHR_lights_punctual/lights/", kCameras = "/cameras/",
                           kMaterials = "/materials/";
constexpr std::array<Entry, 27> kEntries = {{
    {kLights, "color", light_colour},
    {kLights, "intensity", light_intensity},
    {kLights, "range", light_range},
    {kLights, "spot/innerConeAngle", light_inner_cone},
    {kLights, "spot/outerConeAngle", light_outer_cone},
    {kCameras, "perspective/yfov", camera_y_fov},
    {kCameras, "perspective/znear", camera_z_near},
    {kCameras, "perspective/zfar", camera_z_far},
    {kCameras, "orthographic/xmag", camera_x_mag},
    {kCameras, "orthographic/ymag", camera_y_mag},
    {kCameras, "orthographic/znear", camera_z_near},
    {kCameras, "orthographic/zfar", camera_z_far},
    {kMaterials, "pbrMetallicRoughness/baseColorFactor", base_colour},
    {kMaterials, "pbrMetallicRoughness/metallicFactor", metallic},
    {kMaterials, "pbrMetallicRoughness/roughnessFactor", roughness},
    {kMaterials, "emissiveFactor", emissive},
    {kMaterials, "extensions/KHR_materials_emissive_strength/emissiveStrength", emissive_scale},
    {kMaterials, "normalTexture/scale", normal_scale},
    {kMaterials, "occlusionTexture/strength", occlusion_strength},
    {kMaterials, "alphaCutoff", alpha_cutoff},
    {kMaterials, "extensions/KHR_materials_ior/ior", ior},
    {kMaterials, "extensions/KHR_materials_specular/specularFactor", specular},
    {kMaterials, "extensions/KHR_materials_specular/specularColorFactor", specular_colour},
    {kMaterials, "extensions/KHR_materials_transmission/transmissionFactor", transmission},
    {kMaterials, "extensions/KHR_materials_volume/thicknessFactor", thickness},
    {kMaterials, "extensions/KHR_materials_volume/attenuationDistance", attenuation_distance},
    {kMaterials, "extensions/KHR_materials_volume/attenuationColor", attenuation_colour},
}};

}  // namespace

std::optional<PointedProperty> pointed_property(std::string_view pointer) {
    for (const Entry& entry : kEntries) {
        if (!pointer.starts_with(entry.list)) {
            continue;
        }
        const char* end = pointer.data() + pointer.size();
        PointedProperty result{entry.property, 0};
        const auto [rest, error] = std::from_chars(pointer.data() + entry.list.size(), end, result.object);
        if (error == std::errc() && rest != end && *rest == '/' &&
            std::string_view(rest + 1, static_cast<std::size_t>(end - rest - 1)) == entry.member) {
            return result;
        }
    }
    return std::nullopt;
}

std::string pointer_to(const PointedProperty& target, bool orthographic) {
    const std::string_view other = orthographic ? "perspective/" : "orthographic/";
    for (const Entry& entry : kEntries) {
        if (entry.property == target.property && !entry.member.starts_with(other)) {
            return fmt::format("{}{}/{}", entry.list, target.object, entry.member);
        }
    }
    return {};
}

}  // namespace lanthorn
