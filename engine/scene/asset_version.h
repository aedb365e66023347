// Versions of assets: numbers that tell whoever keeps something made of an asset whether it still holds.
#pragma once

#include <cstdint>

#include "lanthorn/scene/material.h"

namespace lanthorn {

// Greater than all before and never the same twice in a process. Thread-safe.
std::uint64_t next_asset_version();

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
    std::uint64_t surface = 0;   // where it leaves holes, and from which sides it is seen: alpha, sidedness
    std::uint64_t albedo = 0;    // what it reflects diffusely
    std::uint64_t emission = 0;  // what it emits
    std::uint64_t relief = 0;    // which way its surface is turned: the normal map

    AssetVersion() = default;
    explicit AssetVersion(std::uint64_t version)
        : any(version), surface(version), albedo(version), emission(version), relief(version) {}
    bool operator==(const AssetVersion&) const = default;

    // The version of `now`, edited from `before`, which was of this version: `next` in what differs.
    AssetVersion edited(const Material& before, const Material& now, std::uint64_t next) const;
    // The same after the pixels, or the sampler, of `texture` were altered; unless `m` does not use it.
    AssetVersion retextured(const Material& m, std::uint32_t texture, std::uint64_t next) const;
};

}  // namespace lanthorn
