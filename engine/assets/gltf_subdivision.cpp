#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "engine/assets/gltf_deformation.h"

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::uint64_t kMaxLevel = 5;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

// A number that is an integer of low..high; glTF files may write it as 4.0.
std::optional<std::uint32_t> integer(const json& value, std::uint64_t low, std::uint64_t high) {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= static_cast<double>(low) && number <= static_cast<double>(high)) ||
        number != static_cast<double>(static_cast<std::uint64_t>(number))) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(number);
}

// Reads one `subdivision` object. problem() is not empty if there is something wrong with it.
class CageReader {
  public:
    CageReader(const json& source, std::string place, const std::vector<std::uint32_t>& indices)
        : source_(source), place_(std::move(place)), indices_(indices) {}

    SubdivisionCage run();
    const std::string& place() const { return place_; }
    const std::string& problem() const { return problem_; }

  private:
    // Remembers the first problem.
    void wrong(const std::string& where, const std::string& problem);
    void read_scheme();
    void read_faces();
    void read_creases();
    std::set<Edge> edges() const;

    const json& source_;
    std::string place_;
    const std::vector<std::uint32_t>& indices_;
    SubdivisionCage cage_;
    std::string problem_;
};

void CageReader::wrong(const std::string& where, const std::string& problem) {
    if (problem_.empty()) {
        place_ += where;
        problem_ = problem;
    }
}

void CageReader::read_scheme() {
    const auto scheme = source_.find("scheme");
    if (scheme != source_.end() && *scheme == "catmull-clark") {
        cage_.scheme = SubdivisionScheme::catmull_clark;
    } else if (scheme != source_.end() && *scheme == "loop") {
        cage_.scheme = SubdivisionScheme::loop;
    } else {
        wrong("/scheme", "expected \"catmull-clark\" or \"loop\"");
    }
    if (const auto level = source_.find("level"); level != source_.end()) {
        const auto number = integer(*level, 1, kMaxLevel);
        cage_.level = number.value_or(1);
        if (!number) {
            wrong("/level", fmt::format("expected an integer from 1 to {}", kMaxLevel));
        }
    }
}

void CageReader::read_faces() {
    const auto faces = source_.find("faces");
    if (faces == source_.end()) {
        return;
    }
    if (!faces->is_array()) {
        wrong("/faces", "expected an array of numbers of corners");
        return;
    }
    std::size_t triangle = 0;
    const std::size_t triangles = indices_.size() / 3;
    for (std::size_t f = 0; f < faces->size() && problem_.empty(); ++f) {
        const std::string where = fmt::format("/faces/{}", f);
        const auto corners = integer((*faces)[f], 3, 0xffff);
        if (!corners) {
            wrong(where, "expected an integer of 3 or more, the face's corners");
        } else if (cage_.scheme == SubdivisionScheme::loop && *corners != 3) {
            wrong(where,
                  fmt::format("found {} corners, expected 3: the loop scheme has triangles alone", *corners));
        } else if (triangle + *corners - 2 > triangles) {
            wrong(where, fmt::format("the faces have more triangles than the primitive's {}", triangles));
        } else {
            for (std::uint32_t t = 1; t + 2 < *corners; ++t) {
                const std::uint32_t* fan = indices_.data() + (triangle + t) * 3;
                if (fan[0] != fan[-3] || fan[1] != fan[-1]) {
                    wrong(where,
                          fmt::format("triangles {} and {} are not neighbours in a fan around their first "
                                      "corner",
                                      triangle + t - 1, triangle + t));
                }
            }
            cage_.face_sizes.push_back(*corners);
            triangle += *corners - 2;
        }
    }
    if (triangle != triangles) {
        wrong("/faces",
              fmt::format("the faces have {} triangles, expected the primitive's {}", triangle, triangles));
    }
}

