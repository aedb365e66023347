// The answer to compare with: morphs and skinning in double precision, written straight from glTF 2.0
// (3.7.2.2 "Morph Targets", 3.7.3 "Skins") without anything of engine/deformation.
#pragma once

#include <vector>

#include "lanthorn/scene/mesh.h"

namespace deformation_test {

using namespace lanthorn;

struct ExactVertex {
    dvec3 position{0}, normal{0}, tangent{0};
    double sign = 1;  // of the bitangent
};

// The vertices after morphing, in object space.
std::vector<ExactVertex> morphed(const Mesh& mesh, const std::vector<float>& weights);

// The vertices after morphing and skinning, in world space; `joints`: global transforms.
std::vector<ExactVertex> skinned(const Mesh& mesh, const std::vector<float>& weights,
                                 const std::vector<dmat4>& joints, const std::vector<mat4>& inverse_binds);

}  // namespace deformation_test
