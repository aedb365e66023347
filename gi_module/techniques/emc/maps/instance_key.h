// What tells an instance's mesh from all others, in tables by instance.
#pragma once

#include <cstdint>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

inline std::uint64_t instance_key(const Instance& instance) {
    return std::uint64_t{instance.id} << 32 | instance.mesh;
}

}  // namespace lanthorn::gi
