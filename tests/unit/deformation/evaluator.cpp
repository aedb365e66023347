#include "tests/unit/deformation/evaluator.h"

namespace deformation_test {
namespace {

dvec3 unit(const dvec3& v, const dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

}  // namespace

std::vector<ExactVertex> morphed(const Mesh& mesh, const std::vector<float>& weights) {
    std::vector<ExactVertex> result;
    for (const Vertex& v : mesh.vertices) {
        result.push_back({dvec3(v.position), dvec3(v.normal), dvec3(vec3(v.tangent)), v.tangent.w});
    }
    for (std::size_t t = 0; t < mesh.morphs.size() && t < weights.size(); ++t) {
        const MorphTarget& target = mesh.morphs[t];
        const double w = weights[t];
        for (std::size_t i = 0; i < target.vertices.size(); ++i) {
            ExactVertex& v = result[target.vertices[i]];
            v.position += w * dvec3(target.positions[i]);
            if (!target.normals.empty()) {
                v.normal += w * dvec3(target.normals[i]);
            }
            if (!target.tangents.empty()) {
                v.tangent += w * dvec3(target.tangents[i]);
            }
        }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i].normal = unit(result[i].normal, dvec3(mesh.vertices[i].normal));
        result[i].tangent = unit(result[i].tangent, dvec3(vec3(mesh.vertices[i].tangent)));
    }
    return result;
}

std::vector<ExactVertex> skinned(const Mesh& mesh, const std::vector<float>& weights,
                                 const std::vector<dmat4>& joints, const std::vector<mat4>& inverse_binds) {
    std::vector<ExactVertex> result = morphed(mesh, weights);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const SkinInfluences& by = mesh.skin[i];
        dmat4 matrix(0);
        double sum = 0;  // 1, but for rounding
        for (const float w : by.weights) {
            sum += w;
        }
        for (std::size_t k = 0; k < SkinInfluences::kMost; ++k) {
            if (by.weights[k] == 0) {
                continue;
            }
            matrix += by.weights[k] / sum * (joints[by.joints[k]] * dmat4(inverse_binds[by.joints[k]]));
        }
        ExactVertex& v = result[i];
        const glm::dmat3 linear(matrix);
        v.position = dvec3(matrix * dvec4(v.position, 1));
        v.normal = unit(glm::transpose(glm::inverse(linear)) * v.normal, v.normal);
        v.tangent = unit(linear * v.tangent, v.tangent);
        if (glm::determinant(linear) < 0) {
            v.sign = -v.sign;
        }
    }
    return result;
}

}  // namespace deformation_test
