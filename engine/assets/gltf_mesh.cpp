#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_deformation.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/gltf_integers.h"
#include "engine/assets/stroke_shapes.h"
#include "engine/assets/vertex_frames.h"

namespace lanthorn {

namespace {

// One glTF primitive on its way to a Mesh.
class PrimitiveImport {
  public:
    PrimitiveImport(const GltfContext& context, std::size_t mesh, std::size_t primitive, JointLimit limit)
        : context_(context),
          primitive_(context.model.meshes[mesh].primitives[primitive]),
          mesh_index_(mesh),
          primitive_index_(primitive),
          limit_(limit),
          place_(fmt::format("/meshes/{}/primitives/{}", mesh, primitive)) {}

    // False if nothing is left to draw; then `mesh` is of no use.
    bool run(Mesh& mesh);

  private:
    const tinygltf::Accessor& accessor(std::size_t index) const { return context_.model.accessors[index]; }
    bool has(const std::string& name) const { return primitive_.attributes.contains(name); }
    std::string attribute_place(const std::string& name) const { return place_ + "/attributes/" + name; }
    // The attribute's values, `components` each; its accessor must have `min_components` to `components` of
    // them.
    std::vector<float> attribute(const std::string& name, std::size_t min_components, std::size_t components,
                                 float fill = 0, Integers integers = Integers::as_stated) const;
    Integers integers_of_texture_coordinates(const std::string& name) const;
    bool data_present() const;
    void read_positions(Mesh& mesh);
    std::vector<std::uint32_t> without_nowhere(const std::vector<std::uint32_t>& list,
                                               std::size_t corners) const;
    void read_texture_coordinates(Mesh& mesh, std::uint32_t set, vec2 Vertex::*member) const;
    void read_colours(Mesh& mesh) const;
    std::vector<std::uint32_t> corner_list() const;
    std::vector<std::uint32_t> triangles() const;
    std::vector<Stroke> strokes() const;
    bool draw_strokes(Mesh& mesh);
    void read_frames(Mesh& mesh) const;
    void read_deformation(Mesh& mesh);
    void remove_flat(Mesh& mesh) const;
    void follow(const VertexSources& sources);
    void make_frames(Mesh& mesh);
    void remap_deformation(Mesh& mesh);

