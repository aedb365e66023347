#include "engine/assets/exr_channels.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace lanthorn {

namespace {

// R, G, B, then what has another name, then A; some programs write them small.
int rank_of(std::string_view name) {
    switch (name.size() == 1 ? name.front() : 0) {
        case 'R':
        case 'r':
            return 0;
        case 'G':
        case 'g':
            return 1;
        case 'B':
        case 'b':
            return 2;
        case 'A':
        case 'a':
            return 4;
        default:
            return 3;
    }
}

}  // namespace

std::vector<std::size_t> chosen_channels(const std::vector<std::string>& names) {
    std::vector<std::tuple<std::string, int, std::string, std::size_t>> all;  // layer, rank, name, place
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        const std::size_t dot = name.rfind('.');
        const bool layered = dot != std::string::npos;
        all.emplace_back(layered ? name.substr(0, dot) : "", rank_of(layered ? name.substr(dot + 1) : name),
                         name, i);
    }
    std::ranges::sort(all);
    const auto has = [&](std::size_t at, int rank) {
        return at < all.size() && std::get<1>(all[at]) == rank;
    };
    const bool rgb = has(0, 0) && has(1, 1) && has(2, 2);
    std::vector<std::size_t> chosen;
    for (const auto& [layer, rank, name, place] : all) {
        if (layer == std::get<0>(all.front()) && (!rgb || rank != 3) && chosen.size() < 4) {
            chosen.push_back(place);
        }
    }
    return chosen;
}

bool are_colours(const std::vector<std::string>& names) {
    const auto rank = [&](std::size_t i) {
        return rank_of(std::string_view(names[i]).substr(names[i].rfind('.') + 1));
    };
    return names.size() >= 3 && rank(0) == 0 && rank(1) == 1 && rank(2) == 2;
}

}  // namespace lanthorn
