// Materials, textures and images: the metallic-roughness model of glTF 2.0 and the extensions we read.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

inline constexpr std::uint32_t kNoTexture = 0xffffffffu;

// What lies outside 0..1 of a texture's coordinates.
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };
// The nearest texel, or those around blended.
enum class Filter : std::uint8_t { nearest, linear };
// What base colour's alpha does: nothing, cut holes where it is below alpha_cutoff, or blend.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

// A decoded image: 8 bits a channel, 4 channels, rows from the top. sRGB or linear is decided by its use.
struct Image {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;  // width * height * 4
};

// How a texture is read between and beyond its texels.
struct Sampler {
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    Filter mag = Filter::linear;
    Filter min = Filter::linear;
    bool mipmaps = true;
};

// An image seen through a sampler.
struct Texture {
    std::uint32_t image = 0;  // index into SceneData's or SceneAssets::images
    Sampler sampler;
};

// A texture as a material uses it, with KHR_texture_transform folded into a 2x3 affine map of the UVs.
struct TextureRef {
    std::uint32_t texture = kNoTexture;  // index into SceneData's or SceneAssets::textures
    std::uint32_t uv_set = 0;            // 0 or 1
    std::array<vec3, 2> uv_transform{vec3(1, 0, 0),
                                     vec3(0, 1, 0)};  // u' = dot(row 0, (u, v, 1)), v' likewise

    bool present() const { return texture != kNoTexture; }  // false: the factor counts alone
    bool operator==(const TextureRef&) const = default;
};

struct Material {
    std::string name;
    vec4 base_colour{1};  // linear RGBA factor
    float metallic = 1;   // 0..1
    float roughness = 1;  // 0..1, perceptual
    vec3 emissive{0};     // linear factor times KHR_materials_emissive_strength: nits (cd/m^2)
    float normal_scale = 1;
    float occlusion_strength = 1;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;  // KHR_materials_unlit
    float ior = 1.5f;    // KHR_materials_ior, >= 1 (0 of the specification is stored as 1e3)
    float specular = 1;  // KHR_materials_specular
    vec3 specular_colour{1};
    float transmission = 0;  // KHR_materials_transmission, 0..1
    // KHR_materials_volume. 0: a thin wall, which bends no light. More: the surface bounds a volume of this
    // `ior`, in which light is refracted and absorbed; by how much it is more says nothing to who traces
    // rays.
    float thickness = 0;  // metres
    float attenuation_distance =
        0;                       // metres after which attenuation_colour is left of white light; 0: all is
    vec3 attenuation_colour{1};  // 0..1

    TextureRef base_colour_texture;         // sRGB
    TextureRef metallic_roughness_texture;  // G roughness, B metallic
    TextureRef normal_texture;
    TextureRef occlusion_texture;        // R
    TextureRef emissive_texture;         // sRGB
    TextureRef specular_texture;         // A
    TextureRef specular_colour_texture;  // sRGB
    TextureRef transmission_texture;     // R

    // All that it may use, in the order in which shaders number them.
    std::array<const TextureRef*, 8> textures() const {
        return {&base_colour_texture,     &metallic_roughness_texture, &normal_texture,
                &occlusion_texture,       &emissive_texture,           &specular_texture,
                &specular_colour_texture, &transmission_texture};
    }

    // The same to write.
    std::array<TextureRef*, 8> textures() {
        return {&base_colour_texture,     &metallic_roughness_texture, &normal_texture,
                &occlusion_texture,       &emissive_texture,           &specular_texture,
                &specular_colour_texture, &transmission_texture};
    }

    // Else the surface is a thin wall or lets nothing through.
    bool bounds_volume() const { return transmission > 0 && thickness > 0; }
    // Beer's law: a path of length s in the volume leaves exp(-absorption() * s). 1/metres.
    vec3 absorption() const;
    // By its factor; a texture may be black all the same.
    bool emits() const { return emissive.x > 0 || emissive.y > 0 || emissive.z > 0; }
};

}  // namespace lanthorn
