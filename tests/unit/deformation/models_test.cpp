// Real models, in the poses of their own clips and in random ones, against the independent evaluator.
// LANTHORN_MODELS names the folder of shared models.
#include <cstdlib>
#include <filesystem>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/transforms.h"
#include "tests/unit/deformation/rig.h"

namespace deformation_test {
namespace {

class Models : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        const char* folder = std::getenv("LANTHORN_MODELS");
        if (folder == nullptr) {
            GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
        }
        data_ = import_gltf((std::filesystem::path(folder) / GetParam()).string());
        nodes_ = data_.nodes;
        weights_.resize(nodes_.size());
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            weights_[n] = nodes_[n].morph_weights;
            if (weights_[n].empty() && !nodes_[n].meshes.empty()) {
                weights_[n] = data_.meshes[nodes_[n].meshes[0]].morph_weights;
            }
        }
        entities_ = spawn(world_, data_);
    }

    // What the clip's channels say at their last key at or before `time`, without interpolation.
    void pose(const AnimationClip& clip, float time);
    void pose(Random& random);
    // Brings the world to nodes_ and weights_ and compares every mesh that deforms. Returns how many.
    int compare();

    SceneData data_;
    std::vector<NodeData> nodes_;              // as posed
    std::vector<std::vector<float>> weights_;  // likewise, by node
    ecs::World world_;
    std::vector<ecs::Entity> entities_;
    Transforms transforms_;
    Deformation deformation_;

  private:
    dmat4 global(std::uint32_t node) const;
};

void Models::pose(const AnimationClip& clip, float time) {
    for (const AnimationChannel& channel : clip.channels) {
        std::size_t key = 0;
        while (key + 1 < channel.times.size() && channel.times[key + 1] <= time) {
            ++key;
        }
        const bool cubic = channel.interpolation == Interpolation::cubic_spline;
        const float* value = channel.values.data() + (cubic ? key * 3 + 1 : key) * channel.width;
        Transform& local = nodes_[channel.node].local;
        switch (channel.path) {
            case AnimationPath::translation:
                local.translation = dvec3(value[0], value[1], value[2]);
                break;
            case AnimationPath::rotation:
                local.rotation = glm::normalize(quat(value[3], value[0], value[1], value[2]));
                break;
            case AnimationPath::scale:
                local.scale = vec3(value[0], value[1], value[2]);
                break;
            case AnimationPath::weights:
                weights_[channel.node].assign(value, value + channel.width);
                break;
        }
    }
}

void Models::pose(Random& random) {
    for (NodeData& node : nodes_) {
        node.local.rotation = glm::normalize(node.local.rotation * random.rotation());
        node.local.scale *=
            vec3(random.between(0.7f, 1.4f), random.between(0.7f, 1.4f), random.between(-1.4f, -0.7f));
    }
    for (auto& weights : weights_) {
        for (float& w : weights) {
            w = random.below(3) ? random.between(-1, 1) : 0;
        }
    }
}

// glTF 2.0, 3.5.2 and 3.5.3: the product of the matrices T * R * S from the root down.
dmat4 Models::global(std::uint32_t node) const {
    const NodeData& data = nodes_[node];
    dmat4 local(glm::mat3_cast(glm::dquat(data.local.rotation)));
    for (int axis = 0; axis < 3; ++axis) {
        local[axis] *= double(data.local.scale[axis]);
    }
    local = local * dmat4(glm::dmat3(data.shear));
    local[3] = dvec4(data.local.translation, 1);
    return data.parent == kNone ? local : global(data.parent) * local;
}

int Models::compare() {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        world_.get_mut<LocalTransform>(entities_[n]).value = nodes_[n].local;
        if (world_.has<MorphWeights>(entities_[n])) {
            world_.get_mut<MorphWeights>(entities_[n]).weights = weights_[n];
        }
    }
    transforms_.update(world_);
    deformation_.update(world_);
    EXPECT_TRUE(deformation_.warnings().empty());
    int compared = 0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (std::size_t m = 0; m < nodes_[n].meshes.size(); ++m) {
            const Mesh& mesh = data_.meshes[nodes_[n].meshes[m]];
            const bool has_skin = nodes_[n].skin != kNone && !mesh.skin.empty();
            if (mesh.morphs.empty() && !has_skin) {
                continue;
            }
            const DeformedMeshes& deformed = world_.get<DeformedMeshes>(entities_[n]);
            std::vector<ExactVertex> exact;
            if (has_skin) {
                const Skin& skin = data_.skins[nodes_[n].skin];
                std::vector<dmat4> joints;
                for (const std::uint32_t joint : skin.joints) {
                    joints.push_back(global(joint));
                }
                exact = skinned(mesh, weights_[n], joints, skin.inverse_binds);
            } else {
                exact = morphed(mesh, weights_[n]);
            }
            SCOPED_TRACE(mesh.name);
            expect_near(deformed.meshes.at(m), exact, deformed.skinned_at, mesh.bounds.diagonal());
            ++compared;
        }
    }
    return compared;
}

TEST_P(Models, AgreeWithTheSpecificationInTheirOwnClips) {
    ASSERT_FALSE(data_.animations.empty());
    for (const AnimationClip& clip : data_.animations) {
        for (const float part : {0.0f, 0.3f, 0.7f}) {
            SCOPED_TRACE(clip.name + " at " + std::to_string(part * clip.duration));
            pose(clip, part * clip.duration);
            EXPECT_GT(compare(), 0);
        }
    }
}

TEST_P(Models, AgreeWithTheSpecificationInRandomPosesWithMirrors) {
    Random random(31);
    for (int i = 0; i < 3; ++i) {
        pose(random);
        EXPECT_GT(compare(), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Shared, Models,
                         testing::Values("bevy/Fox.glb", "bevy/MorphStressTest.gltf", "bevy/SimpleSkin.gltf"),
                         [](const auto& info) { return std::filesystem::path(info.param).stem().string(); });

}  // namespace
}  // namespace deformation_test
