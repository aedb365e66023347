// A light sensor as the shaders read and write it (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_SENSOR_DATA_H
#define LANTHORN_SENSOR_DATA_H

#ifdef __cplusplus
#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::render {
using uint = std::uint32_t;
#define LANTHORN_CONST constexpr
#else
#define LANTHORN_CONST const
#endif

LANTHORN_CONST uint kSensorsBinding = 0u;           // storage buffer of SensorData
LANTHORN_CONST uint kSensorIrradianceBinding = 1u;  // storage buffer of vec4: rgb in lux, one a sensor
LANTHORN_CONST uint kSensorLanes =
    64u;  // invocations a sensor, and points of its disc that light is taken at

struct SensorData {
    vec3 position;  // render space
    float radius;   // metres
    vec3 normal;    // unit
    float unused;
};

#ifdef __cplusplus
static_assert(sizeof(SensorData) == 32);
}  // namespace lanthorn::render
#endif
#undef LANTHORN_CONST
#endif
