#include "engine/image_module/radiance_header.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace lanthorn {

namespace {

constexpr std::size_t kLargestHeader = 65536;
constexpr std::string_view kXyz = "FORMAT=32-bit_rle_xyze";

// With the empty line at its end.
std::string_view header_of(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                                std::min(bytes.size(), kLargestHeader));
    return text.substr(0, std::min(text.find("\n\n"), text.find("\n\r\n")));
}

}  // namespace

RadianceHeader radiance_header(std::span<const std::uint8_t> bytes) {
    RadianceHeader header;
    double exposure = 1;
    for (std::string_view rest = header_of(bytes); !rest.empty();) {
        const std::string line(rest.substr(0, rest.find('\n')));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (line.starts_with("EXPOSURE=")) {
            const double value = std::strtod(line.c_str() + 9, nullptr);
            exposure *= value > 0 && std::isfinite(value) ? value : 1;
        } else if (line.starts_with("PRIMARIES=")) {
            const auto given = chromaticities_of(std::string_view(line).substr(10));
            header.colours = given ? to_bt709(*given) : header.colours;
        } else if (line.starts_with(kXyz)) {
            header.is_xyz = true;
        }
    }
    const auto scale = static_cast<float>(1 / exposure);
    header.scale = scale > 0 && std::isfinite(scale) ? scale : 1.0f;
    if (header.is_xyz) {
        header.colours = bt709_of_xyz();
    }
    return header;
}

std::string named_rgb(std::span<const std::uint8_t> bytes) {
    std::string text(bytes.begin(), bytes.end());
    for (std::size_t at = header_of(bytes).find(kXyz); at < header_of(bytes).size();
         at = header_of(bytes).find(kXyz, at + 1)) {
        text.replace(at + kXyz.size() - 4, 3, "rgb");
    }
    return text;
}

}  // namespace lanthorn
