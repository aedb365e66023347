#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_context.h"
#include "engine/assets/matrix_parts.h"

namespace lanthorn {

namespace {

const nlohmann::json::json_pointer kInstancing("/extensions/EXT_mesh_gpu_instancing");

constexpr double kMinFov = 1e-3;  // radians
constexpr double kMaxFov = kPi - 1e-3;

Camera import_camera(const GltfContext& context, std::size_t index) {
    const tinygltf::Camera& source = context.model.cameras[index];
    Camera camera;
    const std::string type = context.file.json["cameras"][index]["type"];
    if (type != source.type) {  // build_model() has put another in its place
        context.warn(fmt::format("/cameras/{}/type", index),
                     fmt::format("'{}' is unknown; the default camera is used", type));
        return camera;
    }
    camera.orthographic = source.type == "orthographic";
    const std::string place = fmt::format("/cameras/{}/{}", index, source.type);
    double z_near = 0;
    double z_far = 0;
    if (camera.orthographic) {
        const tinygltf::OrthographicCamera& lens = source.orthographic;
        z_near = lens.znear;
        z_far = lens.zfar;
        for (const auto& [name, given, kept] :
             {std::tuple("xmag", lens.xmag, &camera.x_mag), std::tuple("ymag", lens.ymag, &camera.y_mag)}) {
            const float size = static_cast<float>(std::abs(given));
            if (!(size > 0)) {
                context.warn(place + "/" + name, "found 0; 1 is used");
            }
            *kept = size > 0 ? size : 1.0f;
        }
    } else {
        const tinygltf::PerspectiveCamera& lens = source.perspective;
        if (lens.yfov >= kMinFov && lens.yfov <= kMaxFov) {
            camera.y_fov = static_cast<float>(lens.yfov);
        } else {
            context.warn(place + "/yfov", fmt::format("found {}, expected an angle from 0 to pi; {} is used",
                                                      lens.yfov, camera.y_fov));
        }
        z_near = lens.znear;
        z_far = lens.zfar;  // 0 if absent
    }
    if (z_near > z_far && static_cast<float>(z_far) > 0) {
        context.warn(place + "/znear",
                     fmt::format("found {}, which is beyond zfar {}; they are exchanged", z_near, z_far));
        std::swap(z_near, z_far);
    }
    const bool near_ok = camera.orthographic ? z_near >= 0 : static_cast<float>(z_near) > 0;
    if (!near_ok) {
        const float mended = camera.orthographic ? 0 : camera.z_near;
        context.warn(place + "/znear", fmt::format("found {}; {} is used", z_near, mended));
        z_near = mended;
    }
    camera.z_near = static_cast<float>(z_near);
    const bool infinite = z_far == 0 && !camera.orthographic;
    if (!infinite && !(static_cast<float>(z_far) > camera.z_near)) {
        const float mended = camera.orthographic ? camera.z_near + 1000 : 0;
        context.warn(place + "/zfar", fmt::format("found {}, which is not beyond znear; {} is used", z_far,
                                                  camera.orthographic ? fmt::to_string(mended) : "infinity"));
        z_far = mended;
    }
    camera.z_far = static_cast<float>(z_far);
    return camera;
}

Light import_light(const GltfContext& context, std::size_t index) {
    const tinygltf::Light& source = context.model.lights[index];
    const std::string place = fmt::format("/extensions/KHR_lights_punctual/lights/{}", index);
    Light light;
    light.type = source.type == "directional" ? LightType::directional
                 : source.type == "spot"      ? LightType::spot
                                              : LightType::point;
    for (std::size_t i = 0; i < source.color.size(); ++i) {
        light.colour[static_cast<int>(i)] =
            context.clamped(source.color[i], 0, kNoLimit, fmt::format("{}/color/{}", place, i));
    }
    light.intensity = context.clamped(source.intensity, 0, kNoLimit, place + "/intensity");
    if (context.file.json["extensions"]["KHR_lights_punctual"]["lights"][index].contains("range")) {
        if (static_cast<float>(source.range) > 0) {
            light.range = static_cast<float>(source.range);
        } else {
            context.warn(place + "/range", fmt::format("found {}; infinity is used", source.range));
        }
    }
    if (light.type == LightType::spot) {
        light.outer_cone =
            context.clamped(source.spot.outerConeAngle, 1e-3, kPi / 2, place + "/spot/outerConeAngle");
        light.inner_cone = context.clamped(source.spot.innerConeAngle, 0, light.outer_cone * 0.999,
                                           place + "/spot/innerConeAngle");
    }
    if (source.type != "directional" && source.type != "spot" && source.type != "point") {
        context.warn(place + "/type", fmt::format("'{}' is unknown; the light stays dark", source.type));
        light.intensity = 0;
    }
    return light;
}

void read_transform(const GltfContext& context, const tinygltf::Node& source, const std::string& place,
                    NodeData& node) {
    if (source.matrix.size() == 16) {
        dmat4 matrix;
        for (int i = 0; i < 16; ++i) {
            matrix[i / 4][i % 4] = source.matrix[static_cast<std::size_t>(i)];
        }
        decompose(matrix, node.local, node.shear);
        return;
    }
    if (source.translation.size() == 3) {
        node.local.translation = {source.translation[0], source.translation[1], source.translation[2]};
    }
    if (source.scale.size() == 3) {
        node.local.scale = {source.scale[0], source.scale[1], source.scale[2]};
    }
    if (source.rotation.size() == 4) {
        node.local.rotation = read_rotation(context, source.rotation, place);
    }
}

constexpr int kNobody = -1;

std::vector<int> parents_of(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), kNobody);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
        }
    }
    return parents;
}

