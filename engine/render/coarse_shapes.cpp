#include "engine/render/coarse_shapes.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanthorn::render {

namespace {

constexpr float kFinest = 0.0005f, kCoarsest = 0.13f;  // errors that are tried, shares of the longest side
constexpr float kWorthwhile = 0.75f;                   // of the triangles of the level before
constexpr float kBend = 0.1f;  // how far joints are pulled apart, a share of the diagonal of the shape's box

// What two vertices must share to be one.
struct Corner {
    vec3 position{0};  // pulled_apart()
    vec2 uv0{0}, uv1{0};
    vec4 colour{0};
};
static_assert(sizeof(Corner) == 44, "compared byte by byte");

// Where a vertex goes when each joint is pulled into a direction of its own: a limb that is straight in the
// bind pose has a kink there at every joint, which costs what it would cost to lose it when the limb bends.
// What hangs on one joint alone stays as it is. Directions of joints that follow each other lie far apart (a
// spiral on the sphere; Vogel 1979).
vec3 pulled_apart(const SkinInfluences& skin) {
    constexpr float kGoldenAngle = 2.399963f;
    vec3 offset(0);
    for (std::size_t k = 0; k < SkinInfluences::kMost; ++k) {
        if (skin.weights[k] > 0) {
            const auto joint = static_cast<float>(skin.joints[k]);
            const float y = 2 * glm::fract(0.5f + 0.381966f * joint) - 1;
            const float r = std::sqrt(1 - y * y);
            offset += skin.weights[k] *
                      vec3(r * std::cos(kGoldenAngle * joint), y, r * std::sin(kGoldenAngle * joint));
        }
    }
    return offset;
}

// Corners that are in all alike are one: edges of normals alone hold nothing. (meshoptimizer leaves places
// alone where vertices lie on each other, used or not.)
class Simplifier {
  public:
    Simplifier(const InstanceShape& shape, bool textured) {
        std::vector<Corner> all;
        all.reserve(shape.vertex_count());
        for (std::size_t v = 0; v < shape.vertex_count(); ++v) {
            box_.add(shape.position(v));
        }
        // Refined vertices have no influences of their own.
        const bool skinned = shape.mesh().skin.size() == shape.vertex_count();
        for (std::size_t v = 0; v < shape.vertex_count(); ++v) {
            const Vertex vertex = shape.vertex(v);
            const vec3 pull =
                skinned ? kBend * box_.diagonal() * pulled_apart(shape.mesh().skin[v]) : vec3(0);
            all.push_back({vertex.position + pull, textured ? vertex.uv0 : vec2(0),
                           textured ? vertex.uv1 : vec2(0), vertex.colour});
        }
        corner_of_.resize(all.size());
        const std::size_t count = meshopt_generateVertexRemap(corner_of_.data(), nullptr, all.size(),
                                                              all.data(), all.size(), sizeof(Corner));
        corners_.resize(count);
        vertex_of_.resize(count);
        for (std::size_t v = all.size(); v-- > 0;) {
            corners_[corner_of_[v]] = all[v];
            vertex_of_[corner_of_[v]] = static_cast<std::uint32_t>(v);
        }
    }

    std::vector<std::uint32_t> to_corners(std::span<const std::uint32_t> vertices) const {
        return looked_up(vertices, corner_of_);
    }
    std::vector<std::uint32_t> to_vertices(std::span<const std::uint32_t> corners) const {
        return looked_up(corners, vertex_of_);
    }

    // Adds `error`, a share of the longest side, at most. Where edges cannot be collapsed (thin things of
    // many parts), vertices near each other become one.
    std::vector<std::uint32_t> simplified(const std::vector<std::uint32_t>& indices, float& error) const {
        std::vector<std::uint32_t> result(indices.size());
        const float most = error;
        result.resize(meshopt_simplify(result.data(), indices.data(), indices.size(), &corners_[0].position.x,
                                       corners_.size(), sizeof(Corner), 0, most, 0, &error));
        if (worthwhile(result, indices)) {
            return result;
        }
        result.resize(indices.size());
        result.resize(meshopt_simplifySloppy(result.data(), indices.data(), indices.size(),
                                             &corners_[0].position.x, corners_.size(), sizeof(Corner),
                                             indices.size() / 6 * 3, most, &error));
        return result;
    }

    static bool worthwhile(const std::vector<std::uint32_t>& now, const std::vector<std::uint32_t>& before) {
        return !now.empty() &&
               static_cast<float>(now.size()) < kWorthwhile * static_cast<float>(before.size());
    }

    float longest_side() const {
        return meshopt_simplifyScale(&corners_[0].position.x, corners_.size(), sizeof(Corner));
    }

    float diagonal() const { return box_.diagonal(); }

  private:
    static std::vector<std::uint32_t> looked_up(std::span<const std::uint32_t> indices,
                                                const std::vector<std::uint32_t>& table) {
        std::vector<std::uint32_t> result(indices.size());
        std::ranges::transform(indices, result.begin(), [&](std::uint32_t i) { return table[i]; });
        return result;
    }

    Aabb box_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> corner_of_;  // by vertex
    std::vector<std::uint32_t> vertex_of_;  // by corner: the first
};

// Metres.
float mean_edge(const InstanceShape& shape, const std::vector<std::uint32_t>& indices) {
    float sum = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 along = shape.position(indices[i + k]) - shape.position(indices[i + (k + 1) % 3]);
            sum += glm::dot(along, along);
        }
    }
    return std::sqrt(sum / static_cast<float>(indices.size()));
}

}  // namespace

std::vector<CoarseLevel> coarser_levels(const InstanceShape& shape, bool textured) {
    std::vector<CoarseLevel> levels;
    if (shape.indices().size() < 3 * kLeastCoarsened) {
        return levels;
    }
    const Simplifier simplifier(shape, textured);
    const float share = simplifier.longest_side() / simplifier.diagonal();
    if (!(share > 0)) {
        return levels;
    }
    std::vector<std::uint32_t> before = simplifier.to_corners(shape.indices());
    float spent = 0;
    for (float wanted = kFinest; wanted < kCoarsest; wanted *= 2) {
        float error = wanted - spent;
        std::vector<std::uint32_t> now = simplifier.simplified(before, error);
        if (error <= wanted - spent && Simplifier::worthwhile(now, before)) {
            spent += error;
            CoarseLevel& level = levels.emplace_back(CoarseLevel{simplifier.to_vertices(now), spent * share});
            level.edge = mean_edge(shape, level.indices) / simplifier.diagonal();
            before = std::move(now);
        }
    }
    return levels;
}

}  // namespace lanthorn::render