    const GltfContext& context_;
    const tinygltf::Primitive& primitive_;
    std::size_t mesh_index_;
    std::size_t primitive_index_;
    JointLimit limit_;
    std::string place_;
    std::size_t vertex_count_ = 0;               // of the accessors
    std::unordered_set<std::uint32_t> nowhere_;  // vertices whose position is no number
    VertexSources sources_;  // the accessors' element that each vertex of the mesh comes from
};

std::vector<float> PrimitiveImport::attribute(const std::string& name, std::size_t min_components,
                                              std::size_t components, float fill, Integers integers) const {
    return read_attribute(context_, static_cast<std::size_t>(primitive_.attributes.at(name)),
                          attribute_place(name), {min_components, components, vertex_count_}, fill, integers);
}

bool PrimitiveImport::data_present() const {
    const bool indexed =
        primitive_.indices < 0 || has_data(context_, static_cast<std::size_t>(primitive_.indices));
    return indexed &&
           std::all_of(primitive_.attributes.begin(), primitive_.attributes.end(), [&](const auto& entry) {
               return has_data(context_, static_cast<std::size_t>(entry.second));
           });
}

// Where one is no number, the vertex takes another's place, and what is drawn does without it.
void PrimitiveImport::read_positions(Mesh& mesh) {
    const std::vector<float> values = attribute("POSITION", 3, 3);
    vec3 sound(0);
    for (std::size_t v = vertex_count_; v-- > 0;) {
        const vec3 position(values[v * 3], values[v * 3 + 1], values[v * 3 + 2]);
        if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) {
            sound = position;
        } else {
            nowhere_.insert(static_cast<std::uint32_t>(v));
        }
    }
    for (std::size_t v = 0; v < vertex_count_; ++v) {
        const bool lost = nowhere_.contains(static_cast<std::uint32_t>(v));
        mesh.vertices[v].position = lost ? sound : vec3(values[v * 3], values[v * 3 + 1], values[v * 3 + 2]);
    }
}

// Of shapes of `corners` vertices each, those that are somewhere.
std::vector<std::uint32_t> PrimitiveImport::without_nowhere(const std::vector<std::uint32_t>& list,
                                                            std::size_t corners) const {
    if (nowhere_.empty()) {
        return list;
    }
    std::vector<std::uint32_t> result;
    for (auto shape = list.begin(); shape != list.end(); shape += static_cast<std::ptrdiff_t>(corners)) {
        const auto end = shape + static_cast<std::ptrdiff_t>(corners);
        if (std::none_of(shape, end, [&](std::uint32_t v) { return nowhere_.contains(v); })) {
            result.insert(result.end(), shape, end);
        }
    }
    if (const std::size_t lost = (list.size() - result.size()) / corners; lost > 0) {
        context_.warn(accessor_place(static_cast<std::size_t>(primitive_.attributes.at("POSITION"))),
                      fmt::format("{} positions are not finite; {} {} left out", nowhere_.size(), lost,
                                  lost == 1 ? "shape that uses them is" : "shapes that use them are"));
    }
    return result;
}

// Plain integers are numbers where KHR_mesh_quantization allows them, and where a texture is moved or scaled
// (KHR_texture_transform), which is how quantised coordinates are brought into range.
Integers PrimitiveImport::integers_of_texture_coordinates(const std::string& name) const {
    const nlohmann::json used = context_.file.json.value("extensionsUsed", nlohmann::json::array());
    const auto is_moved = [](const TextureRef* texture) {
        return texture->uv_transform != TextureRef().uv_transform;
    };
    if (std::ranges::find(used, "KHR_mesh_quantization") != used.end() ||
        (primitive_.material >= 0 &&
         std::ranges::any_of(
             context_.scene.materials[static_cast<std::size_t>(primitive_.material)].textures(), is_moved))) {
        return Integers::as_stated;
    }
    return integers_of(context_, static_cast<std::size_t>(primitive_.attributes.at(name)),
                       NumbersUpTo::a_sixteenth, attribute_place(name));
}

void PrimitiveImport::read_texture_coordinates(Mesh& mesh, std::uint32_t set, vec2 Vertex::*member) const {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (!has(name)) {
        return;
    }
    std::vector<float> values = attribute(name, 2, 2, 0, integers_of_texture_coordinates(name));
    std::size_t bad = 0;
    for (float& value : values) {
        if (!std::isfinite(value)) {
            value = 0;
            ++bad;
        }
    }
    if (bad > 0) {
        context_.warn(attribute_place(name), fmt::format("{} values are not finite; 0 is used", bad));
    }
    for (std::size_t v = 0; v < vertex_count_; ++v) {
        mesh.vertices[v].*member = {values[v * 2], values[v * 2 + 1]};
    }
}

// Colours of bytes that were written as floats.
bool are_of_255(const std::vector<float>& values) {
    return std::ranges::max(values) == 255 &&
           std::ranges::all_of(values, [](float value) { return value >= 0 && value == std::floor(value); });
}

// The first `components` of each four.
void divide_by_255(std::vector<float>& values, std::size_t components) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 4 < components ? values[i] / 255 : values[i];
    }
}

void PrimitiveImport::read_colours(Mesh& mesh) const {
    const auto index = static_cast<std::size_t>(primitive_.attributes.at("COLOR_0"));
    const std::string place = attribute_place("COLOR_0");
    std::vector<float> values =
        attribute("COLOR_0", 3, 4, 1.0f, integers_of(context_, index, NumbersUpTo::one, place));
    if (are_of_255(values)) {
        context_.warn(place, "floats that are whole numbers of 0 to 255; divided by 255");
        divide_by_255(values, static_cast<std::size_t>(accessor(index).type));
    }
    std::size_t bad = 0;
    for (float& value : values) {
        if (!(value >= 0 && value <= 1)) {
            value = value > 0 ? 1.0f : 0.0f;
            ++bad;
        }
    }
    if (bad > 0) {
        context_.warn(place, fmt::format("{} values are outside 0..1; clamped", bad));
    }
    for (std::size_t v = 0; v < vertex_count_; ++v) {
        mesh.vertices[v].colour = {values[v * 4], values[v * 4 + 1], values[v * 4 + 2], values[v * 4 + 3]};
    }
}

