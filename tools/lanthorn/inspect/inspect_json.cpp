#include "tools/lanthorn/inspect/inspect_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

#include "engine/core/json.h"
#include "tools/lanthorn/common/motion_tables.h"
#include "tools/lanthorn/inspect/scene_contents.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

// The shortest decimal number that is this float: 0.8, not 0.800000011920929. Infinity: null.
ordered_json number_json(float v) {
    const std::string text = fmt::format("{}", v);
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return std::isfinite(v) ? ordered_json(number) : ordered_json(nullptr);
}
ordered_json number_json(double v) {
    return v;
}

template <class Vector>
ordered_json vector_json(const Vector& v) {
    ordered_json json = ordered_json::array();
    for (glm::length_t i = 0; i < v.length(); ++i) {
        json.push_back(number_json(v[i]));
    }
    return json;
}

ordered_json index_json(std::uint32_t index) {
    return index == kNone ? ordered_json(nullptr) : ordered_json(index);
}

ordered_json node_json(const NodeData& node, const dmat4& world) {
    return {
        {"name", node.name},
        {"parent", index_json(node.parent)},
        {"position", vector_json(dvec3(world[3]))},
        {"meshes", node.meshes},
        {"skin", index_json(node.skin)},
        {"camera", index_json(node.camera)},
        {"light", index_json(node.light)},
        {"extras", node.extras.empty() ? ordered_json(nullptr) : parse_ordered_json(node.extras, "extras")}};
}

ordered_json mesh_json(const Mesh& mesh) {
    ordered_json cage = nullptr;
    if (mesh.cage) {
        cage = {{"scheme", subdivision_name(mesh.cage->scheme)}, {"level", mesh.cage->level}};
    }
    return {{"name", mesh.name},
            {"triangles", mesh.indices.size() / 3},
            {"vertices", mesh.vertices.size()},
            {"material", mesh.material},
            {"size", vector_json(mesh.bounds.size())},
            {"joints_a_vertex", most_influences(mesh)},
            {"morph_targets", mesh.morphs.size()},
            {"subdivision", cage}};
}

ordered_json clip_json(const AnimationClip& clip) {
    const ClipContents contents = clip_contents(clip);
    return {{"name", clip.name},
            {"seconds", number_json(clip.duration)},
            {"channels", clip.channels.size() + clip.properties.size()},
            {"nodes", contents.nodes},
            {"moves", contents.paths}};
}

ordered_json material_json(const Material& m) {
    constexpr const char* kAlphaModes[] = {"opaque", "mask", "blend"};
    ordered_json textures = ordered_json::object();
    for (const auto& [texture, name] : named_textures(m)) {
        if (texture->present()) {
            textures[name] = texture->texture;
        }
    }
    return {{"name", m.name},
            {"base_colour", vector_json(m.base_colour)},
            {"metallic", number_json(m.metallic)},
            {"roughness", number_json(m.roughness)},
            {"emissive", vector_json(m.emissive)},
            {"alpha_mode", kAlphaModes[static_cast<int>(m.alpha_mode)]},
            {"alpha_cutoff", number_json(m.alpha_cutoff)},
            {"double_sided", m.double_sided},
            {"unlit", m.unlit},
            {"ior", number_json(m.ior)},
            {"specular", number_json(m.specular)},
            {"transmission", number_json(m.transmission)},
            {"thickness", number_json(m.thickness)},
            {"attenuation_distance", number_json(m.attenuation_distance)},
            {"attenuation_colour", vector_json(m.attenuation_colour)},
            {"textures", textures}};
}

ordered_json texture_json(const Texture& texture, const std::vector<Image>& images) {
    const Image& image = images[texture.image];
    return {{"image", texture.image}, {"name", image.name}, {"size", {image.width, image.height}}};
}

ordered_json light_json(const Light& light) {
    const bool spot = light.type == LightType::spot;
    return {{"type", light_type_name(light.type)},
            {"intensity", number_json(light.intensity)},
            {"unit", light.type == LightType::directional ? "lx" : "cd"},
            {"colour", vector_json(light.colour)},
            {"range", number_json(light.range)},
            {"cone", spot ? ordered_json{number_json(light.inner_cone), number_json(light.outer_cone)}
                          : ordered_json(nullptr)}};
}

ordered_json camera_json(const Camera& camera) {
    const bool flat = camera.orthographic;
    return {
        {"projection", flat ? "orthographic" : "perspective"},
        {"y_fov", flat ? ordered_json(nullptr) : number_json(camera.y_fov)},
        {"size", flat ? ordered_json{number_json(2 * camera.x_mag), number_json(2 * camera.y_mag)}
                      : ordered_json(nullptr)},
        {"near", number_json(camera.z_near)},
        {"far", camera.z_far > 0 ? number_json(camera.z_far) : ordered_json(nullptr)},
    };
}

template <class T, class ToJson>
ordered_json list_json(const std::vector<T>& things, const ToJson& to_json) {
    ordered_json list = ordered_json::array();
    for (const T& thing : things) {
        list.push_back(to_json(thing));
    }
    return list;
}

}  // namespace

ordered_json contents_json(const SceneData& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    const WorldBox box = world_bounds(scene, world);
    ordered_json bounds = nullptr;
    if (!box.empty()) {
        bounds = {{"lower", vector_json(box.lower)},
                  {"upper", vector_json(box.upper)},
                  {"diagonal", glm::length(box.upper - box.lower)}};
    }
    ordered_json nodes = ordered_json::array();
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        nodes.push_back(node_json(scene.nodes[i], world[i]));
    }
    return {{"scene", scene.source},
            {"triangles", {{"stored", scene.triangle_count()}, {"placed", placed_triangles(scene)}}},
            {"bounds", bounds},
            {"nodes", nodes},
            {"meshes", list_json(scene.meshes, mesh_json)},
            {"skins", list_json(scene.skins,
                                [](const Skin& skin) {
                                    return ordered_json{{"name", skin.name}, {"joints", skin.joints}};
                                })},
            {"animations", list_json(scene.animations, clip_json)},
            {"materials", list_json(scene.materials, material_json)},
            {"textures",
             list_json(scene.textures, [&](const Texture& t) { return texture_json(t, scene.images); })},
            {"lights", list_json(scene.lights, light_json)},
            {"cameras", list_json(scene.cameras, camera_json)},
            {"warnings", scene.warnings}};
}

}  // namespace lanthorn::tools
