#include "game/presentation/preferences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings_schema.h"

namespace lanthorn::game {

namespace {

using nlohmann::json;

struct Number {
    const char* name;
    double Preferences::*value;
    double lowest, highest;
};
struct Switch {
    const char* name;
    bool Preferences::*value;
};
constexpr std::array kNumbers = {Number{"field_of_view", &Preferences::field_of_view, 50, 90},
                                 Number{"brightness", &Preferences::brightness, -1, 1},
                                 Number{"mouse", &Preferences::mouse, 0.2, 4},
                                 Number{"stick", &Preferences::stick, 0.2, 4},
                                 Number{"dead_zone", &Preferences::dead_zone, 0, 0.5},
                                 Number{"text_size", &Preferences::text_size, 0.75, 2},
                                 Number{"effects", &Preferences::effects, 0, 1},
                                 Number{"music", &Preferences::music, 0, 1}};
constexpr std::array kSwitches = {Switch{"fullscreen", &Preferences::fullscreen},
                                  Switch{"invert_look", &Preferences::invert_look},
                                  Switch{"hold_by_press", &Preferences::hold_by_press},
                                  Switch{"captions", &Preferences::captions},
                                  Switch{"symbols", &Preferences::symbols},
                                  Switch{"less_motion", &Preferences::less_motion},
                                  Switch{"flicker", &Preferences::flicker},
                                  Switch{"rim", &Preferences::rim}};
constexpr double kLongestFrame = 1000;  // milliseconds
constexpr int kLeastPixels = 16, kMostPixels = 8192;

// The members of the file, each asked for by name; what does not fit is refused with the name.
class Reader {
  public:
    Reader(std::string_view text, std::string_view source)
        : source_(source), all_(parse_json_object(text, source, "options, as JSON")) {}

    // Null where there is none.
    const json* find(const char* name) const {
        const auto found = all_.find(name);
        return found == all_.end() ? nullptr : &*found;
    }
    void expect(bool holds, const char* name, const char* what) const {
        if (!holds) {
            throw InputError(source_, name, std::string("expected ") + what);
        }
    }

    std::optional<double> number(const char* name, double lowest, double highest) const {
        const json* value = find(name);
        if (value == nullptr) {
            return std::nullopt;
        }
        const double number = value->is_number() ? value->get<double>() : std::nan("");
        expect(number >= lowest && number <= highest, name, "a number in its range");
        return number;
    }

  private:
    std::string_view source_;
    json all_;
};

bool is_size(const json& value) {
    const auto fits = [](const json& pixels) {
        return pixels.is_number_unsigned() && pixels.get<std::uint64_t>() >= kLeastPixels &&
               pixels.get<std::uint64_t>() <= kMostPixels;
    };
    return value.is_array() && value.size() == 2 && fits(value[0]) && fits(value[1]);
}

}  // namespace

std::string to_json(const Preferences& preferences) {
    nlohmann::ordered_json out;
    out["version"] = kPreferencesVersion;
    if (preferences.picture != ivec2(0)) {
        out["picture"] = {preferences.picture.x, preferences.picture.y};
    }
    if (!preferences.preset.empty()) {
        out["preset"] = preferences.preset;
    }
    if (preferences.frame_budget) {
        out["frame_budget"] = *preferences.frame_budget;
    }
    if (!preferences.language.empty()) {
        out["language"] = preferences.language;
    }
    for (const Switch& each : kSwitches) {
        out[each.name] = preferences.*each.value;
    }
    for (const Number& each : kNumbers) {
        out[each.name] = preferences.*each.value;
    }
    return out.dump(2) + "\n";
}

Preferences preferences_from_json(std::string_view text, std::string_view source) {
    const Reader reader(text, source);
    const json* version = reader.find("version");
    reader.expect(version != nullptr && version->is_number_integer() && *version == kPreferencesVersion,
                  "version", "1");
    Preferences preferences;
    if (const json* picture = reader.find("picture")) {
        reader.expect(is_size(*picture), "picture", "[width, height], 16..8192 pixels each");
        preferences.picture = {(*picture)[0].get<int>(), (*picture)[1].get<int>()};
    }
    if (const json* preset = reader.find("preset")) {
        reader.expect(
            preset->is_string() && std::ranges::count(kPresetNames, preset->get<std::string>()) == 1,
            "preset", "low, medium, high or ultra");
        preferences.preset = preset->get<std::string>();
    }
    if (const json* language = reader.find("language")) {
        reader.expect(language->is_string(), "language", "a text");
        preferences.language = language->get<std::string>();
    }
    for (const Switch& each : kSwitches) {
        if (const json* value = reader.find(each.name)) {
            reader.expect(value->is_boolean(), each.name, "true or false");
            preferences.*each.value = value->get<bool>();
        }
    }
    preferences.frame_budget = reader.number("frame_budget", 0, kLongestFrame);
    for (const Number& each : kNumbers) {
        const std::optional<double> number = reader.number(each.name, each.lowest, each.highest);
        preferences.*each.value = number.value_or(preferences.*each.value);
    }
    return preferences;
}

Preferences read_preferences(shell::KeptFile& file) {
    return file.read_as(preferences_from_json);
}

}  // namespace lanthorn::game
