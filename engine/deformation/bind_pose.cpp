#include "engine/deformation/bind_pose.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::deform {
namespace {

using Weighted = std::pair<std::uint16_t, float>;

// The joints that do move the vertex, their weights' sum 1. Returns how many.
std::size_t influences(const SkinInfluences& of, std::array<Weighted, SkinInfluences::kMost>& to) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < SkinInfluences::kMost; ++k) {
        const float weight = of.weights[k];
        if (!(weight > 0) || !std::isfinite(weight)) {
            continue;
        }
        to[count++] = {of.joints[k], weight};
        sum += weight;
    }
    if (count == 0) {
        to[count++] = {of.joints[0], 1.0f};
        sum = 1;
    }
    for (std::size_t k = 0; k < count; ++k) {
        to[k].second = static_cast<float>(to[k].second / sum);
    }
    return count;
}

SkinStream pack_skin(const std::vector<SkinInfluences>& skin) {
    SkinStream stream;
    const std::size_t groups = (skin.size() + kLanes - 1) / kLanes;
    stream.first_round.reserve(groups + 1);
    for (std::size_t g = 0; g < groups; ++g) {
        const auto first = static_cast<std::uint32_t>(stream.weights.size());
        stream.first_round.push_back(first);
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            std::array<Weighted, SkinInfluences::kMost> of;
            const std::size_t count = influences(skin[std::min(g * kLanes + lane, skin.size() - 1)], of);
            if (stream.weights.size() < first + count) {
                stream.weights.resize(first + count, splat(0));
                stream.joints.resize(first + count, {});
            }
            for (std::size_t k = 0; k < count; ++k) {
                stream.joints[first + k].of[lane] = of[k].first;
                stream.weights[first + k][lane] = of[k].second;
                stream.last_joint = std::max(stream.last_joint, of[k].first);
            }
        }
    }
    stream.first_round.push_back(static_cast<std::uint32_t>(stream.weights.size()));
    return stream;
}

// The deltas of the listed vertices as they are, or spread over all groups.
std::vector<float> pack_deltas(const std::vector<vec3>& deltas, const MorphTarget& target, bool dense,
                               std::size_t groups) {
    std::vector<float> packed;
    if (deltas.size() != target.vertices.size()) {
        return packed;
    }
    packed.assign(dense ? groups * 3 * kLanes : deltas.size() * 3, 0.0f);
    for (std::size_t i = 0; i < deltas.size(); ++i) {
        const std::size_t v = target.vertices[i];
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            packed[dense ? (v / kLanes * 3 + a) * kLanes + v % kLanes : i * 3 + a] = deltas[i][axis];
        }
    }
    return packed;
}

MorphStream pack_morph(const MorphTarget& target, std::size_t vertices, std::size_t groups,
                       std::size_t blocks) {
    MorphStream stream;
    // A listed vertex costs about as much as a group of all.
    stream.dense = target.vertices.size() * 2 > vertices;
    stream.positions = pack_deltas(target.positions, target, stream.dense, groups);
    stream.normals = pack_deltas(target.normals, target, stream.dense, groups);
    stream.tangents = pack_deltas(target.tangents, target, stream.dense, groups);
    if (stream.dense) {
        return stream;
    }
    stream.vertices = target.vertices;
    for (std::size_t block = 0; block <= blocks; ++block) {
        const auto at =
            std::lower_bound(target.vertices.begin(), target.vertices.end(), block * kBlockVertices);
        stream.block_first.push_back(static_cast<std::uint32_t>(at - target.vertices.begin()));
    }
    return stream;
}

}  // namespace

BindPose pack(const Mesh& mesh) {
    BindPose pose;
    pose.vertex_count = static_cast<std::uint32_t>(mesh.vertices.size());
    pose.morph_weights = mesh.morph_weights;
    const std::size_t groups = (mesh.vertices.size() + kLanes - 1) / kLanes;
    pose.groups.resize(groups);
    for (std::size_t i = 0; i < groups * kLanes; ++i) {
        const Vertex& v = mesh.vertices[std::min(i, mesh.vertices.size() - 1)];
        VertexGroup& group = pose.groups[i / kLanes];
        const auto lane = static_cast<std::uint32_t>(i % kLanes);
        set_lane(group.position, lane, v.position);
        set_lane(group.normal, lane, v.normal);
        set_lane(group.tangent, lane, vec3(v.tangent));
        group.sign[lane] = v.tangent.w;
    }
    if (mesh.skin.size() == mesh.vertices.size()) {
        pose.skin = pack_skin(mesh.skin);
    }
    for (const MorphTarget& target : mesh.morphs) {
        pose.morphs.push_back(pack_morph(target, mesh.vertices.size(), groups, pose.block_count()));
    }
    return pose;
}

}  // namespace lanthorn::deform
