// A hundred figures that share one mesh of 2 k vertices, and what their joints do.
#pragma once

#include <random>
#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace deformation_bench {

using namespace lanthorn;

inline float between(std::mt19937& random, float low, float high) {
    return low + (high - low) * float(random()) / float(std::mt19937::max());
}

// Neighbouring vertices share joints, as they do on a figure.
inline Mesh figure_mesh(std::uint32_t vertices, std::uint32_t joints, std::uint32_t influences,
                        std::mt19937& random) {
    Mesh mesh;
    mesh.name = "figure";
    for (std::uint32_t i = 0; i < vertices; ++i) {
        Vertex v;
        v.position = {between(random, -0.5f, 0.5f), 1.8f * float(i) / float(vertices),
                      between(random, -0.2f, 0.2f)};
        v.normal = glm::normalize(vec3(v.position.x, 0.1f, v.position.z));
        v.tangent = {0, 1, 0, 1};
        mesh.vertices.push_back(v);
        mesh.bounds.add(v.position);
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.indices.push_back((i + k) % vertices);
        }
        SkinInfluences by;
        for (std::uint32_t k = 0; k < influences; ++k) {
            by.joints[k] = std::uint16_t((i * joints / vertices + k) % joints);
            by.weights[k] = 1.0f / float(influences);
        }
        mesh.skin.push_back(by);
    }
    return mesh;
}

inline MorphTarget morph_of(const Mesh& mesh, std::uint32_t every, std::mt19937& random) {
    MorphTarget target;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); i += every) {
        target.vertices.push_back(i);
        target.positions.emplace_back(between(random, -0.1f, 0.1f));
        target.normals.emplace_back(between(random, -0.1f, 0.1f));
    }
    return target;
}

inline dmat4 joint_pose(std::uint32_t joint, int frame) {
    Transform pose;
    pose.translation = {0, 0.03 * joint, 0};
    pose.rotation = glm::angleAxis(0.01f * float(joint + std::uint32_t(frame)), vec3(0, 0, 1));
    return pose.matrix();
}

}  // namespace deformation_bench
