#include "engine/deformation/surface_builder.h"

#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>
#include <map>
#include <utility>

#include "engine/deformation/limit_rows.h"
#include "engine/deformation/serials.h"
#include "engine/deformation/sharp_sectors.h"

namespace lanthorn::deform {
namespace {

namespace Far = OpenSubdiv::Far;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// What stays of a refined vertex, beside its stencil.
struct Surface {
    vec2 uv0{0}, uv1{0};
    vec4 colour{0}, tangent{0};
    vec3 normal{0};

    void Clear() { *this = {}; }
    void AddWithWeight(const Surface& s, float w) {
        uv0 += w * s.uv0;
        uv1 += w * s.uv1;
        colour += w * s.colour;
        tangent += w * s.tangent;
        normal += w * s.normal;
    }
};

std::vector<Surface> interpolated(const Far::TopologyRefiner& refiner, const std::vector<Vertex>& vertices) {
    std::vector<Surface> values;
    for (const Vertex& v : vertices) {
        values.push_back({v.uv0, v.uv1, v.colour, v.tangent, v.normal});
    }
    const Far::PrimvarRefiner interpolate(refiner);
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<Surface> next(at(refiner.GetLevel(level).GetNumFVarValues()));
        interpolate.InterpolateFaceVarying(level, values, next);
        values = std::move(next);
    }
    return values;
}

class Builder {
  public:
    Builder(const Far::TopologyRefiner& refiner, const CageTopology& cage,
            const std::vector<Vertex>& vertices)
        : level_(refiner.GetLevel(refiner.GetMaxLevel())),
          limit_(limit_rows(refiner, cage.control_vertices.size())),
          values_(interpolated(refiner, vertices)),
          sectors_(level_),
          sector_du_(cage.control_vertices.size()),
          sector_dv_(cage.control_vertices.size()) {
        for (const std::uint32_t v : cage.control_vertices) {
            controls_.emplace_back(vertices[v].position);
        }
        surface_.stencils.control_count = static_cast<std::uint32_t>(controls_.size());
    }

    RefinedSurface run();

  private:
    struct Stencil {
        std::uint32_t first, end;
        dvec3 du, dv;  // of the bind pose
    };

    Stencil merge(std::span<const Term> position, std::span<const Term> du, std::span<const Term> dv);
    Stencil sector_stencil(int vertex, const Sector& sector);
    // Limit positions of refined vertices, weighted; the weights' sum is 0.
    using Chord = std::vector<std::pair<int, double>>;
    std::pair<Chord, Chord> chords(int vertex, const std::vector<int>& spokes) const;
    dvec3 bind_position(int vertex) const;
    std::uint32_t add_vertex(const Stencil& stencil, const Surface& value);
    void add_around(int vertex);
    void add_triangles();

    const Far::TopologyLevel level_;
    const LimitRows limit_;
    const std::vector<Surface> values_;
    Sectors sectors_;
    SparseRows sector_du_, sector_dv_;
    std::vector<dvec3> controls_;               // in the bind pose
    std::vector<std::uint32_t> corner_vertex_;  // refined vertex of each corner, face by face
    std::vector<std::size_t> first_corner_;
    RefinedSurface surface_;
    std::shared_ptr<RefinedTopology> topology_ = std::make_shared<RefinedTopology>();
};

Builder::Stencil Builder::merge(std::span<const Term> position, std::span<const Term> du,
                                std::span<const Term> dv) {
    auto& entries = surface_.stencils.entries;
    Stencil stencil{static_cast<std::uint32_t>(entries.size()), 0, dvec3(0), dvec3(0)};
    std::size_t p = 0, u = 0, v = 0;
    const auto index = [](std::span<const Term> row, std::size_t i) {
        return i < row.size() ? row[i].index : ~0u;
    };
    for (;;) {
        const std::uint32_t control = std::min({index(position, p), index(du, u), index(dv, v)});
        if (control == ~0u) {
            break;
        }
        StencilEntry entry{control, 0, 0, 0};
        if (index(position, p) == control) {
            entry.position = position[p++].weight;
        }
        if (index(du, u) == control) {
            entry.du = du[u++].weight;
        }
        if (index(dv, v) == control) {
            entry.dv = dv[v++].weight;
        }
        stencil.du += double(entry.du) * controls_[control];
        stencil.dv += double(entry.dv) * controls_[control];
        entries.push_back(entry);
    }
    stencil.end = static_cast<std::uint32_t>(entries.size());
    return stencil;
}

// Beside a sharp edge the limit's tangents are those of one side; each sector has chords of its own instead.
Builder::Stencil Builder::sector_stencil(int vertex, const Sector& sector) {
    const auto [du, dv] = chords(vertex, sector.spokes);
    const auto add = [&](SparseRows& rows, const Chord& chord) {
        for (const auto& [v, weight] : chord) {
            rows.add(limit_.position[at(v)], weight);
        }
        rows.end_row();
    };
    add(sector_du_, du);
    add(sector_dv_, dv);
    return merge(limit_.position[at(vertex)], sector_du_[sector_du_.size() - 1],
                 sector_dv_[sector_dv_.size() - 1]);
}

dvec3 Builder::bind_position(int vertex) const {
    dvec3 sum(0);
    for (const Term& term : limit_.position[at(vertex)]) {
        sum += double(term.weight) * controls_[term.index];
    }
    return sum;
}

// Two chords whose cross product is the sector's normal: from one outer spoke to the other, and along those
// between; where these bend too far (in a sector of more than half a turn they may), the two spokes that span
// most in the bind pose.
std::pair<Builder::Chord, Builder::Chord> Builder::chords(int vertex, const std::vector<int>& spokes) const {
    const std::size_t last = spokes.size() - 1, skip = last > 1 ? 1 : 0;
    std::vector<dvec3> arms;
    for (const int spoke : spokes) {
        arms.push_back(bind_position(spoke) - bind_position(vertex));
    }
    dvec3 normal(0), inner(0);
    for (std::size_t i = 0; i < last; ++i) {
        normal += glm::cross(arms[i], arms[i + 1]);
    }
    std::pair<Chord, Chord> best{{{spokes.front(), 1.0}, {spokes.back(), -1.0}}, {}};
    for (std::size_t i = skip; i + skip <= last; ++i) {
        best.second.push_back({spokes[i], 1.0});
        best.second.push_back({vertex, -1.0});
        inner += arms[i];
    }
    const dvec3 outer = arms.front() - arms.back();
    const auto spanned = [&](const dvec3& a, const dvec3& b) { return glm::dot(glm::cross(a, b), normal); };
    constexpr double kWide = 0.3;  // sine of the angle between the two
    if (spanned(outer, inner) >= kWide * glm::length(outer) * glm::length(inner) * glm::length(normal)) {
        return best;
    }
    double most = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        for (std::size_t k = 0; k <= last; ++k) {
            if (spanned(arms[i], arms[k]) <= most) {
                continue;
            }
            most = spanned(arms[i], arms[k]);
            best = {{{spokes[i], 1.0}, {vertex, -1.0}}, {{spokes[k], 1.0}, {vertex, -1.0}}};
        }
    }
    return best;
}

