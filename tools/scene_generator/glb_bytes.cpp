#include "tools/scene_generator/glb_bytes.h"

#include <algorithm>
#include <set>

#include "tools/scene_generator/glb_buffer.h"
#include "tools/scene_generator/glb_motion.h"
#include "tools/scene_generator/png_bytes.h"

namespace lanthorn::scene_generator {

namespace {

using nlohmann::json;

template <typename V>
json numbers(const V& v) {
    json result = json::array();
    for (int i = 0; i < static_cast<int>(v.length()); ++i) {
        if constexpr (std::is_same_v<typename V::value_type, double>) {
            result.push_back(v[i] == 0 ? 0.0 : v[i]);
        } else {
            result.push_back(number(v[i]));
        }
    }
    return result;
}

class Writer {
  public:
    explicit Writer(const SceneData& scene) : scene_(scene) {}

    std::string bytes() {
        root_["asset"] = {{"generator", "lanthorn generate_scenes"}, {"version", "2.0"}};
        write_images();
        write_materials();
        write_cameras();
        write_lights();
        write_nodes();
        write_skins(buffer_, scene_);
        write_animations(buffer_, scene_);
        if (!extensions_.empty()) {
            root_["extensionsUsed"] = extensions_;
        }

        return buffer_.bytes();
    }

  private:
    json primitive(const Mesh& mesh) {
        constexpr int kArrayBuffer = GlbBuffer::kArrayBuffer, kFloat = GlbBuffer::kFloat;
        std::string positions, normals, uvs, indices;
        for (const Vertex& v : mesh.vertices) {
            for (int i = 0; i < 3; ++i) {
                append_f32(positions, v.position[i]);
                append_f32(normals, v.normal[i]);
            }
            append_f32(uvs, v.uv0.x);
            append_f32(uvs, v.uv0.y);
        }
        const bool wide = mesh.vertices.size() > 0xffff;
        for (const std::uint32_t index : mesh.indices) {
            if (wide) {
                append_u32(indices, index);
            } else {
                append_u16(indices, static_cast<std::uint16_t>(index));
            }
        }
        const std::size_t count = mesh.vertices.size();
        json attributes;
        const std::size_t position = buffer_.add_accessor(positions, kArrayBuffer, "VEC3", kFloat, count);
        root_["accessors"][position]["min"] = numbers(mesh.bounds.lower);
        root_["accessors"][position]["max"] = numbers(mesh.bounds.upper);
        attributes["POSITION"] = position;
        attributes["NORMAL"] = buffer_.add_accessor(normals, kArrayBuffer, "VEC3", kFloat, count);
        if (scene_.materials[mesh.material].base_colour_texture.present()) {
            attributes["TEXCOORD_0"] = buffer_.add_accessor(uvs, kArrayBuffer, "VEC2", kFloat, count);
        }
        json out = {{"attributes", attributes},
                    {"indices",
                     buffer_.add_accessor(indices, GlbBuffer::kElementArrayBuffer, "SCALAR",
                                          wide ? GlbBuffer::kInt : GlbBuffer::kShort, mesh.indices.size())},
                    {"material", mesh.material}};
        add_deformation(buffer_, mesh, out);
        return out;
    }

    // A glTF mesh is a list of primitives: one for every different list of the nodes.
    std::size_t gltf_mesh(const std::vector<std::uint32_t>& primitives) {
        const auto known = std::find(mesh_lists_.begin(), mesh_lists_.end(), primitives);
        if (known != mesh_lists_.end()) {
            return static_cast<std::size_t>(known - mesh_lists_.begin());
        }
        json list = json::array();
        for (const std::uint32_t index : primitives) {
            list.push_back(primitive(scene_.meshes[index]));
        }
        const Mesh& first = scene_.meshes[primitives.front()];
        root_["meshes"].push_back({{"name", first.name}, {"primitives", list}});
        for (const float weight : first.morph_weights) {
            root_["meshes"].back()["weights"].push_back(number(weight));
        }
        mesh_lists_.push_back(primitives);
        return mesh_lists_.size() - 1;
    }

