#include "tests/unit/assets/same_scene.h"

#include <gtest/gtest.h>

#include <cstring>

namespace lanthorn {

namespace {

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    static_assert(std::is_trivially_copyable_v<T>);
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same_node(const NodeData& a, const NodeData& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_TRUE(a.local == b.local);
    EXPECT_EQ(a.shear, b.shear);
    EXPECT_EQ(a.meshes, b.meshes);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.light, b.light);
    EXPECT_EQ(a.skin, b.skin);
    EXPECT_EQ(a.morph_weights, b.morph_weights);
    EXPECT_EQ(a.extras, b.extras);
}

void expect_same_mesh(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_TRUE(same_bits(a.vertices, b.vertices));
    EXPECT_TRUE(same_bits(a.indices, b.indices));
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.bounds.lower, b.bounds.lower);
    EXPECT_EQ(a.bounds.upper, b.bounds.upper);
    EXPECT_EQ(a.skin, b.skin);
    EXPECT_EQ(a.morph_weights, b.morph_weights);
    ASSERT_EQ(a.morphs.size(), b.morphs.size());
    for (std::size_t i = 0; i < a.morphs.size(); ++i) {
        EXPECT_EQ(a.morphs[i].vertices, b.morphs[i].vertices);
        EXPECT_TRUE(same_bits(a.morphs[i].positions, b.morphs[i].positions));
        EXPECT_TRUE(same_bits(a.morphs[i].normals, b.morphs[i].normals));
        EXPECT_TRUE(same_bits(a.morphs[i].tangents, b.morphs[i].tangents));
    }
    ASSERT_EQ(a.cage.has_value(), b.cage.has_value());
    if (a.cage) {
        EXPECT_EQ(a.cage->scheme, b.cage->scheme);
        EXPECT_EQ(a.cage->level, b.cage->level);
        EXPECT_EQ(a.cage->face_sizes, b.cage->face_sizes);
        EXPECT_EQ(a.cage->creases, b.cage->creases);
    }
}

void expect_same_texture_ref(const TextureRef& a, const TextureRef& b) {
    EXPECT_EQ(a.texture, b.texture);
    EXPECT_EQ(a.uv_set, b.uv_set);
    EXPECT_EQ(a.uv_transform, b.uv_transform);
}

void expect_same_material(const Material& a, const Material& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.base_colour, b.base_colour);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.normal_scale, b.normal_scale);
    EXPECT_EQ(a.occlusion_strength, b.occlusion_strength);
    EXPECT_EQ(a.alpha_mode, b.alpha_mode);
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    EXPECT_EQ(a.double_sided, b.double_sided);
    EXPECT_EQ(a.unlit, b.unlit);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.specular_colour, b.specular_colour);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.thickness, b.thickness);
    EXPECT_EQ(a.attenuation_distance, b.attenuation_distance);
    EXPECT_EQ(a.attenuation_colour, b.attenuation_colour);
    expect_same_texture_ref(a.base_colour_texture, b.base_colour_texture);
    expect_same_texture_ref(a.metallic_roughness_texture, b.metallic_roughness_texture);
    expect_same_texture_ref(a.normal_texture, b.normal_texture);
    expect_same_texture_ref(a.occlusion_texture, b.occlusion_texture);
    expect_same_texture_ref(a.emissive_texture, b.emissive_texture);
    expect_same_texture_ref(a.specular_texture, b.specular_texture);
    expect_same_texture_ref(a.specular_colour_texture, b.specular_colour_texture);
    expect_same_texture_ref(a.transmission_texture, b.transmission_texture);
}

void expect_same_texture(const Texture& a, const Texture& b) {
    EXPECT_EQ(a.image, b.image);
    EXPECT_EQ(a.sampler.wrap_s, b.sampler.wrap_s);
    EXPECT_EQ(a.sampler.wrap_t, b.sampler.wrap_t);
    EXPECT_EQ(a.sampler.mag, b.sampler.mag);
    EXPECT_EQ(a.sampler.min, b.sampler.min);
    EXPECT_EQ(a.sampler.mipmaps, b.sampler.mipmaps);
}

void expect_same_image(const Image& a, const Image& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_TRUE(a.rgba == b.rgba);
}

void expect_same_skin(const Skin& a, const Skin& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_TRUE(same_bits(a.inverse_binds, b.inverse_binds));
}

void expect_same_clip(const AnimationClip& a, const AnimationClip& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.duration, b.duration);
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (std::size_t i = 0; i < a.channels.size(); ++i) {
        EXPECT_EQ(a.channels[i].node, b.channels[i].node);
        EXPECT_EQ(a.channels[i].path, b.channels[i].path);
        EXPECT_EQ(a.channels[i].interpolation, b.channels[i].interpolation);
        EXPECT_EQ(a.channels[i].width, b.channels[i].width);
        EXPECT_EQ(a.channels[i].times, b.channels[i].times);
        EXPECT_EQ(a.channels[i].values, b.channels[i].values);
    }
    ASSERT_EQ(a.properties.size(), b.properties.size());
    for (std::size_t i = 0; i < a.properties.size(); ++i) {
        EXPECT_EQ(a.properties[i].property, b.properties[i].property);
        EXPECT_EQ(a.properties[i].object, b.properties[i].object);
        EXPECT_EQ(a.properties[i].nodes, b.properties[i].nodes);
        EXPECT_EQ(a.properties[i].rest, b.properties[i].rest);
        EXPECT_EQ(a.properties[i].keys.interpolation, b.properties[i].keys.interpolation);
        EXPECT_EQ(a.properties[i].keys.times, b.properties[i].keys.times);
        EXPECT_EQ(a.properties[i].keys.values, b.properties[i].keys.values);
    }
}

template <typename T>
void expect_same_list(const char* what, const std::vector<T>& a, const std::vector<T>& b,
                      void (*expect_same)(const T&, const T&)) {
    SCOPED_TRACE(what);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(i);
        expect_same(a[i], b[i]);
    }
}

}  // namespace

void expect_same_scene(const SceneData& a, const SceneData& b) {
    expect_same_list("nodes", a.nodes, b.nodes, expect_same_node);
    expect_same_list("meshes", a.meshes, b.meshes, expect_same_mesh);
    expect_same_list("materials", a.materials, b.materials, expect_same_material);
    expect_same_list("textures", a.textures, b.textures, expect_same_texture);
    expect_same_list("images", a.images, b.images, expect_same_image);
    EXPECT_EQ(a.cameras, b.cameras);
    EXPECT_EQ(a.lights, b.lights);
    expect_same_list("skins", a.skins, b.skins, expect_same_skin);
    expect_same_list("animations", a.animations, b.animations, expect_same_clip);
}

}  // namespace lanthorn
