// The values of the settings that a schema declares.
//
//   SettingsSchema schema;
//   declare_render_settings(schema);
//   declare_gi_settings(schema);
//   Settings settings(schema);                        // all at their defaults
//   settings.apply_preset("high");                    // then a file, then single settings
//   settings.load_file("quality.json");               // {"gi.emc.count": 12}
//   settings.set_from_text("gi.emc.search=secant");
//   int maps = settings.get<int>("gi.emc.count");
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/core/settings_schema.h"

namespace lanthorn {

// low, medium, high, ultra, paper.
std::vector<std::string> preset_names();

class Settings {
  public:
    // `schema` must outlive this and gain no declarations any more. Throws std::logic_error if
    // SettingsSchema::check does.
    explicit Settings(const SettingsSchema& schema);

    const SettingsSchema& schema() const { return *schema_; }  // that this was made with

    // Reading. An undeclared name or another type is a mistake in the program: std::logic_error. O(log n).
    template <SettingValue T>
    T get(std::string_view name) const {
        return static_cast<T>(value(name, setting_type<T>()));
    }
    // As written in --set. Throws InputError for an undeclared name.
    std::string text(std::string_view name) const;

    // Writing. Everything below throws InputError for what a user can mend (an unknown name, with the nearest
    // known one; a wrong type; out of range; not a number) and then leaves all values as they were.
    template <SettingValue T>
    void set(std::string_view name, T new_value) {
        set_number(name, setting_type<T>(), setting_number(new_value));
    }
    void set_from_text(std::string_view assignment);  // "NAME=VALUE"
    // `value` as it stands behind the = of --set.
    void set_from_text(std::string_view name, std::string_view value);
    // One of preset_names(); settings without presets stay.
    void apply_preset(std::string_view preset);
    void load_file(const std::filesystem::path& path);               // JSON: {"NAME": VALUE, ...}
    void load_json(std::string_view json, std::string_view source);  // `source`: for messages
    // To its default. Throws InputError for an unknown name.
    void reset(std::string_view name);

    // Whether the value is the default's, whoever set it. Throws InputError for an unknown name.
    bool is_default(std::string_view name) const;
    // What differs from the defaults, as load_file reads it; indented JSON with a trailing newline.
    std::string to_json() const;

    // Grows with every change of a value: compare to notice changes.
    std::uint64_t revision() const { return revision_; }

  private:
    double value(std::string_view name, SettingType type) const;
    void set_number(std::string_view name, SettingType type, double number);
    void store(const SettingInfo& info, double number);

    const SettingsSchema* schema_;
    std::vector<double> values_;
    std::uint64_t revision_ = 0;
};

}  // namespace lanthorn
