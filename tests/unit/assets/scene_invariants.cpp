#include "tests/unit/assets/scene_invariants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn {

namespace {

template <typename V>
bool finite(const V& v) {
    for (int i = 0; i < V::length(); ++i) {
        if (!std::isfinite(v[i])) {
            return false;
        }
    }
    return true;
}

bool unit(const vec3& v) {
    return std::abs(glm::length(v) - 1) < 1e-4f;
}

void expect_influences(const SkinInfluences& influences) {
    float sum = 0;
    float last = 1;
    for (const float weight : influences.weights) {
        ASSERT_TRUE(weight >= 0 && weight <= last);
        sum += weight;
        last = weight;
    }
    ASSERT_NEAR(sum, 1, 1e-5);
}

void expect_target(const MorphTarget& target, const Mesh& mesh) {
    ASSERT_EQ(target.positions.size(), target.vertices.size());
    ASSERT_TRUE(target.normals.empty() || target.normals.size() == target.vertices.size());
    ASSERT_TRUE(target.tangents.empty() || target.tangents.size() == target.vertices.size());
    for (std::size_t i = 0; i < target.vertices.size(); ++i) {
        ASSERT_LT(target.vertices[i], mesh.vertices.size());
        ASSERT_TRUE(i == 0 || target.vertices[i] > target.vertices[i - 1]);
        ASSERT_TRUE(finite(target.positions[i]));
        ASSERT_TRUE(target.normals.empty() || finite(target.normals[i]));
        ASSERT_TRUE(target.tangents.empty() || finite(target.tangents[i]));
    }
}

void expect_cage(const SubdivisionCage& cage, const Mesh& mesh) {
    EXPECT_TRUE(cage.level >= 1 && cage.level <= 5);
    std::size_t triangles = 0;
    for (const std::uint32_t corners : cage.face_sizes) {
        ASSERT_GE(corners, 3u);
        triangles += corners - 2;
    }
    EXPECT_TRUE(cage.face_sizes.empty() || triangles == mesh.indices.size() / 3);
    for (const SubdivisionCrease& crease : cage.creases) {
        EXPECT_TRUE(crease.from < mesh.vertices.size() && crease.to < mesh.vertices.size());
        EXPECT_TRUE(crease.sharpness >= 0 && std::isfinite(crease.sharpness));
    }
}

void expect_deformation(const Mesh& mesh) {
    ASSERT_TRUE(mesh.skin.empty() || mesh.skin.size() == mesh.vertices.size());
    for (const SkinInfluences& influences : mesh.skin) {
        expect_influences(influences);
    }
    for (const MorphTarget& target : mesh.morphs) {
        expect_target(target, mesh);
    }
    EXPECT_EQ(mesh.morph_weights.size(), mesh.morphs.size());
    if (mesh.cage) {
        expect_cage(*mesh.cage, mesh);
    }
}

// Every joint that a mesh uses must be in the skin.
void expect_skin(const NodeData& node, const SceneData& scene) {
    ASSERT_LT(node.skin, scene.skins.size());
    const std::size_t joints = scene.skins[node.skin].joints.size();
    ASSERT_FALSE(node.meshes.empty());
    for (const std::uint32_t mesh : node.meshes) {
        ASSERT_FALSE(scene.meshes[mesh].skin.empty());
        for (const SkinInfluences& influences : scene.meshes[mesh].skin) {
            for (const std::uint16_t joint : influences.joints) {
                ASSERT_LT(joint, joints);
            }
        }
    }
}

void expect_keys(const AnimationChannel& channel) {
    ASSERT_FALSE(channel.times.empty());
    for (std::size_t k = 0; k < channel.times.size(); ++k) {
        ASSERT_TRUE(std::isfinite(channel.times[k]));
        ASSERT_TRUE(k == 0 || channel.times[k] > channel.times[k - 1]);
    }
    const std::size_t parts = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
    ASSERT_GT(channel.width, 0u);
    ASSERT_EQ(channel.values.size(), channel.times.size() * channel.width * parts);
    for (const float value : channel.values) {
        ASSERT_TRUE(std::isfinite(value));
    }
}

void expect_property(const PropertyChannel& channel, const SceneData& scene) {
    const PropertyOwner owner = owner_of(channel.property);
    EXPECT_LT(channel.object, owner == PropertyOwner::light    ? scene.lights.size()
                              : owner == PropertyOwner::camera ? scene.cameras.size()
                                                               : scene.materials.size());
    EXPECT_EQ(channel.nodes.empty(), owner == PropertyOwner::material);
    for (const std::uint32_t node : channel.nodes) {
        ASSERT_LT(node, scene.nodes.size());
        EXPECT_EQ(owner == PropertyOwner::light ? scene.nodes[node].light : scene.nodes[node].camera,
                  channel.object);
    }
    EXPECT_EQ(channel.keys.width, width_of(channel.property));
    expect_keys(channel.keys);
}

void expect_mesh(const Mesh& mesh, const SceneData& scene) {
    SCOPED_TRACE(mesh.name);
    ASSERT_LT(mesh.material, scene.materials.size());
    ASSERT_GT(mesh.indices.size(), 0u);
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    for (const std::uint32_t index : mesh.indices) {
        ASSERT_LT(index, mesh.vertices.size());
    }
    Aabb bounds;
    for (const Vertex& vertex : mesh.vertices) {
        ASSERT_TRUE(finite(vertex.position) && finite(vertex.uv0) && finite(vertex.uv1) &&
                    finite(vertex.colour));
        ASSERT_TRUE(unit(vertex.normal));
        ASSERT_TRUE(unit(vec3(vertex.tangent)));
        ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f);
        ASSERT_LT(std::abs(glm::dot(vertex.normal, vec3(vertex.tangent))), 0.99995f);
        bounds.add(vertex.position);
    }
    EXPECT_EQ(bounds, mesh.bounds);
    expect_deformation(mesh);
}

