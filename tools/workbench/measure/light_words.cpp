#include "tools/workbench/measure/light_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::workbench {

using reference::HiddenPart;
using reference::LampPart;
using reference::LightKind;
using reference::LightSource;
using reference::LightSplit;
using reference::Lux;
using reference::Straight;

namespace {

constexpr double kWorthSaying = 0.002;             // share of the sum
constexpr int kMostHidden = 5, kMostSurfaces = 6;  // lines, names in a line

double whole(const LightSplit& split) {
    return split.direct.value() + split.reflected.value() + split.sky.value();
}

std::string joined(const std::vector<std::uint32_t>& entities, const EntityNaming& name,
                   const char* between) {
    std::string words;
    for (const std::uint32_t entity : entities) {
        words += (words.empty() ? "" : between) + name(entity);
    }
    return words;
}

std::string share_text(double part, double sum) {
    return fmt::format("{:.0f} %", sum > 0 ? 100 * part / sum : 0);
}

nlohmann::ordered_json json_of(const Lux& lux) {
    return {{"lux", lux.value()}, {"noise", lux.noise}, {"rgb", {lux.rgb.x, lux.rgb.y, lux.rgb.z}}};
}

}  // namespace

EntityNaming naming_of(const ecs::World& world) {
    auto names = std::make_shared<std::unordered_map<std::uint32_t, std::string>>();
    world.query<ecs::Read<Name>>().each(
        [&](ecs::Entity e, const Name& name) { (*names)[e.index] = name.value; });
    return [names](std::uint32_t entity) {
        const auto found = names->find(entity);
        return found != names->end() ? found->second : fmt::format("thing {}", entity);
    };
}

std::string lux_text(double lux) {
    if (!(std::abs(lux) >= 1e-6)) {
        return "0";
    }
    const int digits = std::max(0, 2 - static_cast<int>(std::floor(std::log10(std::abs(lux)))));
    return fmt::format("{:.{}f}", lux, digits);
}

std::string lamp_name(const LightSource& source, std::uint32_t entity, const EntityNaming& name) {
    return source.kind == LightKind::sky ? "sky" : name(entity);
}

std::string hidden_words(const HiddenPart& hidden, const EntityNaming& name) {
    std::string words = fmt::format(
        "{} hidden by {}: +{} lx if {} were not there", lamp_name(hidden.source, hidden.entity, name),
        joined(hidden.occluders, name, " and "), lux_text(hidden.direct.value() + hidden.reflected.value()),
        hidden.occluders.size() == 1 ? "it" : "they");
    const char* least = hidden.whole ? "" : " at least";
    if (hidden.direct.value() > 0 &&
        std::abs(hidden.reflected.value()) > kWorthSaying * hidden.direct.value()) {
        words += fmt::format(" ({} straight, {} reflected{})", lux_text(hidden.direct.value()),
                             lux_text(hidden.reflected.value()), least);
    } else if (!(hidden.direct.value() > 0)) {
        words += fmt::format(" (reflected{})", least);
    }
    return words;
}

std::string_view straight_words(Straight straight) {
    switch (straight) {
        case Straight::lit:
            return "";
        case Straight::hidden:
            return "hidden";
        case Straight::behind:
            return "behind the surface";
        case Straight::out_of_range:
            return "out of its range";
        case Straight::out_of_cone:
            return "out of its cone";
        case Straight::no_light:
            break;
    }
    return "nothing straight";
}

