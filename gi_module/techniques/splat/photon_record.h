// Photons as they are kept until they are splatted: 16 bytes each, because their power is that of their group
// times small numbers (Lavignotte and Paulin 2003, sec. 3.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/shared/photons/photon.h"
#include "gi_module/techniques/splat/splat_surfaces.h"

namespace lanthorn::gi {

// splat.comp reads these.
struct PhotonRecord {
    static constexpr std::uint32_t kMostCopies = 7;        // of a channel
    static constexpr std::uint32_t kMostSides = 1u << 22;  // of SurfaceSide

    vec3 position{0};  // render space
    // Copies of the group's power in r, g, b: 3 bits each; 1 bit: more of the photon of the record before;
    // the rest: SurfaceSide.
    std::uint32_t bits = 0;

    static constexpr std::uint32_t pack(const glm::uvec3& copies, SurfaceSide side, bool more = false) {
        return copies.x | copies.y << 3 | copies.z << 6 | (more ? 1u << 9 : 0u) | side << 10;
    }
    SurfaceSide side() const { return bits >> 10; }
    bool more() const { return (bits >> 9 & 1u) != 0; }
    std::uint32_t copies(int channel) const { return bits >> (3 * channel) & 7u; }
};
static_assert(sizeof(PhotonRecord) == 16);

// Photons in a row of one group of lights that lie on one side of one surface, near each other.
struct PhotonBlock {
    static constexpr std::uint32_t kMost = 64;

    vec3 lower{0};
    std::uint32_t first = 0;  // of the run
    vec3 upper{0};
    std::uint32_t count = 0;
    SurfaceSide side = 0;
    std::uint16_t group = 0;
};

// Photons of one kind, traced together; what is read at once. Of all groups of lights, so that a scene of
// many lamps has no more runs than one of a single lamp.
struct RecordRun {
    bool caustic = false;
    std::vector<PhotonRecord> records;
    // Of the records, in order: by side, then group, then along a curve through space.
    std::vector<PhotonBlock> blocks;
};

// How many times the group's power a photon carries, by channel: the whole part of flux / power, and one more
// by the chance of what is left, so that the mean is exact. `u` in [0, 1). A channel that the group lacks has
// 0.
glm::uvec3 copies_of(const vec3& flux, const vec3& power, float u);

// Adds records of a photon; more than one where a channel has more than kMostCopies, all but the first
// more().
void add_records(const Photon& photon, const vec3& power, SurfaceSide side, float u,
                 std::vector<PhotonRecord>& records);

// Sorts a run's records and makes its blocks. `groups`: of each record; empty: all of group 0. O(n log n).
void arrange(RecordRun& run, std::span<const std::uint16_t> groups = {});

}  // namespace lanthorn::gi