void expect_texture(const TextureRef& ref, const SceneData& scene) {
    EXPECT_TRUE(!ref.present() || ref.texture < scene.textures.size());
    EXPECT_LE(ref.uv_set, 1u);
    EXPECT_TRUE(finite(ref.uv_transform[0]) && finite(ref.uv_transform[1]));
}

void expect_material(const Material& material, const SceneData& scene) {
    EXPECT_TRUE(finite(material.base_colour) && finite(material.emissive) &&
                finite(material.specular_colour));
    EXPECT_TRUE(material.metallic >= 0 && material.metallic <= 1);
    EXPECT_TRUE(material.roughness >= 0 && material.roughness <= 1);
    EXPECT_TRUE(material.transmission >= 0 && material.transmission <= 1);
    EXPECT_TRUE(material.ior >= 1 && std::isfinite(material.ior));
    EXPECT_TRUE(std::isfinite(material.normal_scale));
    for (const TextureRef& ref :
         {material.base_colour_texture, material.metallic_roughness_texture, material.normal_texture,
          material.occlusion_texture, material.emissive_texture, material.specular_texture,
          material.specular_colour_texture, material.transmission_texture}) {
        expect_texture(ref, scene);
    }
}

void expect_node(const NodeData& node, std::size_t index, const SceneData& scene) {
    EXPECT_TRUE(node.parent == kNone || node.parent < index);
    EXPECT_TRUE(node.camera == kNone || node.camera < scene.cameras.size());
    EXPECT_TRUE(node.light == kNone || node.light < scene.lights.size());
    for (const std::uint32_t mesh : node.meshes) {
        EXPECT_LT(mesh, scene.meshes.size());
    }
    EXPECT_TRUE(finite(node.local.translation) && finite(node.local.scale));
    EXPECT_NEAR(glm::length(node.local.rotation), 1, 1e-4);
    if (node.skin != kNone) {
        expect_skin(node, scene);
    }
    EXPECT_TRUE(finite(node.shear[0]) && finite(node.shear[1]) && finite(node.shear[2]));
}

}  // namespace

void expect_scene_invariants(const SceneData& scene) {
    EXPECT_FALSE(scene.source.empty());
    EXPECT_GE(scene.materials.size(), 1u);
    for (const Mesh& mesh : scene.meshes) {
        expect_mesh(mesh, scene);
    }
    for (const Material& material : scene.materials) {
        expect_material(material, scene);
    }
    for (const Texture& texture : scene.textures) {
        EXPECT_LT(texture.image, scene.images.size());
    }
    for (const Image& image : scene.images) {
        EXPECT_GT(image.width * image.height, 0u);
        EXPECT_EQ(image.rgba.size(), std::size_t{image.width} * image.height * 4);
    }
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        expect_node(scene.nodes[i], i, scene);
    }
    for (const Skin& skin : scene.skins) {
        EXPECT_EQ(skin.inverse_binds.size(), skin.joints.size());
        for (std::size_t j = 0; j < skin.joints.size(); ++j) {
            EXPECT_LT(skin.joints[j], scene.nodes.size());
            EXPECT_TRUE(finite(skin.inverse_binds[j][0]) && finite(skin.inverse_binds[j][3]));
        }
    }
    for (const AnimationClip& clip : scene.animations) {
        EXPECT_TRUE(std::isfinite(clip.duration) && clip.duration >= 0);
        EXPECT_FALSE(clip.channels.empty() && clip.properties.empty());
        for (const AnimationChannel& channel : clip.channels) {
            EXPECT_LT(channel.node, scene.nodes.size());
            expect_keys(channel);
        }
        for (const PropertyChannel& channel : clip.properties) {
            expect_property(channel, scene);
        }
    }
    for (const Light& light : scene.lights) {
        EXPECT_TRUE(finite(light.colour) && std::isfinite(light.intensity) && light.intensity >= 0);
        EXPECT_TRUE(light.range > 0);
        EXPECT_TRUE(light.inner_cone < light.outer_cone && light.outer_cone <= kPi / 2);
    }
    for (const Camera& camera : scene.cameras) {
        EXPECT_TRUE(camera.z_near >= 0 && (camera.z_far > camera.z_near || camera.z_far == 0));
        EXPECT_TRUE(camera.y_fov > 0 && camera.y_fov < kPi && camera.x_mag > 0 && camera.y_mag > 0);
    }
    for (const std::string& warning : scene.warnings) {
        EXPECT_EQ(warning.find('\n'), std::string::npos) << warning;
    }
}

void expect_places_in(const InputError& error, const std::filesystem::path& file) {
    const std::string line = error.what();
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_EQ(line.find_first_of("\r\n"), std::string::npos) << line;
    ASSERT_TRUE(line.starts_with(file.string() + ": ")) << line;
    const std::string rest = line.substr(file.string().size() + 2);
    EXPECT_NE(rest.find(": "), std::string::npos) << "no place in: " << line;
    EXPECT_FALSE(rest.starts_with(":")) << "an empty place in: " << line;
}

}  // namespace lanthorn
