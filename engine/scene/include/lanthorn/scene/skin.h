// A glTF skin (glTF 2.0, 3.7.3.1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

struct Skin {
    std::string name;
    std::vector<std::uint32_t> joints;  // indices into SceneData::nodes
    std::vector<mat4> inverse_binds;    // one a joint
};

}  // namespace lanthorn
