// What the composite keeps from frame to frame, as C++ has it (composite_state.glsl).
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/core/math.h"
#include "lanthorn/gpu/buffer.h"

namespace lanthorn::render {

struct CompositeState {
    float exposure = 0;
    float average_luminance = 0;
    std::uint32_t nan_count = 0;
    std::uint32_t reserved = 0;
    vec4 around{0};
};
static_assert(sizeof(CompositeState) == 32 && offsetof(CompositeState, average_luminance) == 4 &&
              offsetof(CompositeState, nan_count) == 8 && offsetof(CompositeState, around) == 16);

constexpr GLuint kCompositeStateBinding = 4;

}  // namespace lanthorn::render
