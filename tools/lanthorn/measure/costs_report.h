// What `lanthorn measure costs` found: for people, for programs, and as a page.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tools/lanthorn/measure/costs.h"

namespace lanthorn::tools {

// How it was measured.
struct CostsHead {
    ivec2 size{0};
    int warmup = 0, frames = 0, rounds = 0;
    std::string technique, preset;  // an empty preset: the settings' defaults
    std::vector<std::string> set;
    std::string renderer, build;
    std::string time;  // what milliseconds are of, in words: time_words()
};

// Of bytes, as all three say them: 10^6.
inline double megabytes(std::uint64_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}
std::string time_words(bool software);
// A motion's passes, those that take most first, and what is beside them, in words; together the whole frame
// but for rounding.
std::vector<std::pair<std::string, PassCost>> ordered_passes(const FrameCosts& costs);
struct RestLine {
    std::string name;
    double ms = 0;
};
std::vector<RestLine> rest_lines(const FrameCosts& costs);

// How far the rounds lie apart: less than that tells nothing.
std::string noise_words(const MotionCosts& costs);

// Tables of one scene; lines end in a newline.
std::string costs_text(const SceneCosts& scene, const CostsHead& head);
// What costs.json holds.
nlohmann::ordered_json costs_json(const std::vector<SceneCosts>& scenes, const CostsHead& head);
// costs.html, whole: needs nothing beside it. Well-formed as XML, too.
std::string costs_html(const std::vector<SceneCosts>& scenes, const CostsHead& head);

}  // namespace lanthorn::tools
