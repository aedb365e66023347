// Which random number is for what: the dimensions of a sample's RandomNumbers, and when paths may end by
// chance.
#pragma once

#include <cstdint>

namespace lanthorn::reference {

// A sample's paths have kPathDimensions each, and their vertices kVertexDimensions.
inline constexpr std::uint32_t kIrradiancePath = 0;
inline constexpr std::uint32_t kRadiancePath = 1;
enum Dimension : std::uint32_t {
    kDirection,
    kChoices,   // of a light, of an emissive triangle
    kEmitter,   // the point on it
    kLobe,      // of a BSDF, of going on
    kStraight,  // of going straight on, for the n-th surface in a row: kStraight + n
};
inline constexpr std::uint32_t kVertexDimensions = 16;
inline constexpr std::uint32_t kSky = kVertexDimensions - 1;  // the direction to a place of the sky
inline constexpr std::uint32_t kStraightChoices = kSky - kStraight;
inline constexpr std::uint32_t kPathDimensions = 1u << 16;
inline constexpr std::uint32_t kCameraDimension = 0xfffff0u;

// The n-th boundary of a volume on a ray that leaves a vertex takes two pairs, far from all others.
inline constexpr int kMostBoundaries = 128;
inline std::uint32_t boundary_dimension(std::uint32_t vertex, int boundary) {
    return 0x80000000u | (vertex << 8 | static_cast<std::uint32_t>(2 * boundary));
}

inline constexpr int kRouletteFrom = 3;       // reflections before Russian roulette may end an unlimited path
inline constexpr float kMostSurvive = 0.98f;  // so that even a white room's paths end
inline constexpr int kMostReflections = 2000;

inline std::uint32_t vertex_dimension(std::uint32_t path, int vertex) {
    return path * kPathDimensions + static_cast<std::uint32_t>(vertex) * kVertexDimensions;
}

}  // namespace lanthorn::reference
