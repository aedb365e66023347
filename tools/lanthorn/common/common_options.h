// Options that several commands have, said once.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// SCENE.
CLI::Option* add_scene_option(CLI::App& command, std::string& scene);

// --variant and --allow-outside.
void add_file_options(CLI::App& command, std::string& variant, bool& allow_outside);
// A number from `low` to `high`; CLI::Range takes what is none, too.
CLI::Validator number_between(double low, double high);

void add_camera_option(CLI::App& command, std::string& camera);
// --animation, --time, --no-default-light, --environment, and add_file_options. `of_time` ends the help of
// --time: what it is for, its default.
void add_moment_options(CLI::App& command, SceneView& view, const std::string& of_time);

// The options of a command that shows what `view` does; its time is given always.
std::vector<std::string> view_arguments(const SceneView& view, double default_time);

// What --preset, --settings and --set ask for.
struct SettingsChoice {
    std::string preset, file;
    std::vector<std::string> set;  // KEY=VALUE

    // Later wins: the preset, the file, each assignment. Throws InputError for one that is not right.
    void apply_to(Settings& settings) const;
};
void add_settings_options(CLI::App& command, SettingsChoice& choice);

// Every setting, as the command line asks.
struct ChosenSettings {
    // Throws InputError as SettingsChoice::apply_to().
    explicit ChosenSettings(const SettingsChoice& choice);
    ChosenSettings(const ChosenSettings&) = delete;
    ChosenSettings& operator=(const ChosenSettings&) = delete;

    SettingsSchema schema;  // that `settings` live by
    Settings settings;
};

}  // namespace lanthorn::tools
