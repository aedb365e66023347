#include "lanthorn/core/settings_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

constexpr const char* kForMeasuring = "For measuring alone; no picture needs them:";

bool well_formed(std::string_view name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    char before = '.';
    for (const char c : name) {
        if (!(allowed(c) || (c == '.' && before != '.'))) {
            return false;
        }
        before = c;
    }
    return before != '.';
}

}  // namespace

double setting_number(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double result = value;  // kept for infinities and NaN, which from_chars would read as well
    std::from_chars(text, end, result);
    return result;
}

std::string SettingInfo::type_name() const {
    switch (type) {
        case SettingType::boolean:
            return "bool";
        case SettingType::integer:
            return "int";
        case SettingType::real:
            return "float";
        case SettingType::choice:
            return "enum";
    }
    return {};
}

std::string SettingInfo::value_text(double value) const {
    switch (type) {
        case SettingType::boolean:
            return value != 0 ? "true" : "false";
        case SettingType::choice:
            return choices.at(static_cast<std::size_t>(value));
        default:
            return fmt::format("{}", value);
    }
}

std::string SettingInfo::range_text() const {
    switch (type) {
        case SettingType::boolean:
            return "true|false";
        case SettingType::choice:
            return fmt::format("{}", fmt::join(choices, "|"));
        default:
            return has_range() ? value_text(lower) + ".." + value_text(upper) : "any";
    }
}

std::string SettingInfo::expectation() const {
    switch (type) {
        case SettingType::boolean:
            return "true or false";
        case SettingType::choice:
            return one_of();
        default:
            break;
    }
    return described(type == SettingType::integer ? "an integer" : "a number");
}

SettingInfo& SettingsSchema::add(const std::string& name, SettingType type) {
    if (!well_formed(name)) {
        throw std::logic_error(
            fmt::format("setting '{}': a name is lower-case words joined by single dots", name));
    }
    if (!by_name_.emplace(name, settings_.size()).second) {
        throw std::logic_error(fmt::format("setting '{}' is declared twice", name));
    }
    SettingInfo& info = settings_.emplace_back();
    info.name = name;
    info.type = type;
    if (type == SettingType::boolean) {
        info.lower = 0;
        info.upper = 1;
    } else if (type == SettingType::integer) {
        info.lower = std::numeric_limits<int>::min();
        info.upper = std::numeric_limits<int>::max();
    } else if (type == SettingType::choice) {
        info.lower = 0;
    }
    return info;
}

const SettingInfo* SettingsSchema::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &settings_[found->second];
}

const SettingInfo& SettingsSchema::find_or_throw(std::string_view name) const {
    if (const SettingInfo* info = find(name)) {
        return *info;
    }
    std::string line = fmt::format("unknown setting '{}'", name);
    const auto nearest =
        std::min_element(settings_.begin(), settings_.end(), [&](const SettingInfo& a, const SettingInfo& b) {
            return edit_distance(name, a.name) < edit_distance(name, b.name);
        });
    if (nearest != settings_.end() &&
        edit_distance(name, nearest->name) <= std::max<std::size_t>(3, nearest->name.size() / 3)) {
        line += fmt::format(", did you mean '{}'?", nearest->name);
    } else {
        line += ", expected one that 'lanthorn render --list-settings' shows";
    }
    throw InputError(line);
}

std::size_t SettingsSchema::index(const SettingInfo& info) const {
    return by_name_.find(info.name)->second;
}

void SettingsSchema::check() const {
    for (const SettingInfo& info : settings_) {
        if (info.type == SettingType::choice && info.choices.empty()) {
            throw std::logic_error(fmt::format("setting '{}' has no choices", info.name));
        }
        std::vector<double> values = {info.initial};
        if (info.preset) {
            values.insert(values.end(), info.preset->begin(), info.preset->end());
        }
        if (info.published) {
            values.push_back(*info.published);
        }
        for (const double value : values) {
            if (!(value >= info.lower && value <= info.upper)) {
                throw std::logic_error(
                    fmt::format("setting '{}': default or preset {} is not {}", info.name, value,
                                info.type == SettingType::choice ? "a choice" : info.expectation()));
            }
        }
    }
}

// "6, 8, 8, 12; paper 10".
static std::string presets_text(const SettingInfo& info) {
    std::vector<std::string> values;
    for (std::size_t i = 0; info.preset && i < info.preset->size(); ++i) {
        values.push_back(info.value_text((*info.preset)[i]));
    }
    std::string text = fmt::format("{}", fmt::join(values, ", "));
    if (info.published) {
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : "; ", kPaperPreset, info.value_text(*info.published));
    }
    return text;
}

