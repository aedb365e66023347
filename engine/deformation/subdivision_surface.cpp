#include "engine/deformation/subdivision_surface.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <mutex>

#include "engine/deformation/surface_builder.h"

namespace lanthorn::deform {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

// What OpenSubdiv says while it builds on this thread; it would print it.
thread_local std::string complaint;

void listen() {
    static std::once_flag once;
    std::call_once(once, [] {
        Far::SetErrorCallback([](Far::ErrorType, const char* message) { complaint = message; });
        Far::SetWarningCallback([](const char*) {});
    });
    complaint.clear();
}

using Refiner = std::unique_ptr<Far::TopologyRefiner>;

Refiner refiner_of(const CageTopology& cage, SubdivisionScheme scheme, std::size_t mesh_vertices) {
    Far::TopologyDescriptor::FVarChannel texture;
    texture.numValues = static_cast<int>(mesh_vertices);
    texture.valueIndices = cage.corner_vertices.data();
    Far::TopologyDescriptor topology;
    topology.numVertices = static_cast<int>(cage.control_vertices.size());
    topology.numFaces = static_cast<int>(cage.face_sizes.size());
    topology.numVertsPerFace = cage.face_sizes.data();
    topology.vertIndicesPerFace = cage.corners.data();
    topology.numCreases = static_cast<int>(cage.crease_sharpness.size());
    topology.creaseVertexIndexPairs = cage.crease_ends.data();
    topology.creaseWeights = cage.crease_sharpness.data();
    topology.numFVarChannels = 1;
    topology.fvarChannels = &texture;
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_ALL);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const auto type = scheme == SubdivisionScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    return Refiner(Factory::Create(topology, Factory::Options(type, options)));
}

// Empty if the surface is one everywhere.
std::string non_manifold(const Far::TopologyRefiner& refiner) {
    const Far::TopologyLevel level = refiner.GetLevel(0);
    for (int e = 0; e < level.GetNumEdges(); ++e) {
        if (level.IsEdgeNonManifold(e)) {
            return "its cage is non-manifold: an edge has more than two faces";
        }
    }
    for (int v = 0; v < level.GetNumVertices(); ++v) {
        if (level.IsVertexNonManifold(v)) {
            return "its cage is non-manifold: at a vertex two fans of faces meet";
        }
    }
    return {};
}

std::uint64_t triangles_at(const CageTopology& cage, SubdivisionScheme scheme, std::uint32_t level) {
    const std::uint64_t quads_of_four = std::uint64_t{1} << (2 * level);
    return scheme == SubdivisionScheme::loop ? cage.face_sizes.size() * quads_of_four
                                             : cage.corners.size() * quads_of_four / 4 * 2;
}

float longest_edge_of(const CageTopology& cage, const std::vector<Vertex>& vertices) {
    float longest = 0;
    const int* corner = cage.corner_vertices.data();
    for (const int size : cage.face_sizes) {
        for (int i = 0; i < size; ++i) {
            const vec3& a = vertices[static_cast<std::size_t>(corner[i])].position;
            const vec3& b = vertices[static_cast<std::size_t>(corner[(i + 1) % size])].position;
            longest = std::max(longest, glm::length(a - b));
        }
        corner += size;
    }
    return longest;
}

}  // namespace

SubdivisionSurface::SubdivisionSurface(const Mesh& mesh)
    : scheme_(mesh.cage->scheme), cage_(cage_topology(mesh)), vertices_(mesh.vertices) {
    problem_ = cage_.problem;
    remark_ = cage_.remark;
    if (!problem_.empty()) {
        return;
    }
    listen();
    const Refiner refiner = refiner_of(cage_, scheme_, vertices_.size());
    problem_ = refiner ? non_manifold(*refiner) : "OpenSubdiv refuses its cage: " + complaint;
    if (!problem_.empty()) {
        return;
    }
    longest_edge_ = longest_edge_of(cage_, vertices_);
    const std::uint32_t wanted = std::clamp<std::uint32_t>(mesh.cage->level, 1, kMostLevel);
    while (finest_ < wanted && triangles_at(cage_, scheme_, finest_ + 1) <= kMostTriangles) {
        ++finest_;
    }
    if (finest_ == 0) {
        problem_ = "its cage has too many faces to subdivide";
    } else if (finest_ < wanted) {
        if (!remark_.empty()) {
            remark_ += "; ";
        }
        remark_ += "its level " + std::to_string(wanted) + " would have more than " +
                   std::to_string(kMostTriangles) + " triangles; level " + std::to_string(finest_) +
                   " is drawn";
    }
}

SubdivisionSurface::~SubdivisionSurface() = default;

const RefinedSurface& SubdivisionSurface::at(std::uint32_t level) {
    auto& surface = levels_.at(level);
    if (!surface) {
        listen();
        const Refiner refiner = refiner_of(cage_, scheme_, vertices_.size());
        Far::TopologyRefiner::UniformOptions uniform(static_cast<int>(level));
        uniform.fullTopologyInLastLevel = true;
        refiner->RefineUniform(uniform);
        surface = std::make_unique<RefinedSurface>(build_surface(*refiner, cage_, vertices_));
    }
    return *surface;
}

}  // namespace lanthorn::deform