// Of the nodes that a scene lists, those that stand under no other of them. A scene is to list roots alone
// (glTF 2.0, 3.5.1), but exporters list children too: one whose ancestor is listed comes with that one,
// another is shown without its parent, as other loaders do.
std::vector<int> mended_roots(const GltfContext& context, const std::vector<int>& listed, int scene) {
    const std::vector<int> parents = parents_of(context.model);
    enum class Place : std::uint8_t { unknown, outside, inside };  // of the subtrees of the listed nodes
    std::vector<Place> places(parents.size(), Place::unknown);
    for (const int node : listed) {
        places[static_cast<std::size_t>(node)] = Place::inside;
    }
    const auto is_inside = [&](int node) {
        std::vector<int> path;
        while (node != kNobody && places[static_cast<std::size_t>(node)] == Place::unknown) {
            path.push_back(node);
            node = parents[static_cast<std::size_t>(node)];
        }
        const Place found = node == kNobody ? Place::outside : places[static_cast<std::size_t>(node)];
        for (const int passed : path) {
            places[static_cast<std::size_t>(passed)] = found;
        }
        return found == Place::inside;
    };
    std::vector<int> roots;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const int parent = parents[static_cast<std::size_t>(listed[i])];
        const bool stands_under_another = is_inside(parent);
        if (!stands_under_another) {
            roots.push_back(listed[i]);
        }
        if (parent != kNobody) {
            context.warn(
                fmt::format("/scenes/{}/nodes/{}", scene, i),
                fmt::format("node {} is a child of node {}, expected a root; it is shown {}", listed[i],
                            parent, stands_under_another ? "there alone" : "as a root, without its parent"));
        }
    }
    return roots;
}

// The root nodes of the scene that is loaded.
std::vector<int> scene_roots(const GltfContext& context) {
    const tinygltf::Model& model = context.model;
    if (!model.scenes.empty()) {
        const int scene = std::max(model.defaultScene, 0);
        return mended_roots(context, model.scenes[static_cast<std::size_t>(scene)].nodes, scene);
    }
    const std::vector<int> parents = parents_of(model);
    std::vector<int> roots;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] == kNobody) {
            roots.push_back(static_cast<int>(i));
        }
    }
    return roots;
}

class NodeImport {
  public:
    explicit NodeImport(const GltfContext& context)
        : context_(context),
          meshes_(context.model.meshes.size()),
          limits_(context.model.meshes.size()),
          map_(context.model.nodes.size(), kNone) {}

    NodeMap run();

  private:
    struct Pending {
        std::size_t source;
        std::uint32_t parent;
    };
    void find_joint_limits();
    void add(const Pending& pending);
    void add_instances(std::size_t source, std::uint32_t parent);
    const std::vector<std::uint32_t>& meshes_of(int mesh);
    std::vector<float> node_weights(const NodeData& node, std::vector<float> given, const std::string& place);
    void check_extent(const NodeData& node, const std::string& place);
    void tell_what_was_left_out() const;

    const GltfContext& context_;
    std::vector<std::optional<std::vector<std::uint32_t>>> meshes_;  // by glTF mesh, imported on first use
    std::vector<JointLimit> limits_;                                 // by glTF mesh
    NodeMap map_;
    std::vector<dmat4> worlds_;  // by node of the scene
    // Beyond the budget.
    std::size_t placements_left_out_ = 0, weights_left_out_ = 0;
};

const std::vector<std::uint32_t>& NodeImport::meshes_of(int mesh) {
    auto& entry = meshes_[static_cast<std::size_t>(mesh)];
    if (!entry) {
        entry =
            import_mesh(context_, static_cast<std::size_t>(mesh), limits_[static_cast<std::size_t>(mesh)]);
    }
    return *entry;
}