std::vector<std::string> why_lines(const LightSplit& split, const EntityNaming& name) {
    const double sum = whole(split);
    const double noise = std::hypot(split.direct.noise, split.reflected.noise, split.sky.noise);
    std::vector<std::string> lines{fmt::format(
        "{} lx +- {}: direct {}, reflected {}, sky {}", lux_text(sum), lux_text(noise),
        lux_text(split.direct.value()), lux_text(split.reflected.value()), lux_text(split.sky.value()))};
    for (const LampPart& lamp : split.lamps) {
        const bool punctual = lamp.source.kind == LightKind::punctual;
        if (!punctual && lamp.sum.value() < kWorthSaying * sum) {
            continue;
        }
        std::string line = fmt::format("  {:<20} {:>8} lx {:>5}: direct {}",
                                       lamp_name(lamp.source, lamp.entity, name), lux_text(lamp.sum.value()),
                                       share_text(lamp.sum.value(), sum), lux_text(lamp.direct.value()));
        if (punctual && lamp.straight != Straight::lit) {
            line += fmt::format(" ({})", straight_words(lamp.straight));
        }
        for (std::size_t n = 0; n < lamp.reflected.size(); ++n) {
            line += fmt::format(", {} reflection{} {}", n + 1, n == 0 ? "" : "s",
                                lux_text(lamp.reflected[n].value()));
        }
        lines.push_back(std::move(line));
    }
    std::string from;
    int count = 0;
    for (const auto& surface : split.surfaces) {
        const double lux = surface.reflected.value();
        if (lux >= 0.01 * split.reflected.value() && lux > 0 && ++count <= kMostSurfaces) {
            from += fmt::format("{}{} {}", from.empty() ? "  reflected by " : ", ", name(surface.entity),
                                share_text(lux, split.reflected.value()));
        }
    }
    if (!from.empty()) {
        lines.push_back(std::move(from));
    }
    count = 0;
    for (const HiddenPart& hidden : split.hidden) {
        if (hidden.direct.value() + hidden.reflected.value() >= 0.01 * sum && ++count <= kMostHidden) {
            lines.push_back("  " + hidden_words(hidden, name));
        }
    }
    for (const auto& way : split.ways) {
        std::string words;
        for (const std::uint32_t entity : way.entities) {
            words = name(entity) + (words.empty() ? "" : " > ") + words;
        }
        lines.push_back(fmt::format("  way {:>8} lx: {} > {} > here", lux_text(way.lux),
                                    lamp_name(way.source, way.entity, name), words));
    }
    return lines;
}

nlohmann::ordered_json why_json(const LightSplit& split, const dvec3& origin, const EntityNaming& name) {
    using Json = nlohmann::ordered_json;
    Json root{{"paths", split.paths},
              {"lux", whole(split)},
              {"direct", json_of(split.direct)},
              {"reflected", json_of(split.reflected)},
              {"sky", json_of(split.sky)},
              {"indirect", json_of(split.indirect())}};
    const auto names_of_all = [&](const std::vector<std::uint32_t>& entities) {
        Json list = Json::array();
        for (const std::uint32_t entity : entities) {
            list.push_back(name(entity));
        }
        return list;
    };
    Json lamps = Json::array(), surfaces = Json::array(), hidden = Json::array(), ways = Json::array();
    for (const LampPart& lamp : split.lamps) {
        Json reflected = Json::array();
        for (const Lux& lux : lamp.reflected) {
            reflected.push_back(json_of(lux));
        }
        lamps.push_back({{"lamp", lamp_name(lamp.source, lamp.entity, name)},
                         {"sum", json_of(lamp.sum)},
                         {"direct", json_of(lamp.direct)},
                         {"why", lamp.straight == Straight::lit ? "lit" : straight_words(lamp.straight)},
                         {"reflected", std::move(reflected)}});
    }
    for (const auto& surface : split.surfaces) {
        surfaces.push_back({{"surface", name(surface.entity)}, {"reflected", json_of(surface.reflected)}});
    }
    for (const HiddenPart& part : split.hidden) {
        hidden.push_back({{"lamp", lamp_name(part.source, part.entity, name)},
                          {"by", names_of_all(part.occluders)},
                          {"direct", json_of(part.direct)},
                          {"reflected", json_of(part.reflected)},
                          {"whole", part.whole}});
    }
    for (const auto& way : split.ways) {
        Json places = Json::array();
        for (const vec3& place : way.places) {
            const dvec3 world = origin + dvec3(place);
            places.push_back({world.x, world.y, world.z});
        }
        ways.push_back({{"lamp", lamp_name(way.source, way.entity, name)},
                        {"surfaces", names_of_all(way.entities)},
                        {"lux", way.lux},
                        {"places", std::move(places)}});
    }
    root["lamps"] = std::move(lamps);
    root["surfaces"] = std::move(surfaces);
    root["hidden"] = std::move(hidden);
    root["ways"] = std::move(ways);
    return root;
}

}  // namespace lanthorn::workbench
