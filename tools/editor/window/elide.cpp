#include "tools/editor/window/elide.h"

#include <cstddef>
#include <vector>

namespace lanthorn::edit_window {

std::string elided(std::string_view text, float room,
                   const std::function<float(std::string_view)>& width_of) {
    if (width_of(text) <= room) {
        return std::string(text);
    }
    std::vector<std::size_t> begins;  // of characters
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0u) != 0x80u) {
            begins.push_back(i);
        }
    }
    const auto with = [&](std::size_t kept) {
        const std::size_t last = kept / 2;
        const std::size_t end = begins.at(kept - last);
        const std::size_t tail = last > 0 ? begins.at(begins.size() - last) : text.size();
        return std::string(text.substr(0, end)) + "..." + std::string(text.substr(tail));
    };
    std::size_t kept = begins.empty() ? 0 : begins.size() - 1;
    while (kept > 1 && width_of(with(kept)) > room) {
        --kept;
    }
    return kept > 1 ? with(kept) : "...";
}

}  // namespace lanthorn::edit_window
