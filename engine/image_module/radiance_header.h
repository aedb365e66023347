// What the header of a Radiance picture says of its values (Ward, "Real Pixels", 1991; Radiance's
// filefmts.pdf).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/assets/primaries.h"

namespace lanthorn {

struct RadianceHeader {
    float scale = 1;                      // 1 / the product of the lines EXPOSURE=x
    bool is_xyz = false;                  // FORMAT=32-bit_rle_xyze
    std::optional<ColourMatrix> colours;  // to BT.709, of XYZ or of the last line PRIMARIES=
};

// Lines that say nothing, an exposure that is not positive and primaries that are none, are passed over.
RadianceHeader radiance_header(std::span<const std::uint8_t> bytes);

// The file as one of RGB, for readers that take no XYZ: its numbers are the same.
std::string named_rgb(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn
