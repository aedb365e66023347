#include "gi_module/techniques/emc/emc_ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "gi_module/shadow_rungs.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"

namespace lanthorn::gi {

namespace {

constexpr std::array kRays = {16, 12, 8, 6, 4, 3, 2, 1};
constexpr std::array kStrides = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16};  // pixels
constexpr std::array kTexels = {128, 96, 64, 48, 32};
constexpr std::array kPhotons = {8000, 4000, 2000, 1000, 500};
// The picture's pixels are spared before there are fewer points than this.
constexpr int kLeastPoints = 600;

// Shares of a frame's time at medium, 512x512, while a lamp moves, by group: round means over cornell,
// two-rooms, lantern-room and puppet (docs/budgets.md). What a rung will take is measured in each run.
constexpr std::array<double, kCostGroups> kShares = {0.33, 0.03, 0.10, 0.04, 0.17, 0.30, 0.03};

// What the square of the error is made of there: of noise, of the grid, of texels, of photons; the rest is of
// none of these.
struct ErrorShares {
    double noise, grid, texels, photons, rest;
};
constexpr ErrorShares kErrors = {0.25, 0.15, 0.15, 0.1, 0.35};
// Indirect light does not depend on the texels of lamps' maps, but edges of shadows do: what they count for
// beside these, where the order of rungs is chosen.
constexpr double kShadowEdges = 0.1;
struct Sizes {
    int rays, stride, texels, photons, shadows;
};
constexpr Sizes kMeasured = {4, 4, 64, 2000, 512};

double square(double x) {
    return x * x;
}

std::vector<double> cost_of(const Sizes& s) {
    const double points = 1 / square(s.stride);
    return {points * s.rays,   points, square(s.texels), static_cast<double>(s.photons), 1,
            square(s.shadows), 1};
}

double error_of(const Sizes& s) {
    const Sizes& m = kMeasured;
    const double rays = square(static_cast<double>(s.stride) / m.stride) * m.rays / s.rays;
    return std::sqrt(kErrors.noise * rays + kErrors.grid * square(static_cast<double>(s.stride) / m.stride) +
                     kErrors.texels * square(static_cast<double>(m.texels) / s.texels) +
                     kErrors.photons * m.photons / s.photons + kErrors.rest);
}

// What is seen of it: shadows' edges are wrong by their texels.
double harm_of(const Sizes& s) {
    return std::sqrt(square(error_of(s)) + kShadowEdges * kMeasured.shadows / s.shadows);
}

double time_of(const Sizes& s) {
    const std::vector<double> now = cost_of(s), measured = cost_of(kMeasured);
    double time = 0;
    for (std::size_t g = 0; g < kCostGroups; ++g) {
        time += kShares[g] * now[g] / measured[g];
    }
    return time;
}

// The next value below, or above where the values grow; none: `value` itself.
template <std::size_t N>
int next(const std::array<int, N>& values, int value, bool grows) {
    const auto found = std::ranges::find_if(values, [&](int v) { return grows ? v > value : v < value; });
    return found != values.end() ? *found : value;
}

struct Step {
    Sizes sizes;
    std::string name;
};

// What could be spared next.
std::vector<Step> steps_from(const Sizes& s, ivec2 size) {
    std::vector<Step> steps;
    const auto add = [&](const Sizes& to, int before, int after, std::string_view name) {
        if (after != before) {
            steps.push_back({to, fmt::format("{} {}", name, after)});
        }
    };
    Sizes to = s;
    to.rays = next(kRays, s.rays, false);
    if (to.rays > 1) {
        add(to, s.rays, to.rays, "rays");
    }
    to = s;
    to.stride = next(kStrides, s.stride, true);
    if (static_cast<double>(size.x) * size.y >= square(to.stride) * kLeastPoints) {
        add(to, s.stride, to.stride, "grid");
    }
    to = s;
    to.texels = next(kTexels, s.texels, false);
    add(to, s.texels, to.texels, "texels");
    to = s;
    to.photons = next(kPhotons, s.photons, false);
    add(to, s.photons, to.photons, "photons");
    to = s;
    to.shadows = fewer_shadow_texels(s.shadows, size.y);
    add(to, s.shadows, to.shadows, "shadows");
    return steps;
}

BudgetRung rung_of(const Sizes& s, const Sizes& top, std::string name, ivec2 size, bool photons,
                   const Settings& settings) {
    BudgetRung rung;
    rung.name = std::move(name);
    const double points = static_cast<double>(size.x) * size.y / square(s.stride);
    rung.set = {fmt::format("gi.gather.rays={}", s.rays), fmt::format("gi.gather.grid={}", s.stride),
                fmt::format("gi.gather.points={}", std::clamp(static_cast<int>(points), 1, 1'000'000)),
                fmt::format("gi.gather.texels={}", s.texels)};
    std::ranges::move(shadow_assignments(settings, s.shadows), std::back_inserter(rung.set));
    if (photons) {
        rung.set.push_back(fmt::format("gi.gather.photons={}", s.photons));
    }
    rung.cost = cost_of(s);
    const std::vector<double> first = cost_of(top);
    for (std::size_t g = 0; g < kCostGroups; ++g) {
        rung.cost[g] /= first[g];
    }
    rung.error = error_of(s) / error_of(top);
    return rung;
}

}  // namespace

BudgetLadder emc_ladder(const Settings& settings, ivec2 size) {
    const GiSettings gi = gi_settings(settings);
    const auto& e = gi.of<EmcSettings>();
    const Sizes top{e.gather_rays, gather_stride(gi, size), e.gather_texels, e.gather_photons,
                    settings.get<int>("render.shadow.resolution")};
    BudgetLadder ladder;
    const std::vector<double> measured = cost_of(kMeasured), first = cost_of(top);
    double sum = 0;
    ladder.shares.assign(kShares.begin(), kShares.end());
    for (std::size_t g = 0; g < kCostGroups; ++g) {
        sum += ladder.shares[g] *= first[g] / measured[g];
    }
    for (double& share : ladder.shares) {
        share /= sum;
    }
    ladder.rungs.front().cost.assign(kCostGroups, 1);
    if (e.final_stage != EmcFinal::gather) {
        return ladder;
    }
    const bool photons = e.gather_source == GatherSource::photons;
    for (Sizes now = top;;) {
        const std::vector<Step> steps = steps_from(now, size);
        if (steps.empty()) {
            return ladder;
        }
        const auto growth = [&](const Step& step) {
            return std::log(harm_of(step.sizes) / harm_of(now)) /
                   std::log(time_of(now) / time_of(step.sizes));
        };
        const auto best = std::ranges::min_element(steps, {}, growth);
        now = best->sizes;
        ladder.rungs.push_back(rung_of(now, top, best->name, size, photons, settings));
    }
}

}  // namespace lanthorn::gi
