#include "tools/lanthorn/common/common_options.h"

#include <fmt/format.h>

#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/workbench/all_settings.h"

namespace lanthorn::tools {

namespace {

const SettingsSchema& with_all_settings(SettingsSchema& schema) {
    declare_all_settings(schema);
    return schema;
}

}  // namespace

CLI::Option* add_scene_option(CLI::App& command, std::string& scene) {
    return command.add_option("SCENE", scene, "glTF 2.0 file (.gltf, .glb)");
}

void add_file_options(CLI::App& command, std::string& variant, bool& allow_outside) {
    command.add_option("--variant", variant, "of KHR_materials_variants, the one to show");
    command.add_flag("--allow-outside", allow_outside,
                     "let the file name buffers and images outside of its own folder");
}

CLI::Validator number_between(double low, double high) {
    const auto check = [low, high](const std::string& text) {
        double value = 0;
        const bool is_inside = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return is_inside ? std::string()
                         : fmt::format("found '{}', expected a number from {} to {}", text, low, high);
    };
    return CLI::Validator(check, fmt::format("NUMBER in [{} - {}]", low, high));
}

void add_camera_option(CLI::App& command, std::string& camera) {
    command.add_option("--camera", camera,
                       "a camera node's name or a camera's number (default: the first); auto: one that sees "
                       "everything");
}

void add_moment_options(CLI::App& command, SceneView& view, const std::string& of_time) {
    command.add_option("--animation", view.animation,
                       "an animation's name or number, or none; default: the first");
    command.add_option("--time", view.time, "seconds of the animation, looped, " + of_time)
        ->check(number_between(0, 1e6));
    command.add_flag(
        "!--no-default-light", view.default_light,
        "refuse a scene without any light instead of adding a clear day's, or in a room one over "
        "the camera's shoulder; and add no sky to a sun that has none");
    command.add_option(
        "--environment", view.environment,
        "an equirectangular image (.hdr, .exr, .tx, ...) around the scene: its sky and its light");
    command.add_option("--environment-intensity", view.environment_intensity, "nits of 1 in that image (1)")
        ->check(number_between(0, 1e6));
    add_file_options(command, view.variant, view.allow_outside);
    view.declare = game::declare_components;
}

void SettingsChoice::apply_to(Settings& settings) const {
    if (!preset.empty()) {
        settings.apply_preset(preset);
    }
    if (!file.empty()) {
        settings.load_file(file);
    }
    for (const std::string& assignment : set) {
        settings.set_from_text(assignment);
    }
}

void add_settings_options(CLI::App& command, SettingsChoice& choice) {
    command.add_option("--preset", choice.preset,
                       "low, medium, high or ultra; paper: the technique as it was published");
    command.add_option("--settings", choice.file, "JSON file of settings: {\"KEY\": VALUE}");
    command.add_option("--set", choice.set, "KEY=VALUE, repeatable: any setting of render --list-settings")
        ->allow_extra_args(false);
}

ChosenSettings::ChosenSettings(const SettingsChoice& choice) : settings(with_all_settings(schema)) {
    choice.apply_to(settings);
}

std::vector<std::string> view_arguments(const SceneView& view, double default_time) {
    std::vector<std::string> arguments = {"--time", fmt::format("{}", view.time.value_or(default_time))};
    if (!view.camera.empty()) {
        arguments.insert(arguments.end(), {"--camera", view.camera});
    }
    if (!view.animation.empty()) {
        arguments.insert(arguments.end(), {"--animation", view.animation});
    }
    if (!view.default_light) {
        arguments.emplace_back("--no-default-light");
    }
    if (!view.variant.empty()) {
        arguments.insert(arguments.end(), {"--variant", view.variant});
    }
    if (view.box) {
        arguments.push_back("--box=" + text_of(*view.box));
    }
    if (view.allow_outside) {
        arguments.emplace_back("--allow-outside");
    }
    if (!view.environment.empty()) {
        arguments.insert(arguments.end(), {"--environment", view.environment, "--environment-intensity",
                                           fmt::format("{}", view.environment_intensity)});
    }
    return arguments;
}

}  // namespace lanthorn::tools
