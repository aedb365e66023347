// In which order displays are tried for a context without a window.
#pragma once

#include <vector>

namespace lanthorn::gpu {

template <typename Display>
struct DisplayAttempt {
    Display display;
    bool software;  // whether a context that draws on the processor will do
};

// Real devices first. Their displays, and surfaceless ones, where Mesa picks a driver, may turn out to draw
// on the processor after all: that will do once nothing else is left. `always_software`: what draws on the
// processor is wanted (LIBGL_ALWAYS_SOFTWARE).
template <typename Display>
std::vector<DisplayAttempt<Display>> display_order(const std::vector<Display>& hardware,
                                                   const std::vector<Display>& surfaceless,
                                                   const std::vector<Display>& software,
                                                   bool always_software) {
    std::vector<DisplayAttempt<Display>> order;
    const auto add = [&](const std::vector<Display>& displays, bool any) {
        for (const Display& display : displays) {
            order.push_back({display, any});
        }
    };
    if (!always_software) {
        add(hardware, false);
        add(surfaceless, false);
    }
    add(surfaceless, true);
    add(software, true);
    add(hardware, true);
    return order;
}

}  // namespace lanthorn::gpu
