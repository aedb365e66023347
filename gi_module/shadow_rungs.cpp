#include "gi_module/shadow_rungs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lanthorn::gi {

namespace {

constexpr std::array kTexels = {1024, 768, 512, 384, 256, 192, 128};
constexpr int kMostRowsATexel = 3;
constexpr int kFewestOfAreaLights = 32;
constexpr const char* kOfLamps = "render.shadow.resolution";
constexpr const char* kOfAreaLights = "render.area_lights.resolution";

}  // namespace

int fewer_shadow_texels(int texels, int rows) {
    const auto* const found = std::ranges::find_if(kTexels, [&](int t) { return t < texels; });
    return found != kTexels.end() && *found * kMostRowsATexel >= rows ? *found : texels;
}

std::vector<std::string> shadow_assignments(const Settings& settings, int texels) {
    const int chosen = settings.get<int>(kOfAreaLights);
    const int smaller = chosen * texels / std::max(settings.get<int>(kOfLamps), texels);
    return {fmt::format("{}={}", kOfLamps, texels),
            fmt::format("{}={}", kOfAreaLights, std::max(smaller, std::min(chosen, kFewestOfAreaLights)))};
}

void add_coarser_shadows(BudgetLadder& ladder, const Settings& settings, int rows, std::size_t group) {
    const int chosen = settings.get<int>(kOfLamps);
    for (int before = chosen, now = 0; (now = fewer_shadow_texels(before, rows)) < before; before = now) {
        BudgetRung rung = ladder.rungs.back();
        rung.name = fmt::format("shadows {}", now);
        rung.set = shadow_assignments(settings, now);
        rung.cost[group] *= static_cast<double>(now) * now / (static_cast<double>(before) * before);
        ladder.rungs.push_back(std::move(rung));
    }
}

}  // namespace lanthorn::gi