std::set<Edge> CageReader::edges() const {
    std::set<Edge> found;
    std::size_t triangle = 0;
    const std::size_t triangles = indices_.size() / 3;
    for (std::size_t f = 0; triangle < triangles; ++f) {
        const std::uint32_t corners = cage_.face_sizes.empty() ? 3 : cage_.face_sizes[f];
        const std::uint32_t* fan = indices_.data() + triangle * 3;
        found.insert(edge(fan[0], fan[1]));
        for (std::uint32_t t = 0; t + 2 < corners; ++t, fan += 3) {
            found.insert(edge(fan[1], fan[2]));
        }
        found.insert(edge(fan[-1], fan[-3]));
        triangle += corners - 2;
    }
    return found;
}

void CageReader::read_creases() {
    const auto creases = source_.find("creases");
    if (creases == source_.end()) {
        return;
    }
    if (!creases->is_array()) {
        wrong("/creases", "expected an array of [vertex, vertex, sharpness]");
        return;
    }
    const std::set<Edge> known = edges();
    for (std::size_t c = 0; c < creases->size() && problem_.empty(); ++c) {
        const json& crease = (*creases)[c];
        const std::string where = fmt::format("/creases/{}", c);
        if (!crease.is_array() || crease.size() != 3 || !crease[2].is_number() ||
            !(crease[2].get<double>() >= 0)) {
            wrong(where, "expected [vertex, vertex, sharpness of 0 or more]");
            break;
        }
        const auto from = integer(crease[0], 0, kNone - 1);
        const auto to = integer(crease[1], 0, kNone - 1);
        if (!from || !to || !known.contains(edge(*from, *to))) {
            wrong(where, "expected the two vertices of an edge of the primitive's faces");
            break;
        }
        // OpenSubdiv's Sdc::Crease::SHARPNESS_INFINITE is 10.
        cage_.creases.push_back({*from, *to, static_cast<float>(std::min(crease[2].get<double>(), 10.0))});
    }
}

SubdivisionCage CageReader::run() {
    if (!source_.is_object()) {
        wrong("", "expected an object");
        return {};
    }
    read_scheme();
    if (problem_.empty()) {
        read_faces();
    }
    if (problem_.empty()) {
        read_creases();
    }
    return std::move(cage_);
}

const json* subdivision_of(const json& object) {
    const auto extras = object.find("extras");
    if (extras == object.end() || !extras->is_object()) {
        return nullptr;
    }
    const auto found = extras->find("subdivision");
    return found == extras->end() ? nullptr : &*found;
}

}  // namespace

std::optional<SubdivisionCage> read_cage(const GltfContext& context, std::size_t mesh, std::size_t primitive,
                                         const std::vector<std::uint32_t>& indices) {
    const json& mesh_json = context.file.json["meshes"][mesh];
    const json& primitive_json = mesh_json["primitives"][primitive];
    std::string place = fmt::format("/meshes/{}/primitives/{}/extras/subdivision", mesh, primitive);
    const json* source = subdivision_of(primitive_json);
    if (!source) {
        source = subdivision_of(mesh_json);
        place = fmt::format("/meshes/{}/extras/subdivision", mesh);
    }
    if (!source) {
        return std::nullopt;
    }
    if (context.model.meshes[mesh].primitives[primitive].mode != TINYGLTF_MODE_TRIANGLES) {
        context.warn(place, "expected a primitive that is a list of triangles; not subdivided");
        return std::nullopt;
    }
    CageReader reader(*source, place, indices);
    SubdivisionCage cage = reader.run();
    if (!reader.problem().empty()) {
        context.warn(reader.place(), reader.problem() + "; not subdivided");
        return std::nullopt;
    }
    return cage;
}

void remap(SubdivisionCage& cage, const VertexSources& sources, std::size_t vertices_before) {
    std::vector<std::uint32_t> place(vertices_before, kNone);
    for (std::size_t v = 0; v < sources.size(); ++v) {
        place[sources[v]] = static_cast<std::uint32_t>(v);
    }
    for (SubdivisionCrease& crease : cage.creases) {
        crease.from = place[crease.from];
        crease.to = place[crease.to];
    }
}

}  // namespace lanthorn
