#include "lanthorn/gi/emc/limb_boxes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lanthorn::gi {

namespace {

constexpr std::size_t kBins = 16;  // places along each axis that a group may be cut at
constexpr float kPadding = 0.02f;  // of the mesh's diagonal: what is thin is not for nothing, since it moves

using Triangles = std::vector<std::uint32_t>;  // numbers of triangles

struct Group {
    Triangles triangles;
    Aabb box;
};

struct Cut {
    int axis = -1;  // -1: none makes the boxes smaller
    float at = 0;
    float gain = 0;  // m^3 of air that no box has any more
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

    Group take_upper(Group& group, const Cut& cut) const {
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

}  // namespace

Limbs::Limbs(std::span<const VertexFrame> vertices, std::span<const std::uint32_t> indices,
             std::size_t most) {
    const Splitter splitter(vertices, indices);
    std::vector<Group> groups{splitter.all()};
    while (groups.size() < most) {
        Cut best;
        std::size_t chosen = 0;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const Cut cut = splitter.best_cut(groups[g]);
            if (cut.gain > best.gain) {
                best = cut;
                chosen = g;
            }
        }
        if (best.axis < 0) {
            break;
        }
        Group upper = splitter.take_upper(groups[chosen], best);
        if (upper.triangles.empty() || groups[chosen].triangles.empty()) {
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

}  // namespace lanthorn::gi
