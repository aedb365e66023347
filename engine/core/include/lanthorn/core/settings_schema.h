// What settings there are: each is declared once, with its type, unit, range, default, presets, cost and
// meaning. The command line, presets, settings files and the editor are all made from these declarations.
//
//   void declare_emc_settings(SettingsSchema& schema) {
//       schema.declare<int>("gi.emc.count")
//           .unit("maps").range(1, 64).initially(8).presets({4, 8, 8, 16})
//           .cost("linear in ms and MB").docs("environment maps that light is traced against");
//       schema.declare<Search>("gi.emc.search")          // enum class Search { march, secant };
//           .choices({"march", "secant"}).initially(Search::march)
//           .cost("secant is 2x faster, loses a quarter of the photons").docs("how a ray is met with a map");
//   }
#pragma once

#include <cassert>
#include <deque>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lanthorn/core/value_info.h"

namespace lanthorn {

// What values a setting takes: true or false, whole numbers, numbers, or one of some names.
enum class SettingType { boolean, integer, real, choice };

// One declared setting. Values of every type are held as a double: a boolean as 0 or 1, a choice as its
// index.
struct SettingInfo : ValueInfo {  // its name: lower-case words joined by dots, "gi.emc.count"
    SettingType type = SettingType::real;
    double initial = 0;
    bool for_measuring = false;  // no picture needs it: listed behind all others

    std::string type_name() const;               // "bool", "int", "float", "enum"
    std::string range_text() const;              // "1..64", "march|secant", "true|false"
    std::string value_text(double value) const;  // as it is written in --set
    // "an integer from 1 to 64 maps": for messages.
    std::string expectation() const;
};

// The type a setting is read as: bool, int, float, or an enum class whose values are 0, 1, 2, ...
template <typename T>
concept SettingValue =
    std::is_same_v<T, bool> || std::is_same_v<T, int> || std::is_same_v<T, float> || std::is_enum_v<T>;

// The SettingType that a T is declared and read as.
template <SettingValue T>
constexpr SettingType setting_type() {
    if constexpr (std::is_same_v<T, bool>) {
        return SettingType::boolean;
    } else if constexpr (std::is_same_v<T, int>) {
        return SettingType::integer;
    } else if constexpr (std::is_same_v<T, float>) {
        return SettingType::real;
    } else {
        return SettingType::choice;
    }
}

// A float as the double with the same shortest decimal, so that 0.1f is listed as 0.1.
double setting_number(float value);
// The number that SettingInfo holds the value as.
template <SettingValue T>
double setting_number(T value) {
    return static_cast<double>(value);
}

// Fills in a declaration. Valid until the schema is destroyed.
template <SettingValue T>
class SettingDeclaration {
  public:
    explicit SettingDeclaration(SettingInfo& info) : info_(info) {}

    // "m", "rad"; without: a plain number.
    SettingDeclaration& unit(std::string text) { return set(info_.unit, std::move(text)); }
    // What a larger value costs.
    SettingDeclaration& cost(std::string text) { return set(info_.cost, std::move(text)); }
    // One or two sentences for people.
    SettingDeclaration& docs(std::string text) { return set(info_.words, std::move(text)); }
    // The default; without: 0.
    SettingDeclaration& initially(T value) { return set(info_.initial, setting_number(value)); }
    // Both ends are allowed values.
    SettingDeclaration& range(T lower, T upper) requires(std::is_same_v<T, int> || std::is_same_v<T, float>) {
        set(info_.lower, setting_number(lower));
        return set(info_.upper, setting_number(upper));
    }
    // The names of the enumeration's values 0, 1, 2, ...
    SettingDeclaration& choices(std::vector<std::string> names) requires std::is_enum_v<T> {
        set(info_.upper, static_cast<double>(names.size()) - 1);
        return set(info_.choices, std::move(names));
    }
    // Exactly four values: low, medium, high, ultra.
    SettingDeclaration& presets(std::initializer_list<T> values) {
        assert(values.size() == kPresetNames.size());
        info_.preset.emplace();
        auto out = info_.preset->begin();
        for (const T value : values) {
            *out++ = setting_number(value);
        }
        return *this;
    }
    // It makes work that measurements compare with: nothing that a user of pictures turns.
    SettingDeclaration& for_measuring() { return set(info_.for_measuring, true); }
    // What the paper of its technique has: the value of kPaperPreset.
    SettingDeclaration& as_published(T value) {
        info_.published = setting_number(value);
        return *this;
    }

  private:
    template <typename V>
    SettingDeclaration& set(V& field, V value) {
        field = std::move(value);
        return *this;
    }
    SettingInfo& info_;
};

class SettingsSchema {
  public:
    SettingsSchema() = default;
    SettingsSchema(const SettingsSchema&) = delete;  // Settings point at it
    SettingsSchema& operator=(const SettingsSchema&) = delete;

    // Throws std::logic_error if the name is malformed or declared already.
    template <SettingValue T>
    SettingDeclaration<T> declare(const std::string& name) {
        return SettingDeclaration<T>(add(name, setting_type<T>()));
    }

    // nullptr if there is none of that name. O(log n).
    const SettingInfo* find(std::string_view name) const;
    // The same, but throws InputError naming the nearest declared name.
    const SettingInfo& find_or_throw(std::string_view name) const;

    const std::deque<SettingInfo>& all() const { return settings_; }  // in order of declaration
    // Its place in all(). `info` must be of this schema. O(log n).
    std::size_t index(const SettingInfo& info) const;

    // Throws std::logic_error for a declaration whose default or preset lies outside its range, or that lacks
    // choices.
    void check() const;

    // In order of declaration; the tables have those for measuring in a group of their own at the end.
    std::string list_text() const;      // a table for people, with a trailing newline
    std::string list_json() const;      // an array with an object a setting, indented
    std::string list_markdown() const;  // for docs/settings.md

  private:
    SettingInfo& add(const std::string& name, SettingType type);

    std::deque<SettingInfo> settings_;
    std::map<std::string, std::size_t, std::less<>> by_name_;
};

}  // namespace lanthorn
