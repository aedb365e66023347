// A light sensor as the shaders read and write it (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_SENSOR_DATA_H
#define LANTHORN_SENSOR_DATA_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

namespace lanthorn::render {
#endif

const uint kSensorsBinding = 0u;           // storage buffer of SensorData
const uint kSensorIrradianceBinding = 1u;  // storage buffer of vec4: rgb in lux, one a sensor
const uint kSensorLanes = 64u;  // invocations a sensor, and points of its disc that light is taken at

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
#endif