// The vertices that the primitive strings together, by index or in order.
std::vector<std::uint32_t> PrimitiveImport::corner_list() const {
    if (primitive_.indices < 0) {
        std::vector<std::uint32_t> list(vertex_count_);
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i] = static_cast<std::uint32_t>(i);
        }
        return list;
    }
    const auto index = static_cast<std::size_t>(primitive_.indices);
    const tinygltf::Accessor& source = accessor(index);
    const auto type = static_cast<std::uint64_t>(source.componentType);
    if (source.type != TINYGLTF_TYPE_SCALAR ||
        (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)) {
        context_.refuse(
            place_ + "/indices",
            fmt::format("accessor {} is no SCALAR of unsigned integers (5121, 5123, 5125)", index));
    }
    const std::uint32_t restart =
        static_cast<std::uint32_t>((std::uint64_t{1} << (8 * component_size(type))) - 1);
    std::vector<std::uint32_t> list = read_indices(context_, index);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] >= vertex_count_ || list[i] == restart) {
            context_.refuse(accessor_place(index),
                            fmt::format("element {} is {}{}, expected a vertex index below {}", i, list[i],
                                        list[i] == restart ? " (primitive restart)" : "", vertex_count_));
        }
    }
    return list;
}

// glTF 2.0, 3.7.2.1: figure "Primitive types".
std::vector<std::uint32_t> PrimitiveImport::triangles() const {
    std::vector<std::uint32_t> list = corner_list();
    if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
        if (list.size() % 3 != 0) {
            context_.warn(place_,
                          fmt::format("{} corners are no multiple of 3; the rest is left out", list.size()));
            list.resize(list.size() / 3 * 3);
        }
        return list;
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 2; i < list.size(); ++i) {
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            result.insert(result.end(), {list[i - 1], list[i], list[0]});
        } else if (i % 2 == 0) {
            result.insert(result.end(), {list[i - 2], list[i - 1], list[i]});
        } else {
            result.insert(result.end(), {list[i - 2], list[i], list[i - 1]});
        }
    }
    return result;
}

void PrimitiveImport::read_frames(Mesh& mesh) const {
    if (has("NORMAL")) {
        const std::vector<float> values = attribute("NORMAL", 3, 3);
        for (std::size_t v = 0; v < vertex_count_; ++v) {
            mesh.vertices[v].normal = {values[v * 3], values[v * 3 + 1], values[v * 3 + 2]};
        }
    }
    if (has("TANGENT")) {
        const std::vector<float> values = attribute("TANGENT", 4, 4);
        for (std::size_t v = 0; v < vertex_count_; ++v) {
            mesh.vertices[v].tangent = {values[v * 4], values[v * 4 + 1], values[v * 4 + 2],
                                        values[v * 4 + 3]};
        }
    }
}

// As the accessors have it; remap_deformation() follows.
void PrimitiveImport::read_deformation(Mesh& mesh) {
    if (limit_.joints > 0) {
        mesh.skin = read_influences(context_, primitive_, place_, vertex_count_, limit_);
    }
    const nlohmann::json& source = context_.file.json["meshes"][mesh_index_]["primitives"][primitive_index_];
    mesh.morphs = read_morphs(context_, source, place_, vertex_count_);
    mesh.cage = read_cage(context_, mesh_index_, primitive_index_, mesh.indices);
}

void PrimitiveImport::remove_flat(Mesh& mesh) const {
    std::vector<bool> morphed(vertex_count_, false);
    for (const MorphTarget& target : mesh.morphs) {
        for (const std::uint32_t vertex : target.vertices) {
            morphed[vertex] = true;
        }
    }
    const auto may_open = [&](const std::array<std::uint32_t, 3>& c) {
        return morphed[c[0]] || morphed[c[1]] || morphed[c[2]] ||
               (!mesh.skin.empty() &&
                (mesh.skin[c[0]] != mesh.skin[c[1]] || mesh.skin[c[1]] != mesh.skin[c[2]]));
    };
    // Strips are joined by triangles without area on purpose; elsewhere they are worth a word.
    const std::size_t flat = remove_flat_triangles(mesh, may_open);
    if (flat > 0 && primitive_.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
        context_.warn(place_, fmt::format("{} triangles without area left out", flat));
    }
}

// Composes `sources` with those so far.
void PrimitiveImport::follow(const VertexSources& sources) {
    VertexSources composed;
    composed.reserve(sources.size());
    for (const std::uint32_t source : sources) {
        composed.push_back(sources_[source]);
    }
    sources_ = std::move(composed);
}

