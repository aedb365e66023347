#include "lanthorn/core/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

[[noreturn]] void refuse(const SettingInfo& info, std::string_view found) {
    throw InputError(fmt::format("{}: found '{}', expected {}", info.name, found, info.expectation()));
}

// `number` if it is a value that `info` allows.
double checked(const SettingInfo& info, double number, std::string_view found) {
    const bool whole = info.type == SettingType::real || number == std::floor(number);
    if (!std::isfinite(number) || !whole || !info.in_range(number)) {
        refuse(info, found);
    }
    return number;
}

double choice_index(const SettingInfo& info, std::string_view text) {
    const auto found = std::find(info.choices.begin(), info.choices.end(), text);
    if (found == info.choices.end()) {
        refuse(info, text);
    }
    return static_cast<double>(found - info.choices.begin());
}

double parse(const SettingInfo& info, std::string_view text) {
    if (info.type == SettingType::boolean) {
        for (const std::string_view yes : {"true", "on", "yes", "1"}) {
            if (text == yes) {
                return 1;
            }
        }
        for (const std::string_view no : {"false", "off", "no", "0"}) {
            if (text == no) {
                return 0;
            }
        }
        refuse(info, text);
    }
    if (info.type == SettingType::choice) {
        return choice_index(info, text);
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) {
        refuse(info, text);
    }
    return checked(info, number, text);
}

double parse(const SettingInfo& info, const nlohmann::json& value) {
    const std::string found = value.is_string() ? value.get<std::string>() : value.dump();
    switch (info.type) {
        case SettingType::boolean:
            return value.is_boolean() ? value.get<bool>() : (refuse(info, found), 0);
        case SettingType::choice:
            return value.is_string() ? choice_index(info, found) : (refuse(info, found), 0);
        default:
            return value.is_number() ? checked(info, value.get<double>(), found) : (refuse(info, found), 0);
    }
}

}  // namespace

std::vector<std::string> preset_names() {
    std::vector<std::string> names(kPresetNames.begin(), kPresetNames.end());
    names.emplace_back(kPaperPreset);
    return names;
}

Settings::Settings(const SettingsSchema& schema) : schema_(&schema) {
    schema.check();
    for (const SettingInfo& info : schema.all()) {
        values_.push_back(info.initial);
    }
}

double Settings::value(std::string_view name, SettingType type) const {
    const SettingInfo* info = schema_->find(name);
    if (info == nullptr || info->type != type) {
        throw std::logic_error(
            fmt::format("setting '{}' is read as what it was not declared: {}", name,
                        info == nullptr ? "it is not declared at all" : info->type_name()));
    }
    return values_[schema_->index(*info)];
}

std::string Settings::text(std::string_view name) const {
    const SettingInfo& info = schema_->find_or_throw(name);
    return info.value_text(values_[schema_->index(info)]);
}

void Settings::store(const SettingInfo& info, double number) {
    double& place = values_[schema_->index(info)];
    if (place != number) {
        place = number;
        ++revision_;
    }
}

void Settings::set_number(std::string_view name, SettingType type, double number) {
    const SettingInfo& info = schema_->find_or_throw(name);
    if (info.type != type) {
        throw std::logic_error(
            fmt::format("setting '{}' is set as what it was not declared: {}", name, info.type_name()));
    }
    store(info, checked(info, number, fmt::format("{}", number)));
}

void Settings::set_from_text(std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw InputError(fmt::format("found '{}', expected NAME=VALUE", assignment));
    }
    set_from_text(assignment.substr(0, equals), assignment.substr(equals + 1));
}

void Settings::set_from_text(std::string_view name, std::string_view value) {
    const SettingInfo& info = schema_->find_or_throw(name);
    store(info, parse(info, value));
}

void Settings::apply_preset(std::string_view preset) {
    const auto found = std::find(kPresetNames.begin(), kPresetNames.end(), preset);
    if (found == kPresetNames.end() && preset != kPaperPreset) {
        throw InputError(
            fmt::format("unknown preset '{}', expected one of {}", preset, fmt::join(preset_names(), ", ")));
    }
    if (preset == kPaperPreset) {
        for (const SettingInfo& info : schema_->all()) {
            if (info.published || info.preset) {
                store(info, info.published.value_or(info.initial));
            }
        }
        return;
    }
    for (const SettingInfo& info : schema_->all()) {
        if (info.preset) {
            store(info, (*info.preset)[static_cast<std::size_t>(found - kPresetNames.begin())]);
        }
    }
}

void Settings::load_file(const std::filesystem::path& path) {
    std::ifstream file;
    if (!std::filesystem::is_directory(path)) {
        file.open(path, std::ios::binary);
    }
    if (!file.is_open()) {
        throw InputError(path.string(), "", "cannot be read, expected a JSON file of settings");
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    load_json(text, path.string());
}

void Settings::load_json(std::string_view json, std::string_view source) {
    const nlohmann::json root = parse_json_object(json, source, "settings");
    Settings changed = *this;
    for (const auto& [name, value] : root.items()) {
        try {
            const SettingInfo& info = schema_->find_or_throw(name);
            changed.store(info, parse(info, value));
        } catch (const InputError& error) {
            throw InputError(source, "", error.what());
        }
    }
    *this = std::move(changed);
}

void Settings::reset(std::string_view name) {
    const SettingInfo& info = schema_->find_or_throw(name);
    store(info, info.initial);
}

bool Settings::is_default(std::string_view name) const {
    const SettingInfo& info = schema_->find_or_throw(name);
    return values_[schema_->index(info)] == info.initial;
}

std::string Settings::to_json() const {
    nlohmann::ordered_json root = nlohmann::ordered_json::object();
    for (const SettingInfo& info : schema_->all()) {
        const double number = values_[schema_->index(info)];
        if (number == info.initial) {
            continue;
        }
        switch (info.type) {
            case SettingType::boolean:
                root[info.name] = number != 0;
                break;
            case SettingType::integer:
                root[info.name] = static_cast<long long>(number);
                break;
            case SettingType::real:
                root[info.name] = number;
                break;
            case SettingType::choice:
                root[info.name] = info.value_text(number);
                break;
        }
    }
    return root.dump(2) + '\n';
}

}  // namespace lanthorn
