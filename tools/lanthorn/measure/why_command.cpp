// lanthorn measure why SCENE --pixel X,Y: why that point of the picture is as bright as it is.
#include "tools/lanthorn/measure/why_command.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "gi_module/reference/light_split.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::tools {

namespace {

struct WhyOptions {
    std::string scene, size = "640x360", pixel, pose;
    int paths = 4096;
    SceneView view;
    SettingsChoice settings;
    bool json = false;
};

ivec2 pixel_of(const std::string& text, ivec2 size) {
    ivec2 pixel(-1);
    const char* end = text.data() + text.size();
    const auto [comma, problem] = std::from_chars(text.data(), end, pixel.x);
    if (problem == std::errc() && comma != end && *comma == ',') {
        const auto [rest, bad] = std::from_chars(comma + 1, end, pixel.y);
        pixel.y = bad == std::errc() && rest == end ? pixel.y : -1;
    }
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) {
        throw InputError(fmt::format("--pixel: found '{}', expected X,Y within {}x{}, rows from the top",
                                     text, size.x, size.y));
    }
    return pixel;
}

ExitCode run(const WhyOptions& options) {
    const ChosenSettings chosen(options.settings);
    const ivec2 size = parse_size("--size", options.size, 1, kLargestPicture);
    const ivec2 pixel = pixel_of(options.pixel, size);
    const StopSignal stop;
    SceneView view = options.view;
    SceneData scene = tell_warnings(options.scene, load_scene(options.scene, view));
    if (!options.pose.empty()) {
        view.camera = add_pose_camera(scene, pose_of(options.pose));
    }
    ShownScene shown(std::move(scene), view);
    shown.show_at(view.time.value_or(0));
    const FrameScene& frame = shown.frame();
    const reference::LightSplitter splitter(frame, reference::path_settings(chosen.settings));
    const std::optional<reference::LitPoint> point = splitter.seen(frame.camera, size, pixel);
    if (!point) {
        throw InputError(options.scene, fmt::format("pixel {},{}", pixel.x, pixel.y),
                         "found no surface, expected one that is seen there");
    }
    const reference::LightSplit split = splitter.split(*point, options.paths);
    const EntityNaming name = naming_of(shown.world());
    if (!options.json) {
        fmt::print("{} at {},{}\n", name(point->entity), pixel.x, pixel.y);
        for (const std::string& line : why_lines(split, name)) {
            fmt::print("{}\n", line);
        }
        return ExitCode::ok;
    }
    const dvec3 at = frame.origin + dvec3(point->position);
    nlohmann::ordered_json root{{"measure", "why"},
                                {"scene", options.scene},
                                {"pixel", {pixel.x, pixel.y}},
                                {"size", {size.x, size.y}},
                                {"surface", name(point->entity)},
                                {"at", {at.x, at.y, at.z}},
                                {"normal", {point->normal.x, point->normal.y, point->normal.z}}};
    root.update(why_json(split, frame.origin, name));
    fmt::print("{}\n", root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return ExitCode::ok;
}

}  // namespace

Command add_measure_why(CLI::App& measure) {
    auto options = std::make_shared<WhyOptions>();
    CLI::App* command = measure.add_subcommand(
        "why",
        "Why a point of the picture is as bright as it is: its light by lamp, by number of reflections and "
        "by the "
        "surface that it comes from last, what hides which lamp and what it would give, the strongest ways.");
    add_scene_option(*command, options->scene)->required();
    command->add_option("--pixel", options->pixel, "X,Y of the picture, rows from the top")->required();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--pose", options->pose, "X,Y,Z,YAW,PITCH[,FOV] instead of a camera, as of render");
    command->add_option("--paths", options->paths, "paths that are followed")
        ->check(CLI::Range(16, 10'000'000))
        ->capture_default_str();
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "that is looked at, standing still (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