std::uint32_t Builder::add_vertex(const Stencil& stencil, const Surface& value) {
    LimitVertex vertex{stencil.first, stencil.end, 0, 0, value.tangent.w < 0 ? -1.0f : 1.0f, vec3(0, 0, 1)};
    vertex.normal = unit_or(glm::cross(stencil.du, stencil.dv), unit_or(dvec3(value.normal), vec3(0, 0, 1)));
    // The texture's tangent by least squares: tangent = along_du du + along_dv dv.
    const dvec3 tangent(vec3(value.tangent));
    const double uu = glm::dot(stencil.du, stencil.du), uv = glm::dot(stencil.du, stencil.dv),
                 vv = glm::dot(stencil.dv, stencil.dv);
    const double determinant = uu * vv - uv * uv;
    if (determinant > 1e-12 * uu * vv) {
        const double tu = glm::dot(tangent, stencil.du), tv = glm::dot(tangent, stencil.dv);
        vertex.along_du = static_cast<float>((tu * vv - tv * uv) / determinant);
        vertex.along_dv = static_cast<float>((tv * uu - tu * uv) / determinant);
    }
    surface_.stencils.vertices.push_back(vertex);
    topology_->uv0.push_back(value.uv0);
    topology_->uv1.push_back(value.uv1);
    topology_->colours.push_back(value.colour);
    return static_cast<std::uint32_t>(surface_.stencils.vertices.size() - 1);
}

// Makes the refined vertices that lie on a vertex of the level: one for each of its sectors and, within it,
// for each of the values that texture seams give it.
void Builder::add_around(int vertex) {
    sectors_.split(vertex);
    const auto faces = level_.GetVertexFaces(vertex);
    const auto corners = level_.GetVertexFaceLocalIndices(vertex);
    std::vector<Stencil> stencils;
    if (sectors_.sectors.empty()) {
        stencils.push_back(merge(limit_.position[at(vertex)], limit_.du[at(vertex)], limit_.dv[at(vertex)]));
    }
    for (const Sector& sector : sectors_.sectors) {
        stencils.push_back(sector_stencil(vertex, sector));
    }
    std::map<std::pair<std::size_t, int>, std::uint32_t> made;
    for (int f = 0; f < faces.size(); ++f) {
        const std::size_t sector = sectors_.of_face[at(f)];
        const int value = level_.GetFaceFVarValues(faces[f])[corners[f]];
        const auto [found, fresh] = made.emplace(std::pair(sector, value), 0u);
        if (fresh) {
            found->second = add_vertex(stencils[sector], values_[at(value)]);
        }
        corner_vertex_[first_corner_[at(faces[f])] + corners[f]] = found->second;
    }
}

void Builder::add_triangles() {
    for (int f = 0; f < level_.GetNumFaces(); ++f) {
        const std::uint32_t* corner = corner_vertex_.data() + first_corner_[at(f)];
        const int size = level_.GetFaceVertices(f).size();
        for (int i = 1; i + 1 < size; ++i) {
            topology_->indices.insert(topology_->indices.end(), {corner[0], corner[i], corner[i + 1]});
        }
    }
}

RefinedSurface Builder::run() {
    std::size_t corners = 0;
    for (int f = 0; f < level_.GetNumFaces(); ++f) {
        first_corner_.push_back(corners);
        corners += at(level_.GetFaceVertices(f).size());
    }
    corner_vertex_.resize(corners);
    for (int v = 0; v < level_.GetNumVertices(); ++v) {
        add_around(v);
    }
    add_triangles();
    topology_->serial = next_serial();
    auto turned = std::make_shared<RefinedTopology>(*topology_);
    turned->serial = next_serial();
    for (std::size_t i = 0; i < turned->indices.size(); i += 3) {
        std::swap(turned->indices[i + 1], turned->indices[i + 2]);
    }
    surface_.topology = std::move(topology_);
    surface_.turned = std::move(turned);
    return std::move(surface_);
}

}  // namespace

RefinedSurface build_surface(const Far::TopologyRefiner& refiner, const CageTopology& cage,
                             const std::vector<Vertex>& vertices) {
    return Builder(refiner, cage, vertices).run();
}

}  // namespace lanthorn::deform
