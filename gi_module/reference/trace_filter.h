// What the filters of rays know of the geometry that they are asked about: its user data for Embree.
#pragma once

#include <cstdint>

#include "gi_module/reference/trace_scene.h"

namespace lanthorn::reference {

struct TraceScene::FilterData {
    const MaterialTable* materials;
    const TraceScene* scene;
    std::uint32_t instance;
    bool mask = false;
    bool blend = false;
    float nearest = 0;  // metres: nearer to a ray's start it is not met
};

}  // namespace lanthorn::reference