// In order of declaration.
static std::vector<const SettingInfo*> group_of(const std::deque<SettingInfo>& settings, bool for_measuring) {
    std::vector<const SettingInfo*> group;
    for (const SettingInfo& info : settings) {
        if (info.for_measuring == for_measuring) {
            group.push_back(&info);
        }
    }
    return group;
}

std::string SettingsSchema::list_text() const {
    const std::vector<const SettingInfo*> measuring = group_of(settings_, true);
    std::vector<const SettingInfo*> listed = group_of(settings_, false);
    const std::size_t pictures = listed.size();
    listed.insert(listed.end(), measuring.begin(), measuring.end());
    std::vector<std::array<std::string, 6>> rows = {
        {"NAME", "TYPE", "RANGE", "UNIT", "DEFAULT", "PRESETS (low, medium, high, ultra; paper)"}};
    for (const SettingInfo* info : listed) {
        const std::string presets = presets_text(*info);
        rows.push_back({info->name, info->type_name(), info->range_text(),
                        info->unit.empty() ? "-" : info->unit, info->value_text(info->initial),
                        presets.empty() ? "-" : presets});
    }
    std::array<std::size_t, 6> width{};
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            width[i] = std::max(width[i], row[i].size());
        }
    }
    std::string out;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (r == pictures + 1) {
            out += fmt::format("\n{}\n", kForMeasuring);
        }
        for (std::size_t i = 0; i < rows[r].size(); ++i) {
            out += i + 1 < rows[r].size() ? fmt::format("{:<{}}  ", rows[r][i], width[i]) : rows[r][i];
        }
        out += '\n';
        if (r > 0) {
            const SettingInfo& info = *listed[r - 1];
            if (!info.words.empty()) {
                out += fmt::format("    {}\n", info.words);
            }
            if (!info.cost.empty()) {
                out += fmt::format("    cost: {}\n", info.cost);
            }
        }
    }
    return out;
}

std::string SettingsSchema::list_json() const {
    using nlohmann::ordered_json;
    ordered_json list = ordered_json::array();
    for (const SettingInfo& info : settings_) {
        const auto value = [&](double number) -> ordered_json {
            switch (info.type) {
                case SettingType::boolean:
                    return number != 0;
                case SettingType::integer:
                    return static_cast<long long>(number);
                case SettingType::real:
                    return number;
                case SettingType::choice:
                    return info.value_text(number);
            }
            return nullptr;
        };
        ordered_json out = {{"name", info.name},
                            {"type", info.type_name()},
                            {"unit", info.unit},
                            {"default", value(info.initial)}};
        if (info.type == SettingType::choice) {
            out["choices"] = info.choices;
        } else if (info.type != SettingType::boolean && info.has_range()) {
            out["range"] = {value(info.lower), value(info.upper)};
        }
        if (info.preset) {
            for (std::size_t i = 0; i < kPresetNames.size(); ++i) {
                out["presets"][std::string(kPresetNames[i])] = value((*info.preset)[i]);
            }
        }
        if (info.published) {
            out["presets"][std::string(kPaperPreset)] = value(*info.published);
        }
        out["cost"] = info.cost;
        out["docs"] = info.words;
        list.push_back(std::move(out));
    }
    return list.dump(2) + '\n';
}

std::string SettingsSchema::list_markdown() const {
    std::string out;
    const auto add = [&](const std::vector<const SettingInfo*>& group) {
        out += "| setting | value | default | presets | what |\n|---|---|---|---|---|\n";
        for (const SettingInfo* info : group) {
            std::string what = info->words;
            if (!info->cost.empty()) {
                what += (what.empty() ? "Cost: " : " Cost: ") + info->cost + ".";
            }
            out += fmt::format("| `{}` | {} | {} | {} | {} |\n", info->name, table_cell(info->expectation()),
                               table_cell(info->value_text(info->initial)), presets_text(*info),
                               table_cell(what));
        }
    };
    add(group_of(settings_, false));
    if (const std::vector<const SettingInfo*> measuring = group_of(settings_, true); !measuring.empty()) {
        out += fmt::format("\n{}\n\n", kForMeasuring);
        add(measuring);
    }
    return out;
}

}  // namespace lanthorn
