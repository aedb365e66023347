// Where somebody looks from, as text and as a camera.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/workbench/scene/comma_numbers.h"

namespace lanthorn::workbench {

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& expected) {
    throw InputError(fmt::format("--pose: found '{}', expected {}", text, expected));
}

}  // namespace

CameraPose pose_of(const std::string& text) {
    std::vector<double> numbers = comma_numbers(text).value_or(std::vector<double>());
    if (numbers.size() == 5) {
        numbers.push_back(CameraPose().fov);
    }
    if (numbers.size() != 6) {
        refuse(text, "X,Y,Z,YAW,PITCH or X,Y,Z,YAW,PITCH,FOV");
    }
    if (std::abs(numbers[4]) > 90) {
        refuse(text, "a pitch from -90 to 90 degrees");
    }
    if (!(numbers[5] >= 0.1 && numbers[5] <= 179)) {
        refuse(text, "a field of view from 0.1 to 179 degrees");
    }
    return {{numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4], numbers[5]};
}

std::string text_of(const CameraPose& pose) {
    std::string text = fmt::format("{},{},{},{},{}", pose.at.x, pose.at.y, pose.at.z, pose.yaw, pose.pitch);
    if (pose.fov != CameraPose().fov) {
        text += fmt::format(",{}", pose.fov);
    }
    return text;
}

Transform transform_of(const CameraPose& pose) {
    Transform transform;
    transform.translation = pose.at;
    const glm::dquat turn = glm::angleAxis(glm::radians(pose.yaw), dvec3(0, 1, 0)) *
                            glm::angleAxis(glm::radians(pose.pitch), dvec3(1, 0, 0));
    transform.rotation = quat(turn);
    return transform;
}

Camera camera_of(const CameraPose& pose) {
    Camera camera;
    camera.y_fov = static_cast<float>(glm::radians(pose.fov));
    return camera;
}

CameraPose pose_of(const dmat4& world, const Camera& camera) {
    CameraPose pose;
    pose.at = dvec3(world[3]);
    const dvec3 back(world[2]);
    const double length = glm::length(back);
    if (length > 0 && std::isfinite(length)) {
        const dvec3 ahead = -back / length;
        pose.pitch = glm::degrees(std::asin(std::clamp(ahead.y, -1.0, 1.0)));
        pose.yaw = glm::degrees(std::atan2(-ahead.x, -ahead.z));
    }
    if (!camera.orthographic) {
        pose.fov = std::clamp(glm::degrees(static_cast<double>(camera.y_fov)), 0.1, 179.0);
    }
    return pose;
}

std::string add_pose_camera(SceneData& scene, const CameraPose& pose) {
    NodeData node;
    node.name = "pose";
    const auto is_taken = [&](const std::string& name) {
        return std::ranges::any_of(scene.nodes, [&](const NodeData& n) { return n.name == name; });
    };
    while (is_taken(node.name)) {
        node.name += '_';
    }
    node.local = transform_of(pose);
    node.camera = static_cast<std::uint32_t>(scene.cameras.size());
    scene.cameras.push_back(camera_of(pose));
    std::string name = node.name;
    scene.nodes.push_back(std::move(node));
    return name;
}

}  // namespace lanthorn::workbench
