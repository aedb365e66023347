// The GPU's vertices against the CPU's, vertex by vertex.
#include "lanthorn/render/gpu_skinning.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"
#include "tests/unit/deformation/rig.h"

namespace lanthorn {
namespace {

using deform::ActiveMorph;
using deform::JointMatrix;
using deformation_test::Random;

class GpuSkinning : public testing::Test {
  protected:
    void SetUp() override {
        static const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
        context->make_current();
    }

    std::vector<JointMatrix> random_joints(std::size_t count, const vec3& scale) {
        std::vector<JointMatrix> joints;
        for (std::size_t i = 0; i < count; ++i) {
            Transform pose;
            pose.translation = dvec3(random_.vector(0.5f));
            pose.rotation = random_.rotation();
            pose.scale = scale * random_.between(0.7f, 1.4f);
            joints.push_back(deform::joint_matrix(pose.matrix(), mat4(1), dvec3(0)));
        }
        return joints;
    }

    void compare(const Mesh& mesh, const std::vector<JointMatrix>& joints,
                 const std::vector<ActiveMorph>& morphs) {
        const deform::BindPose pose = deform::pack(mesh);
        std::vector<deform::VertexGroup> groups = pose.groups;
        for (std::uint32_t block = 0; block < pose.block_count(); ++block) {
            const std::size_t first = block * deform::kBlockGroups;
            deform::add_morphs(
                pose, block, morphs,
                std::span(groups).subspan(
                    first, std::min<std::size_t>(deform::kBlockGroups, groups.size() - first)));
        }
        std::vector<VertexFrame> cpu(pose.vertex_count);
        deform::BoundsLanes bounds;
        if (!pose.skin.empty()) {
            deform::skin_groups(pose, joints, 0, groups, cpu.data(), bounds);
        } else if (!joints.empty()) {
            deform::move_groups(pose, joints.back(), 0, groups, cpu.data(), bounds);
        } else {
            deform::copy_groups(pose, 0, groups, cpu.data(), bounds);
        }

        render::GpuSkinning skinning;
        const render::GpuSkinnedMesh uploaded(pose);
        const gpu::Buffer frames(pose.vertex_count * sizeof(VertexFrame));
        skinning.run(uploaded, joints, morphs, frames);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        const auto gpu = frames.read<VertexFrame>(pose.vertex_count);
        const float tolerance = 1e-5f * mesh.bounds.diagonal();
        for (std::size_t i = 0; i < cpu.size(); ++i) {
            ASSERT_LE(glm::length(gpu[i].position - cpu[i].position), tolerance) << "vertex " << i;
            ASSERT_LE(glm::length(gpu[i].normal - cpu[i].normal), 1e-4f) << "vertex " << i;
            ASSERT_LE(glm::length(gpu[i].tangent - cpu[i].tangent), 1e-4f) << "vertex " << i;
        }
    }

    Random random_{41};
};

TEST_F(GpuSkinning, AgreesWithTheCpuForAnyNumberOfInfluences) {
    for (const std::uint32_t influences : {1u, 2u, 4u, 7u, 8u}) {
        Mesh mesh = deformation_test::cloud(997 + influences, random_);
        deformation_test::add_skin(mesh, 70, influences, random_);
        compare(mesh, random_joints(70, vec3(1, 0.6f, 1.5f)), {});
    }
}

TEST_F(GpuSkinning, AgreesUnderMirrors) {
    Mesh mesh = deformation_test::cloud(500, random_);
    deformation_test::add_skin(mesh, 9, 1, random_);
    compare(mesh, random_joints(9, vec3(-1, 1, 2)), {});
}

TEST_F(GpuSkinning, AgreesWithMorphsSparseAndDense) {
    Mesh mesh = deformation_test::cloud(1501, random_);
    for (const std::uint32_t moved : {1500u, 1u, 40u, 900u, 300u}) {
        mesh.morphs.push_back(deformation_test::target(mesh, moved, random_));
    }
    mesh.morphs[2].normals.clear();
    mesh.morphs[3].tangents.clear();
    const std::vector<ActiveMorph> active{{0, 0.5f}, {1, 1}, {2, -0.7f}, {3, 0.2f}};
    compare(mesh, {}, active);
    compare(mesh, random_joints(1, vec3(1)), active);
    deformation_test::add_skin(mesh, 12, 4, random_);
    compare(mesh, random_joints(12, vec3(1)), active);
}

TEST_F(GpuSkinning, AFlattenedFigureKeepsSoundFrames) {
    Mesh mesh = deformation_test::cloud(64, random_);
    deformation_test::add_skin(mesh, 1, 1, random_);
    const std::vector<JointMatrix> flat(1, JointMatrix{});
    compare(mesh, flat, {});
}

TEST_F(GpuSkinning, RefusesBuffersAndJointsThatDoNotSuffice) {
    Mesh mesh = deformation_test::cloud(64, random_);
    deformation_test::add_skin(mesh, 5, 4, random_);
    render::GpuSkinning skinning;
    const render::GpuSkinnedMesh uploaded(deform::pack(mesh));
    const auto joints = random_joints(5, vec3(1));
    EXPECT_THROW(skinning.run(uploaded, joints, {}, gpu::Buffer(100)), InputError);
    EXPECT_THROW(
        skinning.run(uploaded, std::span(joints).first(2), {}, gpu::Buffer(64 * sizeof(VertexFrame))),
        InputError);
}

TEST_F(GpuSkinning, TellsHowLongBothTake) {
    Mesh mesh = deformation_test::cloud(500, random_);
    deformation_test::add_skin(mesh, 20, 4, random_);
    const auto times = render::measure_skinning(deform::pack(mesh), random_joints(20, vec3(1)), 3, 3);
    EXPECT_GT(times.cpu_ms, 0);
    EXPECT_GT(times.gpu_ms, 0);
}

}  // namespace
}  // namespace lanthorn