void PrimitiveImport::remap_deformation(Mesh& mesh) {
    mesh.skin = remapped(mesh.skin, sources_);
    for (MorphTarget& target : mesh.morphs) {
        target = remapped(target, sources_, vertex_count_);
    }
    if (!has("NORMAL") && !mesh.cage) {
        make_flat_morph_normals(mesh, mesh.morphs);
    }
    if (mesh.cage) {
        remap(*mesh.cage, sources_, vertex_count_);
    }
}

// A cage keeps its vertices together whatever their frames: they are those of the surface's topology.
void PrimitiveImport::make_frames(Mesh& mesh) {
    const Material& material = context_.scene.materials[mesh.material];
    if (!has("NORMAL") && mesh.cage) {
        for (Vertex& vertex : mesh.vertices) {
            vertex.normal = vec3(0);
        }
        mend_normals(mesh);
    } else if (!has("NORMAL")) {
        follow(make_flat_normals(mesh));
    } else if (const std::size_t count = mend_normals(mesh); count > 0) {
        context_.warn(attribute_place("NORMAL"), fmt::format("{} zero normals replaced", count));
    }
    if (has("NORMAL") && has("TANGENT")) {
        if (const std::size_t count = mend_tangents(mesh); count > 0) {
            context_.warn(attribute_place("TANGENT"), fmt::format("{} unusable tangents replaced", count));
        }
    } else if (material.normal_texture.present()) {
        follow(generate_tangents(mesh, material.normal_texture.uv_set, !mesh.cage));
    } else {
        make_any_tangents(mesh);
    }
}

// glTF 2.0, 3.7.2.1: figure "Primitive types".
std::vector<Stroke> PrimitiveImport::strokes() const {
    const std::vector<std::uint32_t> list = corner_list();
    std::vector<std::uint32_t> ends;  // two a stroke
    const std::size_t step = primitive_.mode == TINYGLTF_MODE_LINE ? 2 : 1;
    if (primitive_.mode == TINYGLTF_MODE_POINTS) {
        for (const std::uint32_t point : list) {
            ends.insert(ends.end(), {point, point});
        }
    } else {
        for (std::size_t i = 0; i + 1 < list.size(); i += step) {
            ends.insert(ends.end(), {list[i], list[i + 1]});
        }
        if (primitive_.mode == TINYGLTF_MODE_LINE_LOOP && list.size() > 2) {
            ends.insert(ends.end(), {list.back(), list.front()});
        }
    }
    ends = without_nowhere(ends, 2);
    std::vector<Stroke> result;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
        result.emplace_back(ends[i], ends[i + 1]);
    }
    return result;
}

bool PrimitiveImport::draw_strokes(Mesh& mesh) {
    const bool points = primitive_.mode == TINYGLTF_MODE_POINTS;
    std::vector<Stroke> all = strokes();
    if (all.size() > context_.left.strokes) {
        context_.warn(place_, fmt::format("of {} {}, {} are drawn: a scene may have no more", all.size(),
                                          points ? "points" : "lines", context_.left.strokes));
        all.resize(context_.left.strokes);
    } else if (all.empty()) {
        context_.warn(place_, "no lines; the primitive is left out");
    }
    if (all.empty()) {
        return false;
    }
    take(context_.left.strokes, all.size());
    const float radius = stroke_radius(mesh);
    context_.warn(place_, fmt::format("{} are drawn as {} {:.2g} m thick", points ? "points" : "lines",
                                      points ? "octahedra" : "rods", 2 * radius));
    read_deformation(mesh);
    mesh.cage.reset();
    sources_ = make_strokes(mesh, all, radius);
    mesh.skin = remapped(mesh.skin, sources_);
    for (MorphTarget& target : mesh.morphs) {
        target = remapped(target, sources_, vertex_count_);
    }
    for (const Vertex& vertex : mesh.vertices) {
        mesh.bounds.add(vertex.position);
    }
    return true;
}

