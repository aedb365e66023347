#include "engine/deformation/morph.h"

#include <cstring>

namespace lanthorn::deform {
namespace {

using Attribute = std::array<Lanes, 3> VertexGroup::*;

// Groups of a block, one bit each.
using Touched = std::uint64_t;
static_assert(kBlockGroups == 64);

Touched add_dense(const std::vector<float>& deltas, std::uint32_t first_group, float weight,
                  std::span<VertexGroup> groups, Attribute attribute) {
    const Lanes w = splat(weight);
    const float* from = deltas.data() + std::size_t{first_group} * 3 * kLanes;
    for (VertexGroup& group : groups) {
        for (std::size_t axis = 0; axis < 3; ++axis, from += kLanes) {
            Lanes delta;
            std::memcpy(&delta, from, sizeof delta);
            (group.*attribute)[axis] += w * delta;
        }
    }
    return ~Touched{0};
}

Touched add_sparse(const std::vector<float>& deltas, const MorphStream& stream, std::uint32_t block,
                   float weight, std::span<VertexGroup> groups, Attribute attribute) {
    Touched touched = 0;
    for (std::uint32_t i = stream.block_first[block]; i < stream.block_first[block + 1]; ++i) {
        const std::uint32_t v = stream.vertices[i] - block * kBlockVertices;
        auto& values = groups[v / kLanes].*attribute;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            values[axis][v % kLanes] += weight * deltas[std::size_t{i} * 3 + axis];
        }
        touched |= Touched{1} << (v / kLanes);
    }
    return touched;
}

Touched add(const std::vector<float>& deltas, const MorphStream& stream, std::uint32_t block, float weight,
            std::span<VertexGroup> groups, Attribute attribute) {
    if (deltas.empty()) {
        return 0;
    }
    return stream.dense ? add_dense(deltas, block * kBlockGroups, weight, groups, attribute)
                        : add_sparse(deltas, stream, block, weight, groups, attribute);
}

void make_unit(const BindPose& pose, std::uint32_t block, Touched touched, std::span<VertexGroup> groups,
               Attribute attribute) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (!(touched >> g & 1)) {
            continue;
        }
        const auto moved = groups[g].*attribute;
        const auto& bound = pose.groups[std::size_t{block} * kBlockGroups + g].*attribute;
        normalise(groups[g].*attribute, [&](std::uint32_t lane) {
            return unit_or(dvec3(lane_of(moved, lane)), lane_of(bound, lane));
        });
    }
}

}  // namespace

void add_morphs(const BindPose& pose, std::uint32_t block, std::span<const ActiveMorph> active,
                std::span<VertexGroup> groups) {
    Touched normals = 0, tangents = 0;
    for (const ActiveMorph& morph : active) {
        const MorphStream& stream = pose.morphs[morph.target];
        add(stream.positions, stream, block, morph.weight, groups, &VertexGroup::position);
        normals |= add(stream.normals, stream, block, morph.weight, groups, &VertexGroup::normal);
        tangents |= add(stream.tangents, stream, block, morph.weight, groups, &VertexGroup::tangent);
    }
    make_unit(pose, block, normals, groups, &VertexGroup::normal);
    make_unit(pose, block, tangents, groups, &VertexGroup::tangent);
}

}  // namespace lanthorn::deform
