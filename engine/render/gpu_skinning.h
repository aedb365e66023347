// Morphs and skins on the GPU, from the same packed mesh as engine/deformation and to the same vertices
// within 1e-5 of the mesh's size. Which of the two is faster is the machine's: see measure_skinning().
#pragma once

#include <span>
#include <vector>

#include "lanthorn/deformation/morph.h"
#include "lanthorn/deformation/skinning.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::render {

// A mesh on the GPU, uploaded once.
class GpuSkinnedMesh {
  public:
    explicit GpuSkinnedMesh(const deform::BindPose& pose);

  private:
    friend class GpuSkinning;
    // Where a target's deltas begin; see ActiveMorphData.
    struct Target {
        bool dense;
        std::uint32_t first, count, positions, normals, tangents;
    };

    std::uint32_t vertex_count_;
    bool skinned_;
    std::uint32_t last_joint_;
    std::vector<Target> targets_;
    gpu::Buffer bind_pose_, first_round_, rounds_, morph_list_, morph_deltas_;
};

class GpuSkinning {
  public:
    // Compiles the shader; throws Error if that fails.
    GpuSkinning();

    // Writes a VertexFrame for each vertex to `frames`, from its beginning. `joints` as skin_groups() takes
    // them; for a mesh without influences the last one moves all, and none leaves it where it is. Throws
    // InputError if `frames` is too small or joints are missing. Whoever reads `frames` issues the barrier
    // that its way of reading needs.
    void run(const GpuSkinnedMesh& mesh, std::span<const deform::JointMatrix> joints,
             std::span<const deform::ActiveMorph> morphs, const gpu::Buffer& frames);

  private:
    gpu::Program program_;
    gpu::Buffer joints_, morphs_;
};

struct SkinningTimes {
    double cpu_ms = 0, gpu_ms = 0;  // medians
    bool gpu_is_faster() const { return gpu_ms < cpu_ms; }
};

// How long this machine takes for `figures` of this mesh with `joints`, `runs` times in turn: the CPU on all
// its threads, vertices uploaded to a buffer; the GPU to the same, finished.
SkinningTimes measure_skinning(const deform::BindPose& pose, std::span<const deform::JointMatrix> joints,
                               int figures, int runs = 9);

}  // namespace lanthorn::render