bool PrimitiveImport::run(Mesh& mesh) {
    if (!has("POSITION")) {
        context_.warn(place_ + "/attributes", "no POSITION; the primitive is left out");
        return false;
    }
    if (!data_present()) {
        context_.warn(place_, "an accessor of it has no data; the primitive is left out");
        return false;
    }
    vertex_count_ = accessor(static_cast<std::size_t>(primitive_.attributes.at("POSITION"))).count;
    const std::size_t corners =
        primitive_.indices < 0 ? vertex_count_ : accessor(static_cast<std::size_t>(primitive_.indices)).count;
    if (!take(context_.left.corners, vertex_count_ + corners)) {
        context_.warn(place_,
                      fmt::format("its {} vertices and {} indices are more than are left of what a scene "
                                  "may have; the primitive is left out",
                                  vertex_count_, corners));
        return false;
    }
    const bool is_surface = primitive_.mode >= TINYGLTF_MODE_TRIANGLES;
    mesh.vertices.resize(vertex_count_);
    read_positions(mesh);
    if (is_surface) {
        mesh.indices = without_nowhere(triangles(), 3);
    }
    read_frames(mesh);
    const UvSets sets = primitive_.material < 0
                            ? kPlainUvSets
                            : context_.uv_sets[static_cast<std::size_t>(primitive_.material)];
    read_texture_coordinates(mesh, sets[0], &Vertex::uv0);
    read_texture_coordinates(mesh, sets[1], &Vertex::uv1);
    if (has("COLOR_0")) {
        read_colours(mesh);
    }
    if (!is_surface) {
        return draw_strokes(mesh);
    }
    read_deformation(mesh);
    if (!mesh.cage) {
        remove_flat(mesh);
    }
    if (mesh.indices.empty()) {
        context_.warn(place_, "no triangles; the primitive is left out");
        return false;
    }
    sources_ = remove_unused_vertices(mesh);
    make_frames(mesh);
    remap_deformation(mesh);
    for (const Vertex& vertex : mesh.vertices) {
        mesh.bounds.add(vertex.position);
    }
    return true;
}

// Mesh::morph_weights of a glTF mesh's primitives.
void read_weights(const GltfContext& context, std::size_t index, const std::vector<std::uint32_t>& meshes) {
    const nlohmann::json& source = context.file.json["meshes"][index];
    const auto given = source.value("weights", std::vector<float>());
    const std::string place = fmt::format("/meshes/{}", index);
    const Mesh* first = nullptr;
    for (const std::uint32_t m : meshes) {
        Mesh& mesh = context.scene.meshes[m];
        mesh.morph_weights = given;
        mesh.morph_weights.resize(mesh.morphs.size(), 0.0f);
        if (!first) {
            first = &mesh;
            if (source.contains("weights") && given.size() != mesh.morphs.size()) {
                context.warn(
                    place + "/weights",
                    fmt::format("found {} weights, expected {}, one a morph target; 0 for those missing",
                                given.size(), mesh.morphs.size()));
            }
        } else if (mesh.morphs.size() != first->morphs.size()) {
            context.warn(place + "/primitives",
                         fmt::format("found {} and {} morph targets, expected as many for all primitives",
                                     first->morphs.size(), mesh.morphs.size()));
        }
    }
}

// The material of primitives that name none: glTF's default one, appended when first needed.
std::uint32_t default_material(const GltfContext& context) {
    const std::size_t given = context.model.materials.size();
    if (context.scene.materials.size() == given) {
        context.scene.materials.emplace_back().name = "default";
    }
    return static_cast<std::uint32_t>(given);
}

}  // namespace

std::vector<std::uint32_t> import_mesh(const GltfContext& context, std::size_t index,
                                       const JointLimit& limit) {
    const tinygltf::Mesh& source = context.model.meshes[index];
    std::vector<std::uint32_t> result;
    for (std::size_t p = 0; p < source.primitives.size(); ++p) {
        const tinygltf::Primitive& primitive = source.primitives[p];
        Mesh mesh;
        mesh.name = source.primitives.size() == 1 ? source.name : fmt::format("{}/{}", source.name, p);
        mesh.material = primitive.material >= 0 ? static_cast<std::uint32_t>(primitive.material)
                                                : default_material(context);
        if (PrimitiveImport(context, index, p, limit).run(mesh)) {
            result.push_back(static_cast<std::uint32_t>(context.scene.meshes.size()));
            context.scene.meshes.push_back(std::move(mesh));
            context.scene.file.meshes.push_back(
                {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(p)});
        }
    }
    read_weights(context, index, result);
    return result;
}

}  // namespace lanthorn
