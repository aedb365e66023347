#include "tools/lanthorn/render/debug_views.h"

#include <fmt/format.h>

#include "lanthorn/gi/technique.h"

namespace lanthorn::tools {

std::string list_debug_views() {
    std::string text;
    for (const gi::TechniqueEntry& technique : gi::techniques()) {
        for (const gi::DebugView& view : technique.debug_views) {
            text += fmt::format("{:<12} {:<14} {:<6} {}\n", technique.name, view.name,
                                view.unit.empty() ? "-" : view.unit, view.docs);
        }
    }
    return text;
}

}  // namespace lanthorn::tools
