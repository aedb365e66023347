// lanthorn measure photons SCENE: how many photons `vertex-map` has time for.
#include "tools/lanthorn/measure/photons_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/core/json.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/measure/photon_choice.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/median.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct PhotonsOptions {
    std::string scene, size = "512x512";
    double frame_ms = 10;
    int frames = 9;
    SceneView view;
    SettingsChoice settings;
    bool json = false;
};

// What is measured to fit the costs.
constexpr std::pair<int, int> kMeasured[] = {{2000, 100}, {8000, 1600}, {32'000, 400}};

// The scene in an App, whose lamps change by their last bit from frame to frame, so that photons are shot in
// each of them.
class Flickering {
  public:
    Flickering(SceneData scene, const SceneView& view, const Settings& settings, ivec2 size)
        : shown_(std::move(scene), view), lamps_(shown_.world()), settings_(settings) {
        shown_.show_at(view.time.value_or(0));
        shown_.hold();
        for (const auto& sources : {punctual_lights(shown_.world()), emissive_meshes(shown_.world())}) {
            std::ranges::for_each(sources, [&](ecs::Entity source) { lamps_.add(source); });
        }
        gi::add_picture_plugins(shown_.app(), settings_);
        shown_.app().view().size = size;
    }
    // Medians over `frames`, after the first one, which shoots all photons and finds areas.
    PhotonFrame measure(int total, int per_frame, int frames) {
        settings_.set<int>("gi.vertex-map.total", total);
        settings_.set<int>("gi.vertex-map.per_frame", per_frame);
        gi::apply_settings(shown_.app(), settings_);
        std::vector<double> shoot, balance, estimate;
        for (int i = 0; i <= frames; ++i) {
            lamps_.dim(i % 2 == 0 ? 1.0f : std::nextafter(1.0f, 2.0f));
            shown_.app().show();
            stop_if_asked("measure", "nothing was found yet");
            const gi::ActiveTechnique& active = shown_.world().resource<gi::ActiveTechnique>();
            const auto counts = parse_json(
                gi::technique_entry(active.kind).statistics_json(active.technique->statistics(false)),
                "statistics");
            if (i == 0) {
                continue;
            }
            shoot.push_back(counts.at("shoot_ms"));
            balance.push_back(counts.at("balance_ms"));
            estimate.push_back(counts.at("estimate_ms"));
        }
        return {total, per_frame, median(shoot), median(balance), median(estimate)};
    }

  private:
    ShownScene shown_;
    DimmedLights lamps_;
    Settings settings_;
};

nlohmann::ordered_json in_json(const PhotonFrame& f) {
    return {{"total", f.total},        {"per_frame", f.per_frame},  {"shoot_ms", f.shoot},
            {"balance_ms", f.balance}, {"estimate_ms", f.estimate}, {"whole_ms", f.whole()}};
}

void add_row(TextTable& table, const char* what, const PhotonFrame& f) {
    table.add({what, fmt::format("{}", f.total), fmt::format("{}", f.per_frame),
               fmt::format("{:.2f}", f.shoot), fmt::format("{:.2f}", f.balance),
               fmt::format("{:.2f}", f.estimate), fmt::format("{:.2f}", f.whole())});
}

ExitCode run(const PhotonsOptions& options) {
    ChosenSettings asked(options.settings);
    asked.settings.set_from_text("gi.technique", "vertex-map");
    asked.settings.set_from_text("gi.vertex-map.tree",
                                 "rebuilt");  // the thesis's, whose cost goes with all photons
    const ivec2 size = parse_size("--size", options.size, 1, kLargestPicture);
    const StopSignal stop;
    SceneData scene = tell_warnings(options.scene, load_scene(options.scene, options.view));
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    Flickering flickering(std::move(scene), options.view, asked.settings, size);
    Progress progress("runs", std::size(kMeasured) + 1);
    std::vector<PhotonFrame> measured;
    const auto measure = [&](int total, int per_frame) {
        const PhotonFrame frame = flickering.measure(total, per_frame, options.frames);
        progress.update(measured.size() + 1);
        return frame;
    };
    for (const auto& [total, per_frame] : kMeasured) {
        measured.push_back(measure(total, per_frame));
    }
    const PhotonFrame chosen = choose_photons(PhotonCosts(measured), options.frame_ms);
    const PhotonFrame found = measure(chosen.total, chosen.per_frame);
    const int lag = (chosen.total + chosen.per_frame - 1) / chosen.per_frame;
    if (options.json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        std::ranges::for_each(measured, [&](const PhotonFrame& f) { list.push_back(in_json(f)); });
        const nlohmann::ordered_json root{{"measure", "photons"},         {"scene", options.scene},
                                          {"frame_ms", options.frame_ms}, {"measured", std::move(list)},
                                          {"chosen", in_json(chosen)},    {"found", in_json(found)},
                                          {"frames_until_new", lag}};
        fmt::print("{}\n", root.dump(2));
        return ExitCode::ok;
    }
    TextTable table({"frame", "total", "per_frame", "shooting ms", "balancing ms", "estimates ms", "all ms"});
    std::ranges::for_each(measured, [&](const PhotonFrame& f) { add_row(table, "measured", f); });
    add_row(table, "chosen: expected", chosen);
    add_row(table, "chosen: measured", found);
    fmt::print(
        "{}\nIn a frame of {:g} ms, shooting as long as balancing: light follows what changes in {} frames.\n"
        "--set gi.vertex-map.total={} --set gi.vertex-map.per_frame={}\n",
        table.text(), options.frame_ms, lag, chosen.total, chosen.per_frame);
    return ExitCode::ok;
}

}  // namespace

Command add_measure_photons(CLI::App& measure) {
    auto options = std::make_shared<PhotonsOptions>();
    CLI::App* command = measure.add_subcommand(
        "photons",
        "How many photons vertex-map has time for: gi.vertex-map.total and per_frame for a frame of so many "
        "milliseconds, so that shooting takes as long as balancing (Jozwowski 2002, Table 1), the tree being "
        "rebuilt.");
    add_scene_option(*command, options->scene)->required();
    command
        ->add_option("--frame-ms", options->frame_ms, "milliseconds of a frame's photons, tree and estimates")
        ->check(number_between(1e-3, 1e6))
        ->capture_default_str();
    command->add_option("--frames", options->frames, "frames measured at a time")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "that is measured, standing still (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
