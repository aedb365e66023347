#include "tools/workbench/measure/light_contracts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "lanthorn/core/colour.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/transforms.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::workbench {

using reference::LightSplitter;
using reference::LitPoint;
using reference::Lux;

namespace {

bool is_less(double lux, const LightContract& asked) {
    return lux < static_cast<double>(asked.lower);
}
bool is_more(double lux, const LightContract& asked) {
    return asked.upper > 0 && lux > static_cast<double>(asked.upper);
}

std::string range_words(const LightContract& asked) {
    const std::string lower = lux_text(static_cast<double>(asked.lower));
    return asked.upper > 0 ? fmt::format("{} to {} lx", lower, lux_text(static_cast<double>(asked.upper)))
                           : fmt::format("{} lx or more", lower);
}

}  // namespace

PlacedContract placed_contract(const ecs::World& world, const FrameScene& frame, ecs::Entity e,
                               const LightContract& asked) {
    PlacedContract placed;
    const Name* name = world.try_get<Name>(e);
    placed.name = name != nullptr ? name->value : fmt::format("thing {}", e.index);
    placed.asked = asked;
    dmat4 to_render = world.get<WorldTransform>(e).matrix;
    to_render[3] -= dvec4(frame.origin, 0);
    if (const LightSensor* sensor = world.try_get<LightSensor>(e)) {
        placed.sensor = true;
        placed.position = vec3(to_render[3]);
        placed.direction = glm::normalize(vec3(-dvec3(to_render[2])));
        placed.radius = sensor->radius;
        placed.filter = sensor->filter;
    }
    for (int axis = 0; axis < 3; ++axis) {
        to_render[axis] *= static_cast<double>(asked.size[axis]);
    }
    placed.from_box = mat4(to_render);
    placed.to_box = mat4(glm::inverse(to_render));
    return placed;
}

std::vector<PlacedContract> contracts_of(const ecs::World& world, const FrameScene& frame) {
    std::vector<std::pair<ecs::Entity, PlacedContract>> found;
    world.query<ecs::Read<LightContract>, ecs::With<WorldTransform>>().each(
        [&](ecs::Entity e, const LightContract& asked) {
            found.emplace_back(e, placed_contract(world, frame, e, asked));
        });
    std::ranges::sort(found, {}, [](const auto& each) { return each.first.index; });
    std::vector<PlacedContract> result;
    for (auto& each : found) {
        result.push_back(std::move(each.second));
    }
    return result;
}

std::vector<LitPoint> places_of(const PlacedContract& contract, const LightSplitter& light, int places) {
    return contract.sensor
               ? light.points_on_disc(contract.position, contract.direction, contract.radius, places)
               : light.points_within(contract.to_box, places);
}

ContractVerdict check_contract(const PlacedContract& contract, const LightSplitter& light,
                               const ContractEffort& effort) {
    ContractVerdict verdict;
    verdict.contract = contract;
    const std::vector<LitPoint> points = places_of(contract, light, effort.places);
    verdict.places = static_cast<int>(points.size());
    if (points.empty()) {
        return verdict;
    }
    std::vector<double> lux;
    double variance = 0;
    for (const LitPoint& point : points) {
        const Lux here = light.light(point, effort.paths);
        lux.push_back(contract.sensor ? glm::dot(here.rgb, dvec3(contract.filter)) : here.value());
        variance += here.noise * here.noise;
    }
    const auto count = static_cast<double>(lux.size());
    verdict.mean = std::accumulate(lux.begin(), lux.end(), 0.0) / count;
    verdict.noise = std::sqrt(variance) / count;
    std::ranges::sort(lux);
    const auto at = [&](double share) { return lux[static_cast<std::size_t>(share * (count - 1) + 0.5)]; };
    verdict.low = at(0.05);
    verdict.median = at(0.5);
    verdict.high = at(0.95);
    if (contract.sensor) {
        lux = {verdict.mean};
    }
    const auto share = [&](auto&& is) {
        return static_cast<double>(std::ranges::count_if(lux, is)) / static_cast<double>(lux.size());
    };
    verdict.less = share([&](double each) { return is_less(each, contract.asked); });
    verdict.more = share([&](double each) { return is_more(each, contract.asked); });
    verdict.within = 1 - verdict.less - verdict.more;
    verdict.kept =
        contract.sensor ? verdict.within == 1 : verdict.within >= static_cast<double>(contract.asked.share);
    return verdict;
}

std::string contract_words(const ContractVerdict& v) {
    const PlacedContract& contract = v.contract;
    if (v.places == 0) {
        return fmt::format("{}: no surface is there, expected {}", contract.name,
                           range_words(contract.asked));
    }
    if (contract.sensor) {
        const double edge = static_cast<double>(
            v.less > 0 || contract.asked.upper == 0 ? contract.asked.lower : contract.asked.upper);
        return fmt::format("{}: reads {} +- {} lx, asked {}: {}{}", contract.name, lux_text(v.mean),
                           lux_text(v.noise), range_words(contract.asked), v.kept ? "kept" : "broken",
                           edge > 0 ? fmt::format(", margin {:+.0f} %", 100 * (v.mean / edge - 1)) : "");
    }
    std::string words = fmt::format(
        "{}: {} lx ({} to {}), asked {} on {:.0f} %: {:.0f} % {}", contract.name, lux_text(v.mean),
        lux_text(v.low), lux_text(v.high), range_words(contract.asked),
        100 * static_cast<double>(contract.asked.share), 100 * v.within, v.kept ? "kept" : "broken");
    if (!v.kept) {
        words += v.less >= v.more ? fmt::format(", {:.0f} % darker", 100 * v.less)
                                  : fmt::format(", {:.0f} % brighter", 100 * v.more);
    }
    return words;
}

nlohmann::ordered_json contract_json(const ContractVerdict& v) {
    return {{"name", v.contract.name},
            {"of", v.contract.sensor ? "sensor" : "box"},
            {"lower", v.contract.asked.lower},
            {"upper", v.contract.asked.upper},
            {"share", v.contract.asked.share},
            {"places", v.places},
            {"mean", v.mean},
            {"noise", v.noise},
            {"low", v.low},
            {"median", v.median},
            {"high", v.high},
            {"within", v.within},
            {"less", v.less},
            {"more", v.more},
            {"kept", v.kept},
            {"words", contract_words(v)}};
}

}  // namespace lanthorn::workbench
