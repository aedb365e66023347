// One light as the shaders read it (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_LIGHT_DATA_H
#define LANTHORN_LIGHT_DATA_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

namespace lanthorn::render {
#endif

const uint kLightsBinding = 2u;  // storage (and uniform) buffer binding of the LightData array

const uint kMaxUniformLights = 128u;  // as many as a uniform block of the smallest allowed size holds

const int kLightTexels = 8;  // texels (RGBA32UI) of a LightData

// Texels (RGBA32F) of a node of a tree of lamps (lamp_tree.h).
const int kLampNodeTexels = 6;

// Texels (RGBA32F) of a node of what an area sample stands for (near_emitters.h).
const int kEmitterNodeTexels = 4;

// LightData::type
const uint kLightDirectional = 0u;
const uint kLightPoint = 1u;
const uint kLightSpot = 2u;
const uint kLightAreaSample = 3u;  // one of the points that stand for emissive surfaces

const uint kMergedSurfaces = 0xffffffffu;  // LightData::id of an area sample that stands for several surfaces

struct LightData {
    vec3 position;   // render space; directional: centre of the map's near plane
    float range;     // metres, 1e30 where infinite
    vec3 direction;  // unit, the way it shines; area sample: the surface's normal
    uint type;
    vec3 intensity;  // rgb: candela (point, spot), lux (directional), nits (area sample)
    float area;      // m^2 that an area sample stands for; else 0
    vec3 right;  // unit axes of the map of a spot's frustum or a directional light: right x up = -direction
    float cone_scale;
    vec3 up;            // area sample: the middle of what it stands for, in render space
    float cone_offset;  // spot: attenuation = clamp(cos * cone_scale + cone_offset, 0, 1)^2; area sample: its
                        // nodes are those from cone_scale on and before cone_offset (near_emitters.h)
    float extent;  // spot: tangent of the frustum's half angle; directional: half width of the map in metres
    float cos_outer;   // spot: cosine of the outer cone; else -1
    uint first_layer;  // of the light-map array (area samples: of the area array)
    uint layers;       // 6: cube in cube.glsl's order; 1: frustum or orthographic; 0: no map, casts no shadow
    uint id;           // LightInstance::id; area sample: Instance::id of the surface, or kMergedSurfaces
    float depth_range;  // directional: metres from near to far plane of the map; area sample: from `up` to
                        // its farthest point
    float texel;  // width of a map texel: at distance 1 on the axis (cube, frustum), in metres (directional)
    uint two_sided;   // area sample: 1 if it shines to both sides of its surface
    vec3 map_offset;  // from `position` to where the map is seen from; 0 where the map is the light's own
    uint shares_map;  // 1: the map is another lamp's, as there are more lamps than maps
#ifdef __cplusplus
    bool operator==(const LightData&) const = default;
#endif
};

#ifdef __cplusplus
static_assert(sizeof(LightData) == 16 * kLightTexels);
}  // namespace lanthorn::render
#endif
#endif
