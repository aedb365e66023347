// What light comes from.
#pragma once

#include <compare>
#include <cstdint>

namespace lanthorn::reference {

enum class LightKind : std::uint8_t { punctual, emitter, sky };

// What light comes from: an index into FrameScene::lights, or into its instances; of the sky 0.
struct LightSource {
    LightKind kind = LightKind::punctual;
    std::uint32_t index = 0;

    auto operator<=>(const LightSource&) const = default;
};

}  // namespace lanthorn::reference
