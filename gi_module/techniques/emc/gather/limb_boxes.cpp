#include "gi_module/techniques/emc/gather/limb_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lanthorn::gi {

namespace {

using glm::dmat3;

constexpr std::size_t kBins = 16;  // places along each axis that a group may be cut at
constexpr float kPadding = 0.02f;  // of the mesh's diagonal: what is thin is not for nothing, since it moves

using Triangles = std::vector<std::uint32_t>;  // numbers of triangles

struct Cut {
    int axis = -1;  // -1: none makes the boxes smaller
    float at = 0;
    float gain = 0;  // m^3 of air that no box has any more
};

struct Group {
    Triangles triangles;
    Aabb box;
    Cut cut;  // the best one
};

class Splitter {
  public:
    Splitter(std::span<const VertexFrame> vertices, std::span<const std::uint32_t> indices) {
        boxes_.reserve(indices.size() / 3);
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            Aabb& box = boxes_.emplace_back();
            for (std::size_t k = i; k < i + 3; ++k) {
                box.add(vertices[indices[k]].position);
            }
            all_.add(boxes_.back());
        }
    }

    Group all() const {
        Group group;
        group.box = all_;
        for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
            group.triangles.push_back(t);
        }
        group.cut = best_cut(group);
        return group;
    }

    // Where the boxes on both sides have the least volume.
    Cut best_cut(const Group& group) const {
        Cut best;
        for (int axis = 0; axis < 3; ++axis) {
            const float low = group.box.lower[axis];
            const float width = group.box.size()[axis] / kBins;
            if (!(width > 0)) {
                continue;
            }
            std::array<Aabb, kBins> bins{};
            for (const std::uint32_t t : group.triangles) {
                const auto bin = static_cast<std::size_t>((boxes_[t].centre()[axis] - low) / width);
                bins[std::min(bin, kBins - 1)].add(boxes_[t]);
            }
            std::array<Aabb, kBins> above = bins;
            for (std::size_t b = kBins - 1; b-- > 0;) {
                above[b].add(above[b + 1]);
            }
            Aabb below;
            for (std::size_t b = 0; b + 1 < kBins; ++b) {
                below.add(bins[b]);
                const float gain = volume(group.box) - volume(below) - volume(above[b + 1]);
                if (!below.empty() && !above[b + 1].empty() && gain > best.gain) {
                    best = {axis, low + width * static_cast<float>(b + 1), gain};
                }
            }
        }
        return best;
    }

    // Cuts it; what lies above is returned.
    Group take_upper(Group& group) const {
        const Cut cut = group.cut;
        const auto is_lower = [&](std::uint32_t t) { return boxes_[t].centre()[cut.axis] < cut.at; };
        const auto middle = std::stable_partition(group.triangles.begin(), group.triangles.end(), is_lower);
        Group upper;
        upper.triangles.assign(middle, group.triangles.end());
        group.triangles.erase(middle, group.triangles.end());
        for (Group* part : {&group, &upper}) {
            part->box = {};
            for (const std::uint32_t t : part->triangles) {
                part->box.add(boxes_[t]);
            }
            part->cut = best_cut(*part);
        }
        return upper;
    }

  private:
    float volume(const Aabb& box) const {
        const vec3 size = box.size() + kPadding * all_.diagonal();
        return size.x * size.y * size.z;
    }

    std::vector<Aabb> boxes_;  // by triangle
    Aabb all_;
};

// The rotation nearest to a matrix (Higham 1986, "Computing the polar decomposition"); none if it mirrors, or
// says nothing of some direction.
dmat3 nearest_rotation(dmat3 m) {
    constexpr int kSteps = 20;
    constexpr double kLeast = 1e-4;  // determinant, of the cube of the norm: 20 steps are enough
    const double norm = std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
    if (!(glm::determinant(m) > kLeast * norm * norm * norm)) {
        return dmat3(1);
    }
    m /= norm;
    for (int i = 0; i < kSteps; ++i) {
        m = 0.5 * (m + glm::transpose(glm::inverse(m)));
    }
    return m;
}

}  // namespace

Limbs::Limbs(std::span<const VertexFrame> vertices, std::span<const std::uint32_t> indices,
             std::size_t most) {
    const Splitter splitter(vertices, indices);
    std::vector<Group> groups{splitter.all()};
    while (groups.size() < most) {
        Group& widest = *std::ranges::max_element(groups, {}, [](const Group& g) { return g.cut.gain; });
        if (widest.cut.axis < 0) {
            break;
        }
        Group upper = splitter.take_upper(widest);
        if (upper.triangles.empty() || widest.triangles.empty()) {
            break;  // by rounding
        }
        groups.push_back(std::move(upper));
    }
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> group_of(vertices.size(), kNone);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (const std::uint32_t t : groups[g].triangles) {
            for (std::size_t k = 3 * std::size_t{t}; k < 3 * std::size_t{t} + 3; ++k) {
                if (group_of[indices[k]] != g) {
                    group_of[indices[k]] = g;
                    vertices_.push_back(indices[k]);
                }
            }
        }
        ends_.push_back(vertices_.size());
    }
}

std::vector<Aabb> Limbs::boxes(std::span<const VertexFrame> vertices, const mat4& transform) const {
    std::vector<Aabb> result;
    std::size_t i = 0;
    for (const std::size_t end : ends_) {
        Aabb& box = result.emplace_back();
        for (; i < end; ++i) {
            box.add(vec3(transform * vec4(vertices[vertices_[i]].position, 1)));
        }
    }
    return result;
}

std::vector<LimbMotion> Limbs::motions(const Pose& before, const Pose& now) const {
    std::vector<LimbMotion> result;
    std::size_t first = 0;
    for (const std::size_t end : ends_) {
        LimbMotion& motion = result.emplace_back();
        const std::span<const std::uint32_t> group(vertices_.data() + first, end - first);
        const auto place = [](const Pose& pose, std::uint32_t v) {
            return dvec3(pose.transform * vec4(pose.vertices[v].position, 1));
        };
        // The cofactor matrix takes normals where the inverse transpose does, flattened objects too.
        const auto normal = [](const Pose& pose, std::uint32_t v) {
            const dmat3 m(pose.transform);
            const dvec3 n = dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])) *
                            dvec3(pose.vertices[v].normal);
            const double length = glm::length(n);
            return length > 0 ? n / length : n;
        };
        dvec3 from(0), to(0);
        for (const std::uint32_t v : group) {
            motion.before.add(vec3(place(before, v)));
            from += place(before, v);
            to += place(now, v);
        }
        from /= static_cast<double>(group.size());
        to /= static_cast<double>(group.size());
        // Normals tell what places in one plane or line do not; together they count as much as these.
        dmat3 places(0), normals(0);
        double spread = 0;
        for (const std::uint32_t v : group) {
            const dvec3 arm = place(before, v) - from;
            places += glm::outerProduct(place(now, v) - to, arm);
            normals += glm::outerProduct(normal(now, v), normal(before, v));
            spread += glm::dot(arm, arm);
        }
        const dmat3 turn = nearest_rotation(places + spread / static_cast<double>(group.size()) * normals);
        motion.carry = mat4(mat3(turn));
        motion.carry[3] = vec4(vec3(to - turn * from), 1);
        first = end;
    }
    return result;
}

}  // namespace lanthorn::gi
