// Versions of assets: numbers that show whether something derived from an asset is still valid.
#pragma once

#include <cstdint>

#include "lanthorn/scene/material.h"

namespace lanthorn {

// Greater than all before and never the same twice in a process. Thread-safe.
std::uint64_t next_asset_version();

// Materials in the first so many slots are kept by number in maps, so that another base colour leaves these
// as they are (engine/render/include/lanthorn/render/scene_structs.h).
inline constexpr std::uint32_t kNumberedMaterials = 2047;

// Another one whenever anything of the asset is altered.
template <class T>
struct AssetVersion {
    std::uint64_t any = 0;

    AssetVersion() = default;
    explicit AssetVersion(std::uint64_t version) : any(version) {}
    bool operator==(const AssetVersion&) const = default;
};

// Of a material also what of it was altered; what its textures show counts as the material's.
template <>
struct AssetVersion<Material> {
    std::uint64_t any = 0;
    std::uint64_t surface = 0;  // where it leaves holes, and from which sides it is seen: alpha, sidedness
    std::uint64_t albedo = 0;   // what it reflects of even light
    std::uint64_t pattern =
        0;  // of that, what its base colour's factor does not say: textures, metal, glass, roughness
    std::uint64_t emission = 0;  // what it emits
    std::uint64_t relief = 0;    // which way its surface is turned: the normal map

    AssetVersion() = default;
    explicit AssetVersion(std::uint64_t version)
        : any(version),
          surface(version),
          albedo(version),
          pattern(version),
          emission(version),
          relief(version) {}
    bool operator==(const AssetVersion&) const = default;

    // Of what maps keep that store for each texel the material, by its slot, and its pattern.
    std::uint64_t kept(std::uint32_t slot) const { return slot < kNumberedMaterials ? pattern : albedo; }
    // The version of `now`, edited from `before`, which was of this version: `next` in what differs.
    AssetVersion edited(const Material& before, const Material& now, std::uint64_t next) const;
    // The same after the pixels, or the sampler, of `texture` were altered; unless `m` does not use it.
    AssetVersion retextured(const Material& m, std::uint32_t texture, std::uint64_t next) const;
};

}  // namespace lanthorn
