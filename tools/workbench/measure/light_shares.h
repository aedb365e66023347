// What each light gives to a picture, by the path tracer.
#pragma once

#include <cstdint>
#include <vector>

#include "gi_module/reference/light_split.h"

namespace lanthorn::workbench {

// What a lamp, emissive surfaces and sky included, gives of all light that falls on what the camera sees.
struct LightShare {
    reference::LightSource source;
    std::uint32_t entity = 0;  // the lamp's; of the sky 0
    double lux = 0;            // the mean of all places
    double share = 0;          // 0..1 of all lamps' together
};
inline constexpr double kWorthHaving = 0.005;  // share below which a lamp is hardly seen

// By so many places of the picture, by so many paths from each. Most first. O(places * paths).
std::vector<LightShare> light_shares(const reference::LightSplitter& light, const CameraView& camera,
                                     ivec2 size, int places = 256, int paths = 64);

}  // namespace lanthorn::workbench
