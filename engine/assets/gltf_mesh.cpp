#include <algorithm>
#include <array>

#include "engine/assets/gltf_corners.h"
#include "engine/assets/gltf_deformation.h"
#include "engine/assets/gltf_vertices.h"
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
          place_(fmt::format("/meshes/{}/primitives/{}", mesh, primitive)),
          vertices_(context, primitive_, place_) {}

    // False if nothing is left to draw; then `mesh` is of no use.
    bool run(Mesh& mesh);

  private:
    bool has(const std::string& name) const { return vertices_.has(name); }
    GltfCorners corners() const { return {context_, primitive_, place_, vertices_.count()}; }
    std::vector<Stroke> strokes() const;
    bool draw_strokes(Mesh& mesh);
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
    GltfVertices vertices_;
    VertexSources sources_;  // the accessors' element that each vertex of the mesh comes from
};

// As the accessors have it; remap_deformation() follows.
void PrimitiveImport::read_deformation(Mesh& mesh) {
    if (limit_.joints > 0) {
        mesh.skin = read_influences(context_, primitive_, place_, vertices_.count(), limit_);
    }
    const nlohmann::json& source = context_.file.json["meshes"][mesh_index_]["primitives"][primitive_index_];
    mesh.morphs = read_morphs(context_, source, place_, vertices_.count());
    mesh.cage = read_cage(context_, mesh_index_, primitive_index_, mesh.indices);
}

void PrimitiveImport::remove_flat(Mesh& mesh) const {
    std::vector<bool> morphed(vertices_.count(), false);
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
        target = remapped(target, sources_, vertices_.count());
    }
    if (!has("NORMAL") && !mesh.cage) {
        make_flat_morph_normals(mesh, mesh.morphs);
    }
    if (mesh.cage) {
        remap(*mesh.cage, sources_, vertices_.count());
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
        context_.warn(vertices_.place_of("NORMAL"), fmt::format("{} zero normals replaced", count));
    }
    if (has("NORMAL") && has("TANGENT")) {
        if (const std::size_t count = mend_tangents(mesh); count > 0) {
            context_.warn(vertices_.place_of("TANGENT"), fmt::format("{} unusable tangents replaced", count));
        }
    } else if (material.normal_texture.present()) {
        follow(generate_tangents(mesh, material.normal_texture.uv_set, !mesh.cage));
    } else {
        make_any_tangents(mesh);
    }
}

std::vector<Stroke> PrimitiveImport::strokes() const {
    const std::vector<std::uint32_t> ends = vertices_.without_nowhere(stroke_ends_of(corners()), 2);
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
        target = remapped(target, sources_, vertices_.count());
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
    if (!vertices_.data_present()) {
        context_.warn(place_, "an accessor of it has no data; the primitive is left out");
        return false;
    }
    const std::size_t count = vertices_.count();
    const std::size_t indices =
        primitive_.indices < 0 ? count
                               : context_.model.accessors[static_cast<std::size_t>(primitive_.indices)].count;
    if (!take(context_.left.corners, count + indices)) {
        context_.warn(place_,
                      fmt::format("its {} vertices and {} indices are more than are left of what a scene "
                                  "may have; the primitive is left out",
                                  count, indices));
        return false;
    }
    const bool is_surface = primitive_.mode >= TINYGLTF_MODE_TRIANGLES;
    mesh.vertices.resize(count);
    vertices_.read_positions(mesh);
    if (is_surface) {
        mesh.indices = vertices_.without_nowhere(triangles_of(corners()), 3);
    }
    vertices_.read_others(mesh);
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
