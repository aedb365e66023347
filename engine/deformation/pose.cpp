#include "engine/deformation/pose.h"

#include <cmath>

namespace lanthorn::deform {

std::string_view take_pose(const ecs::World& world, const PoseSources& from, std::size_t last_joint,
                           bool own_matrix, Pose& pose) {
    pose.skinned = from.skin != nullptr;
    pose.at = dvec3(0);
    pose.joints.clear();
    if (!from.skin) {
        return {};
    }
    const SkinInstance& skin = *from.skin;
    if (skin.joints.size() <= last_joint) {
        return "its skin has fewer joints than its vertices refer to";
    }
    if (!skin.inverse_binds.empty() && skin.inverse_binds.size() != skin.joints.size()) {
        return "its skin has another number of inverse bind matrices than of joints";
    }
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        const WorldTransform* joint = world.try_get<WorldTransform>(skin.joints[i]);
        if (!joint) {
            return "a joint of its skin is gone or has no world transform";
        }
        if (i == 0) {
            pose.at = dvec3(joint->matrix[3]);
        }
        pose.joints.push_back(joint_matrix(
            joint->matrix, skin.inverse_binds.empty() ? mat4(1) : skin.inverse_binds[i], pose.at));
        if (!finite(pose.joints.back())) {
            return "a joint's transform is not finite";
        }
    }
    if (own_matrix) {
        if (!from.transform) {
            return "it has no world transform";
        }
        pose.joints.push_back(joint_matrix(from.transform->matrix, mat4(1), pose.at));
        if (!finite(pose.joints.back())) {
            return "its world transform is not finite";
        }
    }
    return {};
}

std::string_view take_weights(const MorphWeights* weights, const BindPose& mesh,
                              std::vector<ActiveMorph>& active) {
    const std::vector<float>& values = weights ? weights->weights : mesh.morph_weights;
    std::string_view problem;
    active.clear();
    for (std::size_t i = 0; i < std::min(values.size(), mesh.morphs.size()); ++i) {
        if (!std::isfinite(values[i])) {
            problem = "a morph weight is not finite and counts as 0";
        } else if (values[i] != 0) {
            active.push_back({static_cast<std::uint32_t>(i), values[i]});
        }
    }
    return problem;
}

}  // namespace lanthorn::deform
