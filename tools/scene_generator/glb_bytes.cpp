#include "tools/scene_generator/glb_bytes.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/scene_generator/png_bytes.h"

namespace lanthorn::scene_generator {

namespace {

using nlohmann::json;

// The shortest decimal that reads back as `value`, as a double: 0.1f is written 0.1.
double number(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double result = 0;
    std::from_chars(text, end, result);
    return result == 0 ? 0 : result;  // no -0
}

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

void append_u32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<char>(value >> shift));
    }
}

void append_f32(std::string& out, float value) {
    std::uint32_t bits;
    const float plain = value == 0 ? 0.0f : value;
    std::memcpy(&bits, &plain, sizeof bits);
    append_u32(out, bits);
}

void pad(std::string& out, char with) {
    out.resize((out.size() + 3) / 4 * 4, with);
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
        if (!bin_.empty()) {
            root_["buffers"] = {{{"byteLength", bin_.size()}}};
        }
        if (!extensions_.empty()) {
            root_["extensionsUsed"] = extensions_;
        }

        std::string text = root_.dump();
        pad(text, ' ');
        std::string out = "glTF";
        append_u32(out, 2);
        append_u32(out,
                   static_cast<std::uint32_t>(12 + 8 + text.size() + (bin_.empty() ? 0 : 8 + bin_.size())));
        append_u32(out, static_cast<std::uint32_t>(text.size()));
        out += "JSON" + text;
        if (!bin_.empty()) {
            append_u32(out, static_cast<std::uint32_t>(bin_.size()));
            out += std::string("BIN\0", 4) + bin_;
        }
        return out;
    }

  private:
    // Appends to the binary chunk; the new buffer view's index.
    std::size_t add_view(const std::string& bytes, int target) {
        json view = {{"buffer", 0}, {"byteLength", bytes.size()}, {"byteOffset", bin_.size()}};
        if (target != 0) {
            view["target"] = target;
        }
        bin_ += bytes;
        pad(bin_, 0);
        root_["bufferViews"].push_back(view);
        return root_["bufferViews"].size() - 1;
    }

    std::size_t add_accessor(const std::string& bytes, int target, const char* type, int component,
                             std::size_t count) {
        root_["accessors"].push_back({{"bufferView", add_view(bytes, target)},
                                      {"componentType", component},
                                      {"count", count},
                                      {"type", type}});
        return root_["accessors"].size() - 1;
    }

    json primitive(const Mesh& mesh) {
        constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963, kFloat = 5126, kShort = 5123,
                      kInt = 5125;
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
            append_u32(indices, index);
            if (!wide) {
                indices.resize(indices.size() - 2);
            }
        }
        const std::size_t count = mesh.vertices.size();
        json attributes;
        const std::size_t position = add_accessor(positions, kArrayBuffer, "VEC3", kFloat, count);
        root_["accessors"][position]["min"] = numbers(mesh.bounds.lower);
        root_["accessors"][position]["max"] = numbers(mesh.bounds.upper);
        attributes["POSITION"] = position;
        attributes["NORMAL"] = add_accessor(normals, kArrayBuffer, "VEC3", kFloat, count);
        if (scene_.materials[mesh.material].base_colour_texture.present()) {
            attributes["TEXCOORD_0"] = add_accessor(uvs, kArrayBuffer, "VEC2", kFloat, count);
        }
        return {{"attributes", attributes},
                {"indices", add_accessor(indices, kElementArrayBuffer, "SCALAR", wide ? kInt : kShort,
                                         mesh.indices.size())},
                {"material", mesh.material}};
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
        root_["meshes"].push_back({{"name", scene_.meshes[primitives.front()].name}, {"primitives", list}});
        mesh_lists_.push_back(primitives);
        return mesh_lists_.size() - 1;
    }

    void write_images() {
        for (const Image& image : scene_.images) {
            root_["images"].push_back({{"bufferView", add_view(png_bytes(image), 0)},
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
    json root_;
    std::string bin_;
    std::set<std::string> extensions_;
    std::vector<std::vector<std::uint32_t>> mesh_lists_;
};

}  // namespace

std::string glb_bytes(const SceneData& scene) {
    return Writer(scene).bytes();
}

}  // namespace lanthorn::scene_generator
