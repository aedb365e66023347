#include "lanthorn/render/gpu_skinning.h"

#include <algorithm>
#include <chrono>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/parallel.h"
#include "lanthorn/render/gpu_skinning_data.h"

namespace lanthorn::render {
namespace {

constexpr int kGroupSize = 64;  // as in gpu_skinning.comp

std::vector<VertexFrame> frames_of(const deform::BindPose& pose) {
    std::vector<VertexFrame> frames(pose.vertex_count);
    deform::BoundsLanes bounds;
    deform::copy_groups(pose, 0, pose.groups, frames.data(), bounds);
    return frames;
}

std::vector<InfluenceRound> rounds_of(const deform::SkinStream& skin) {
    std::vector<InfluenceRound> rounds;
    for (std::size_t i = 0; i < skin.weights.size(); ++i) {
        const auto& joints = skin.joints[i].of;
        const deform::Lanes weights = skin.weights[i];
        rounds.push_back({joints[0] | std::uint32_t{joints[1]} << 16,
                          joints[2] | std::uint32_t{joints[3]} << 16, weights[0], weights[1], weights[2],
                          weights[3]});
    }
    return rounds;
}

// Keeps a buffer as large as it was ever needed.
template <class T>
void write(gpu::Buffer& buffer, std::span<const T> data) {
    if (buffer.bytes() < data.size_bytes() || !buffer) buffer = gpu::Buffer(data.size_bytes());
    if (!data.empty()) buffer.write(0, data);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

GpuSkinnedMesh::GpuSkinnedMesh(const deform::BindPose& pose)
    : vertex_count_(pose.vertex_count),
      skinned_(!pose.skin.empty()),
      last_joint_(pose.skin.last_joint),
      bind_pose_(gpu::Buffer::from(frames_of(pose))),
      first_round_(gpu::Buffer::from(pose.skin.first_round)),
      rounds_(gpu::Buffer::from(rounds_of(pose.skin))) {
    std::vector<std::uint32_t> list;
    std::vector<float> deltas;
    const auto append = [&](const std::vector<float>& values) {
        if (values.empty()) return kNoDeltas;
        const auto at = static_cast<std::uint32_t>(deltas.size());
        deltas.insert(deltas.end(), values.begin(), values.end());
        return at;
    };
    for (const deform::MorphStream& morph : pose.morphs) {
        Target target{morph.dense,
                      static_cast<std::uint32_t>(list.size()),
                      static_cast<std::uint32_t>(morph.vertices.size()),
                      0,
                      0,
                      0};
        target.positions = append(morph.positions);
        target.normals = append(morph.normals);
        target.tangents = append(morph.tangents);
        targets_.push_back(target);
        list.insert(list.end(), morph.vertices.begin(), morph.vertices.end());
    }
    morph_list_ = gpu::Buffer::from(list);
    morph_deltas_ = gpu::Buffer::from(deltas);
}

GpuSkinning::GpuSkinning() : program_({"engine/render/gpu_skinning.comp"}) {}

void GpuSkinning::run(const GpuSkinnedMesh& mesh, std::span<const deform::JointMatrix> joints,
                      std::span<const deform::ActiveMorph> morphs, const gpu::Buffer& frames) {
    if (frames.bytes() < mesh.vertex_count_ * sizeof(VertexFrame)) {
        throw InputError("GPU skinning: the buffer for the vertices is too small");
    }
    if (mesh.skinned_ && joints.size() <= mesh.last_joint_) {
        throw InputError("GPU skinning: there are fewer joints than the vertices refer to");
    }
    std::vector<ActiveMorphData> active;
    for (const deform::ActiveMorph& morph : morphs) {
        const auto& target = mesh.targets_.at(morph.target);
        active.push_back({target.dense, target.first, target.count, morph.weight, target.positions,
                          target.normals, target.tangents, 0});
    }
    write(joints_, joints);
    write(morphs_, std::span<const ActiveMorphData>(active));
    program_.use();
    program_.set("vertex_count", static_cast<int>(mesh.vertex_count_));
    program_.set("morph_count", static_cast<int>(active.size()));
    program_.set("placement", mesh.skinned_    ? kPlaceBySkin
                              : joints.empty() ? kPlaceAsTheyAre
                                               : kPlaceByOneMatrix);
    program_.set("last_joint", static_cast<int>(joints.size()) - 1);
    mesh.bind_pose_.bind_storage(kBindPoseBinding);
    mesh.first_round_.bind_storage(kFirstRoundBinding);
    mesh.rounds_.bind_storage(kRoundsBinding);
    joints_.bind_storage(kJointsBinding);
    mesh.morph_list_.bind_storage(kMorphListBinding);
    mesh.morph_deltas_.bind_storage(kMorphDeltasBinding);
    morphs_.bind_storage(kMorphsBinding);
    frames.bind_storage(kFramesBinding);
    program_.dispatch(static_cast<int>(mesh.vertex_count_), kGroupSize);
}

SkinningTimes measure_skinning(const deform::BindPose& pose, std::span<const deform::JointMatrix> joints,
                               int figures, int runs) {
    const auto count = static_cast<std::size_t>(figures);
    GpuSkinning skinning;
    const GpuSkinnedMesh mesh(pose);
    std::vector<std::vector<VertexFrame>> frames(count, std::vector<VertexFrame>(pose.vertex_count));
    std::vector<gpu::Buffer> buffers;
    for (std::size_t i = 0; i < count; ++i) buffers.emplace_back(pose.vertex_count * sizeof(VertexFrame));
    std::vector<double> cpu, gpu;
    for (int i = 0; i < runs; ++i) {
        cpu.push_back(milliseconds([&] {
            ecs::detail::parallel_for(count, [&](std::size_t f) {
                deform::BoundsLanes bounds;
                deform::skin_groups(pose, joints, 0, pose.groups, frames[f].data(), bounds);
            });
            for (std::size_t f = 0; f < count; ++f) {
                buffers[f].write(0, std::span<const VertexFrame>(frames[f]));
            }
            glFinish();
        }));
        gpu.push_back(milliseconds([&] {
            for (const gpu::Buffer& buffer : buffers) skinning.run(mesh, joints, {}, buffer);
            glFinish();
        }));
    }
    return {median(std::move(cpu)), median(std::move(gpu))};
}

}  // namespace lanthorn::render