void NodeImport::find_joint_limits() {
    for (std::size_t i = 0; i < context_.model.nodes.size(); ++i) {
        const nlohmann::json& node = context_.file.json["nodes"][i];
        if (!node.contains("skin") || !node.contains("mesh")) {
            continue;
        }
        const std::size_t skin = node["skin"];
        const std::size_t joints = context_.file.json["skins"][skin]["joints"].size();
        JointLimit& limit = limits_[node["mesh"].get<std::size_t>()];
        if (limit.joints == 0 || joints < limit.joints) {
            limit = {joints, skin};
        }
    }
}

// Refuses transforms that leave the range of floats, so that nothing later meets an infinity.
void NodeImport::check_extent(const NodeData& node, const std::string& place) {
    dmat4 local = node.local.matrix();
    const dmat4 shear(glm::dmat3(node.shear));
    const dmat4 parent = node.parent == kNone ? dmat4(1) : worlds_[node.parent];
    const dmat4 world = parent * local * shear;
    worlds_.push_back(world);
    const auto in_range = [](const dvec3& v) {
        return glm::all(glm::lessThanEqual(glm::abs(v), dvec3(std::numeric_limits<float>::max())));
    };
    for (int column = 0; column < 4; ++column) {
        if (!in_range(dvec3(world[column]))) {
            context_.refuse(place, "the node's world transform is not finite in 32-bit numbers");
        }
    }
    for (const std::uint32_t mesh : node.meshes) {
        const Aabb& box = context_.scene.meshes[mesh].bounds;
        for (int corner = 0; corner < 8; ++corner) {
            const dvec4 point(corner & 1 ? box.lower.x : box.upper.x, corner & 2 ? box.lower.y : box.upper.y,
                              corner & 4 ? box.lower.z : box.upper.z, 1);
            if (!in_range(dvec3(world * point))) {
                context_.refuse(place, "the node's mesh reaches beyond the range of 32-bit numbers");
            }
        }
    }
}

std::vector<float> NodeImport::node_weights(const NodeData& node, std::vector<float> given,
                                            const std::string& place) {
    std::size_t targets = 0;
    for (const std::uint32_t mesh : node.meshes) {
        targets = std::max(targets, context_.scene.meshes[mesh].morphs.size());
    }
    if (!take(context_.left.weights, targets)) {
        ++weights_left_out_;
        return {};
    }
    if (given.size() != targets) {
        context_.warn(place + "/weights",
                      fmt::format("found {} weights, expected {}, one a morph target; {}", given.size(),
                                  targets, targets == 0 ? "left out" : "0 for those missing"));
        given.resize(targets, 0.0f);
    }
    return given;
}

void NodeImport::add(const Pending& pending) {
    const tinygltf::Node& source = context_.model.nodes[pending.source];
    const std::string place = fmt::format("/nodes/{}", pending.source);
    NodeData node;
    node.name = source.name;
    node.parent = pending.parent;
    read_transform(context_, source, place, node);
    if (source.mesh >= 0) {
        const std::vector<std::uint32_t>& meshes = meshes_of(source.mesh);
        if (take(context_.left.placements, meshes.size())) {
            node.meshes = meshes;
        } else {
            placements_left_out_ += meshes.size();
        }
    }
    if (source.camera >= 0) {
        node.camera = static_cast<std::uint32_t>(source.camera);
    }
    if (const auto light = source.extensions.find("KHR_lights_punctual"); light != source.extensions.end()) {
        node.light = static_cast<std::uint32_t>(light->second.Get("light").GetNumberAsInt());
    }
    const nlohmann::json& json = context_.file.json["nodes"][pending.source];
    if (const auto extras = json.find("extras"); extras != json.end()) {
        node.extras = extras->dump();
    }
    if (const auto weights = json.find("weights"); weights != json.end()) {
        node.morph_weights = node_weights(node, weights->get<std::vector<float>>(), place);
    }
    check_extent(node, place);
    map_[pending.source] = static_cast<std::uint32_t>(context_.scene.nodes.size());
    context_.scene.nodes.push_back(std::move(node));
}