    void write_images() {
        for (const Image& image : scene_.images) {
            root_["images"].push_back({{"bufferView", buffer_.add_view(png_bytes(image), 0)},
                                       {"mimeType", "image/png"},
                                       {"name", image.name}});
        }
        for (const Texture& texture : scene_.textures) {
            constexpr int kWrap[] = {10497, 33071, 33648};
            const Sampler& s = texture.sampler;
            const bool smooth = s.min == Filter::linear;
            root_["samplers"].push_back(
                {{"magFilter", s.mag == Filter::linear ? 9729 : 9728},
                 {"minFilter", s.mipmaps ? (smooth ? 9987 : 9984) : (smooth ? 9729 : 9728)},
                 {"wrapS", kWrap[static_cast<int>(s.wrap_s)]},
                 {"wrapT", kWrap[static_cast<int>(s.wrap_t)]}});
            root_["textures"].push_back(
                {{"sampler", root_["samplers"].size() - 1}, {"source", texture.image}});
        }
    }

    void write_materials() {
        for (const Material& m : scene_.materials) {
            json pbr = {{"baseColorFactor", numbers(m.base_colour)},
                        {"metallicFactor", number(m.metallic)},
                        {"roughnessFactor", number(m.roughness)}};
            if (m.base_colour_texture.present()) {
                pbr["baseColorTexture"] = {{"index", m.base_colour_texture.texture}};
            }
            json out = {{"name", m.name}, {"pbrMetallicRoughness", pbr}};
            if (m.double_sided) {
                out["doubleSided"] = true;
            }
            if (m.specular != 1) {
                extensions_.insert("KHR_materials_specular");
                out["extensions"]["KHR_materials_specular"] = {{"specularFactor", number(m.specular)}};
            }
            if (m.emits()) {
                const float strength = std::max({m.emissive.x, m.emissive.y, m.emissive.z, 1.0f});
                out["emissiveFactor"] = numbers(m.emissive / strength);
                if (strength != 1) {
                    extensions_.insert("KHR_materials_emissive_strength");
                    out["extensions"]["KHR_materials_emissive_strength"] = {
                        {"emissiveStrength", number(strength)}};
                }
            }
            root_["materials"].push_back(out);
        }
    }

    void write_cameras() {
        for (const Camera& camera : scene_.cameras) {
            json perspective = {{"yfov", number(camera.y_fov)}, {"znear", number(camera.z_near)}};
            if (camera.z_far > 0) {
                perspective["zfar"] = number(camera.z_far);
            }
            root_["cameras"].push_back({{"type", "perspective"}, {"perspective", perspective}});
        }
    }

    void write_lights() {
        constexpr const char* kType[] = {"directional", "point", "spot"};
        for (const Light& light : scene_.lights) {
            extensions_.insert("KHR_lights_punctual");
            json out = {{"type", kType[static_cast<int>(light.type)]},
                        {"color", numbers(light.colour)},
                        {"intensity", number(light.intensity)}};
            if (std::isfinite(light.range)) {
                out["range"] = number(light.range);
            }
            if (light.type == LightType::spot) {
                out["spot"] = {{"innerConeAngle", number(light.inner_cone)},
                               {"outerConeAngle", number(light.outer_cone)}};
            }
            root_["extensions"]["KHR_lights_punctual"]["lights"].push_back(out);
        }
    }

    void write_nodes() {
        json nodes = json::array(), roots = json::array();
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            const NodeData& node = scene_.nodes[i];
            json out = {{"name", node.name}};
            if (node.local.translation != dvec3(0)) {
                out["translation"] = numbers(node.local.translation);
            }
            const quat& q = node.local.rotation;
            if (q != quat(1, 0, 0, 0)) {
                out["rotation"] = numbers(vec4(q.x, q.y, q.z, q.w));
            }
            if (node.local.scale != vec3(1)) {
                out["scale"] = numbers(node.local.scale);
            }
            if (!node.meshes.empty()) {
                out["mesh"] = gltf_mesh(node.meshes);
            }
            if (node.skin != kNone) {
                out["skin"] = node.skin;
            }
            if (node.camera != kNone) {
                out["camera"] = node.camera;
            }
            if (node.light != kNone) {
                out["extensions"]["KHR_lights_punctual"]["light"] = node.light;
            }
            if (!node.extras.empty()) {
                out["extras"] = json::parse(node.extras);
            }
            nodes.push_back(out);
            if (node.parent == kNone) {
                roots.push_back(i);
            } else {
                nodes[node.parent]["children"].push_back(i);
            }
        }
        root_["nodes"] = nodes;
        root_["scene"] = 0;
        root_["scenes"] = {{{"nodes", roots}}};
    }

    const SceneData& scene_;
    GlbBuffer buffer_;
    json& root_ = buffer_.root;
    std::set<std::string> extensions_;
    std::vector<std::vector<std::uint32_t>> mesh_lists_;
};

}  // namespace

std::string glb_bytes(const SceneData& scene) {
    return Writer(scene).bytes();
}

}  // namespace lanthorn::scene_generator
