// lanthorn measure hits|coverage|flicker|energy SCENE: what an image cannot tell of the indirect light.
#include <fmt/format.h>

#include <memory>

#include "engine/assets/gltf_import.h"
#include "engine/core/progress.h"
#include "gi_module/gi_settings.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/image_size.h"
#include "tools/lanthorn/measure_report.h"
#include "tools/lanthorn/plan_report.h"

namespace lanthorn::tools {

namespace {

struct Options {
    MeasureInput input;
    FlickerJob flicker;
    std::string size = "256x256", motion = "light";
    int points = 20000;
    bool json = false;
};

void configure(Settings& settings, const MeasureInput& input) {
    if (!input.preset.empty()) {
        settings.apply_preset(input.preset);
    }
    for (const std::string& assignment : input.set) {
        settings.set_from_text(assignment);
    }
}

std::uint64_t flight_count(const PhotonFlights& flights) {
    std::uint64_t count = 0;
    for (const auto& bounce : flights.bounces) {
        count += bounce.size();
    }
    return count;
}

// Settings, scene and photons of a measurement, as its options ask.
PhotonFlights flights_of(const Options& options, Settings& settings) {
    configure(settings, options.input);
    return trace_photons(import_gltf(options.input.scene), settings);
}

MeasureReport run_hits(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("tracing exact rays", flight_count(flights));
    return report(measure_hits(flights, [&](std::uint64_t done) { progress.update(done); }));
}

MeasureReport run_coverage(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("asking points", static_cast<std::uint64_t>(options.points));
    const CoverageFigures figures = measure_coverage(flights, options.points, gi::gi_settings(settings).seed,
                                                     [&](std::uint64_t done) { progress.update(done); });
    if (figures.reached == 0) {
        throw InputError(options.input.scene, "",
                         "found no surface that reflected light reaches, expected some");
    }
    return report(figures);
}

MeasureReport run_energy(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("tracing exact rays", flight_count(flights));
    return report(measure_energy(flights, [&](std::uint64_t done) { progress.update(done); }));
}

MeasureReport run_flicker(const Options& options, Settings& settings) {
    MeasureInput input = options.input;
    input.size = parse_size(options.size);
    FlickerJob job = options.flicker;
    job.motion = options.motion == "pan" ? FlickerMotion::pan : FlickerMotion::light;
    configure(settings, input);
    Progress progress("rendering", static_cast<std::uint64_t>(job.warmup + job.frames + 1));
    MeasureReport result = report(measure_flicker(import_gltf(input.scene), settings, input, job,
                                                  [&](std::uint64_t done) { progress.update(done); }));
    result.figures["technique"] = gi::technique_name(gi::gi_settings(settings).technique);
    result.figures["motion"] = options.motion;
    result.figures["step"] = job.step;
    result.figures["frames"] = job.frames;
    return result;
}

struct Measure {
    const char* name;
    const char* about;
    MeasureReport (*run)(const Options&, Settings&);
};
constexpr Measure kMeasures[] = {
    {"hits", "Share of photon segments whose image-space hit lies within 2 % of the diagonal of Embree's.",
     run_hits},
    {"coverage", "Area share of what reflected light reaches that a selected map sees, by Embree.",
     run_coverage},
    {"flicker", "Change from frame to frame of indirect light in a slow motion, over the reference's own.",
     run_flicker},
    {"energy", "Where the lights' flux goes: stored, absorbed, lost, by bounce.", run_energy}};

ExitCode run(const Measure& measure, const Options& options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    const MeasureReport result = measure.run(options, settings);
    if (!options.json) {
        fmt::print("{}", result.table);
        return ExitCode::ok;
    }
    const MeasureInput& input = options.input;
    nlohmann::ordered_json root{
        {"measure", measure.name}, {"scene", input.scene}, {"preset", nullptr}, {"set", input.set}};
    if (!input.preset.empty()) {
        root["preset"] = input.preset;
    }
    root.update(result.figures);
    fmt::print("{}\n", root.dump(2));
    return ExitCode::ok;
}

void add_common(CLI::App& command, Options& options) {
    command.add_option("SCENE", options.input.scene, "glTF 2.0 file (.gltf, .glb)")->required();
    command.add_option("--preset", options.input.preset, "low, medium, high or ultra");
    command
        .add_option("--set", options.input.set,
                    "KEY=VALUE, repeatable: any setting of render --list-settings")
        ->allow_extra_args(false);
    command.add_flag("--json", options.json, "print one JSON object");
}

void add_coverage_options(CLI::App& command, Options& options) {
    command.add_option("--points", options.points, "points asked, spread evenly over all surfaces")
        ->check(CLI::Range(1, 100000000))
        ->capture_default_str();
}

void add_flicker_options(CLI::App& command, Options& options) {
    FlickerJob& job = options.flicker;
    command.add_option("--motion", options.motion, "light or pan")
        ->check(CLI::IsMember({"light", "pan"}))
        ->capture_default_str();
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command.add_option(
        "--camera", options.input.camera,
        "a camera node's name or a camera's number (default: the first); auto: one that sees everything");
    command.add_option("--frames", job.frames, "changes from frame to frame to measure")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.add_option("--warmup", job.warmup, "frames of the motion before")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.add_option("--step", job.step, "motion a frame: share of the scene's diagonal; radians of turns")
        ->check(CLI::Range(1e-6, 1.0))
        ->capture_default_str();
    command.add_option("--spp", job.spp, "samples a pixel of the reference, in each frame")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
}

}  // namespace

Command add_measure(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("measure", "What an image cannot tell of a scene's indirect light.");
    for (const Measure& measure : kMeasures) {
        add_common(*command->add_subcommand(measure.name, measure.about), *options);
    }
    add_coverage_options(*command->get_subcommand("coverage"), *options);
    add_flicker_options(*command->get_subcommand("flicker"), *options);
    return [options, command] {
        for (const Measure& measure : kMeasures) {
            if (command->got_subcommand(measure.name)) {
                return run(measure, *options);
            }
        }
        throw InputError("measure: found no measure, expected hits, coverage, flicker or energy");
    };
}

}  // namespace lanthorn::tools