// EXT_mesh_gpu_instancing: the node's meshes move to a child for each instance.
void NodeImport::add_instances(std::size_t source, std::uint32_t parent) {
    const nlohmann::json& attributes = context_.file.json["nodes"][source][kInstancing]["attributes"];
    const std::string place = fmt::format("/nodes/{}{}", source, kInstancing.to_string());
    const std::vector<std::uint32_t> meshes = context_.scene.nodes[parent].meshes;
    if (meshes.empty()) {
        return;
    }
    if (context_.file.json["nodes"][source].contains("skin")) {
        context_.warn(place, "the node has a skin, which instances have not; it is shown once");
        return;
    }
    std::size_t count = 0;
    const auto read = [&](const char* name, std::size_t components) {
        if (!attributes.contains(name)) {
            return std::vector<float>();
        }
        const std::size_t index = attributes[name];
        const std::string at = fmt::format("{}/attributes/{}", place, name);
        if (!has_data(context_, index)) {
            context_.warn(at, "its accessor has no data; left out");
            return std::vector<float>();
        }
        count = count == 0 ? context_.model.accessors[index].count : count;
        return read_attribute(context_, index, at, {components, components, count});
    };
    const std::vector<float> translations = read("TRANSLATION", 3);
    const std::vector<float> rotations = read("ROTATION", 4);
    const std::vector<float> scales = read("SCALE", 3);
    if (count == 0) {
        return;
    }
    const std::size_t each = meshes.size();
    context_.scene.nodes[parent].meshes.clear();
    context_.left.placements += each;  // the node's own
    const std::size_t shown = std::min<std::size_t>(count, context_.left.placements / each);
    take(context_.left.placements, shown * each);
    placements_left_out_ += (count - shown) * each;
    const std::string name = shortened(context_.scene.nodes[parent].name, 64);
    const std::vector<float> weights = context_.scene.nodes[parent].morph_weights;
    std::size_t unusable = 0;
    for (std::size_t i = 0; i < shown; ++i) {
        NodeData node;
        node.name = fmt::format("{}/{}", name, i);
        node.parent = parent;
        node.meshes = meshes;
        if (take(context_.left.weights, weights.size())) {
            node.morph_weights = weights;
        } else {
            ++weights_left_out_;
        }
        if (!translations.empty()) {
            node.local.translation = {translations[3 * i], translations[3 * i + 1], translations[3 * i + 2]};
        }
        if (!scales.empty()) {
            node.local.scale = {scales[3 * i], scales[3 * i + 1], scales[3 * i + 2]};
        }
        glm::dquat turned(1, 0, 0, 0);
        if (!rotations.empty()) {
            const float* q = &rotations[4 * i];
            turned = glm::dquat(q[3], q[0], q[1], q[2]);
        }
        const double length = glm::length(turned);
        const double size =
            glm::length(node.local.translation) + glm::length(dvec3(node.local.scale)) + length;
        if (!std::isfinite(size) || !(length > 1e-12)) {
            ++unusable;
            continue;
        }
        node.local.rotation = quat(turned / length);
        check_extent(node, place);
        context_.scene.nodes.push_back(std::move(node));
    }
    if (unusable > 0) {
        context_.warn(place, fmt::format("{} instances have transforms that are not finite or turn by a zero "
                                         "quaternion; left out",
                                         unusable));
    }
}

void NodeImport::tell_what_was_left_out() const {
    if (placements_left_out_ > 0) {
        context_.warn("/nodes",
                      fmt::format("{} placements of primitives are left out: nodes and instances show "
                                  "more than a scene may have",
                                  placements_left_out_));
    }
    if (weights_left_out_ > 0) {
        context_.warn("/nodes",
                      fmt::format("the morph weights of {} nodes and instances are more than a scene "
                                  "may have; their meshes' are used",
                                  weights_left_out_));
    }
}

NodeMap NodeImport::run() {
    const tinygltf::Model& model = context_.model;
    find_joint_limits();
    std::vector<Pending> pending;  // last first
    const auto push = [&](const std::vector<int>& sources, std::uint32_t parent) {
        for (auto it = sources.rbegin(); it != sources.rend(); ++it) {
            pending.push_back({static_cast<std::size_t>(*it), parent});
        }
    };
    push(scene_roots(context_), kNone);
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const auto index = static_cast<std::uint32_t>(context_.scene.nodes.size());
        add(next);
        if (context_.file.json["nodes"][next.source].contains(kInstancing)) {
            add_instances(next.source, index);
        }
        push(model.nodes[next.source].children, index);
    }
    tell_what_was_left_out();
    return std::move(map_);
}

}  // namespace

quat read_rotation(const GltfContext& context, const std::vector<double>& xyzw, const std::string& place) {
    const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = glm::length(q);
    if (!(length > 1e-12)) {
        context.warn(place + "/rotation", "found a zero quaternion; no rotation is used");
        return quat(1, 0, 0, 0);
    }
    if (std::abs(length - 1) > 1e-2) {
        context.warn(place + "/rotation", fmt::format("length {} is not 1; normalised", length));
    }
    return quat(q / length);
}

NodeMap import_nodes(const GltfContext& context) {
    for (std::size_t i = 0; i < context.model.cameras.size(); ++i) {
        context.scene.cameras.push_back(import_camera(context, i));
    }
    for (std::size_t i = 0; i < context.model.lights.size(); ++i) {
        context.scene.lights.push_back(import_light(context, i));
    }
    return NodeImport(context).run();
}

}  // namespace lanthorn
