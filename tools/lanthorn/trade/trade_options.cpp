#include "tools/lanthorn/trade/trade_options.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lanthorn::tools {

std::vector<std::string> of_references(const TradeOptions& options) {
    constexpr std::array<std::string_view, 2> kKept = {"path.transport=", "path.caustics="};
    std::vector<std::string> list;
    for (const std::string& assignment : options.sweep.common) {
        if (std::ranges::any_of(kKept, [&](std::string_view name) { return assignment.starts_with(name); })) {
            list.push_back(assignment);
        }
    }
    return list;
}

}  // namespace lanthorn::tools
