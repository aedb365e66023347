// Which points a sweep has.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "lanthorn/core/error.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/workbench/trade_point.h"

namespace lanthorn::workbench {

namespace {

const gi::TechniqueEntry& entry_of(const std::string& technique) {
    const gi::TechniqueEntry* entry = gi::find_technique(technique);
    if (entry == nullptr) {
        throw InputError(fmt::format("--technique: found '{}', expected one of {}", technique,
                                     fmt::join(gi::technique_names(), ", ")));
    }
    return *entry;
}

bool has_presets(const std::string& technique) {
    return entry_of(technique).has_presets;
}

// A technique reads its own settings: the reference none of the map and splat settings, `none` no indirect
// light's.
bool reads(const std::string& technique, const std::string& setting) {
    const gi::TechniqueEntry& entry = entry_of(technique);
    return (!entry.is_reference && setting.starts_with("render.")) ||
           std::ranges::any_of(entry.reads,
                               [&](const std::string& beginning) { return setting.starts_with(beginning); });
}

// Settings that one final stage alone reads are turned with that stage, whatever the preset has.
void take_its_stage(TradePoint& point, const SettingsSchema& schema) {
    const auto turns = [&](std::initializer_list<const char*> prefixes) {
        return std::ranges::any_of(point.assignments, [&](const std::string& assignment) {
            return std::ranges::any_of(prefixes,
                                       [&](const char* prefix) { return assignment.starts_with(prefix); });
        });
    };
    const bool splats = turns({"gi.emc.splat.", "gi.photons", "gi.emc.steps"});
    const bool gathers = turns({"gi.gather.", "gi.emc.rays"});
    if (turns({"gi.emc.final"}) || splats == gathers) {
        return;
    }
    const gi::EmcFinal stage = splats ? gi::EmcFinal::splat : gi::EmcFinal::gather;
    if (gi::gi_settings(point.settings(schema)).of<gi::EmcSettings>().final_stage != stage) {
        point.assignments.insert(point.assignments.begin(),
                                 fmt::format("gi.emc.final={}", splats ? "splat" : "gather"));
    }
}

// Of one technique: each costs a second at least.
constexpr std::size_t kMostCombinations = 10'000;

void check_count(const std::vector<Knob>& knobs, const std::string& technique) {
    double count = 1;
    for (const Knob& knob : knobs) {
        count *= static_cast<double>(knob.values.size());
    }
    if (count > static_cast<double>(kMostCombinations)) {
        throw InputError(
            fmt::format("--product: found {:.3g} combinations of the knobs of '{}', expected at most {}: "
                        "choose with --knob",
                        count, technique, kMostCombinations));
    }
}

// One value a knob, in every combination: the last knob turns fastest.
std::vector<std::vector<std::string>> combinations(const std::vector<Knob>& knobs) {
    std::vector<std::vector<std::string>> all = {{}};
    for (const Knob& knob : knobs) {
        std::vector<std::vector<std::string>> longer;
        for (const auto& start : all) {
            for (const std::string& value : knob.values) {
                longer.push_back(start);
                longer.back().push_back(knob.name + '=' + value);
            }
        }
        all = std::move(longer);
    }
    return all;
}

std::vector<std::vector<std::string>> turns(const Sweep& sweep, const std::string& technique) {
    if (sweep.presets_only) {
        return {};
    }
    std::vector<Knob> knobs = sweep.knobs.empty() ? entry_of(technique).turns : sweep.knobs;
    std::erase_if(knobs, [&](const Knob& knob) { return !reads(technique, knob.name); });
    if (knobs.empty()) {
        return {};
    }
    if (sweep.product) {
        check_count(knobs, technique);
        return combinations(knobs);
    }
    std::vector<std::vector<std::string>> list;
    for (const Knob& knob : knobs) {
        std::ranges::copy(combinations({knob}), std::back_inserter(list));
    }
    return list;
}

}  // namespace

Knob parse_knob(const std::string& text, const SettingsSchema& schema) {
    const auto refuse = [&](const std::string& problem) {
        throw InputError(fmt::format("--knob {}: {}, expected KEY=VALUE,VALUE,...", text, problem));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        refuse("found no '='");
    }
    Knob knob{text.substr(0, equals), {}};
    Settings probe(schema);
    for (std::size_t start = equals + 1; start < text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        knob.values.push_back(text.substr(start, end - start));
        probe.set_from_text(knob.name, knob.values.back());
        start = end + 1;
    }
    if (knob.values.empty()) {
        refuse("found no value");
    }
    return knob;
}

TradePoint papers_own_way(TradePoint start) {
    start.name = "the paper's own way";
    start.assignments = {"gi.emc.search=secant", "gi.emc.threshold=0.001", "gi.emc.exhaustive=true",
                         "gi.emc.final=splat"};
    return start;
}

TradePoint other_final_stage(TradePoint preset, const SettingsSchema& schema) {
    const bool gathers =
        gi::gi_settings(preset.settings(schema)).of<gi::EmcSettings>().final_stage == gi::EmcFinal::gather;
    preset.stage = gathers ? "splat" : "gather";
    preset.name = preset.preset + ", " + preset.stage;
    preset.assignments = {"gi.emc.final=" + preset.stage};
    return preset;
}

std::vector<TradePoint> sweep_points(const Sweep& sweep, const SettingsSchema& schema) {
    std::vector<TradePoint> points;
    std::set<std::string> seen;
    const auto add = [&](TradePoint point) {
        const std::string settings = point.settings(schema).to_json();
        if (seen.insert(point.panel() + '\n' + point.technique + '\n' + settings).second) {
            points.push_back(std::move(point));
        }
    };
    const auto add_points = [&](const TradePoint& start) {
        const std::string& technique = start.technique;
        if (has_presets(technique)) {
            for (const std::string& preset : sweep.presets) {
                TradePoint point = start;
                point.preset = preset;
                add(point);
                if (technique == "emc" && !sweep.own_stage) {
                    add(other_final_stage(point, schema));
                }
            }
            if (technique == "emc" && !sweep.presets.empty() && !sweep.own_stage) {
                add(papers_own_way(start));
            }
        } else if (technique == "none") {
            add(start);
        }
        for (auto& assignments : turns(sweep, technique)) {
            TradePoint point = start;
            point.assignments = std::move(assignments);
            if (technique == "emc") {
                take_its_stage(point, schema);
            }
            add(point);
        }
    };
    for (const std::string& scene : sweep.scenes) {
        for (const TradeMotion motion : sweep.motions) {
            for (const std::string& technique : sweep.techniques) {
                TradePoint start{scene, technique, sweep.around, sweep.common, {}};
                start.motion = motion;
                add_points(start);
            }
        }
    }
    if (points.empty()) {
        throw InputError("trade: the sweep is empty, expected a preset or a --knob that a technique reads");
    }
    return points;
}

}  // namespace lanthorn::workbench
