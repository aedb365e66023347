// lanthorn measure hits|coverage|flicker|energy SCENE: what an image cannot tell of the indirect light.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/assets/gltf_import.h"
#include "engine/core/progress.h"
#include "gi_module/gi_settings.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/image_size.h"
#include "tools/lanthorn/measure_coverage.h"
#include "tools/lanthorn/measure_energy.h"
#include "tools/lanthorn/measure_flicker.h"
#include "tools/lanthorn/measure_hits.h"
#include "tools/lanthorn/plan_report.h"
#include "tools/lanthorn/text_table.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

struct Options {
    MeasureInput input;
    FlickerJob flicker;
    std::string size = "256x256", motion = "light";
    int points = 20000;
    bool json = false;
};

// JSON has neither NaN nor infinity.
ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json colours(const dvec3& v) {
    return {v.r, v.g, v.b};
}

std::string percent(double share) {
    return fmt::format("{:.2f} %", 100 * share);
}

void configure(Settings& settings, const MeasureInput& input) {
    if (!input.preset.empty()) {
        settings.apply_preset(input.preset);
    }
    for (const std::string& assignment : input.set) {
        settings.set_from_text(assignment);
    }
}

// What was measured: the head of every report.
ordered_json head_json(const char* measure, const MeasureInput& input) {
    return {{"measure", measure},
            {"scene", input.scene},
            {"preset", input.preset.empty() ? ordered_json(nullptr) : ordered_json(input.preset)},
            {"set", input.set}};
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

ordered_json json_of(const HitCounts& c) {
    ordered_json before = ordered_json::array(), behind = ordered_json::array();
    for (std::size_t i = 0; i < c.before.size(); ++i) {
        before.push_back(c.before[i]);
        behind.push_back(c.behind[i]);
    }
    return {{"segments", c.segments}, {"agreement", c.share(c.agree)}, {"near", c.share(c.near)},
            {"far", c.share(c.far)},  {"missed", c.share(c.missed)},   {"invented", c.share(c.invented)},
            {"left", c.left},         {"before", std::move(before)},   {"behind", std::move(behind)}};
}

void print_hits(const std::vector<HitCounts>& bounces, const HitCounts& all) {
    TextTable table({"bounce", "segments", "agreement", "near", "far", "missed", "invented", "left"});
    const auto add = [&](const std::string& name, const HitCounts& c) {
        table.add({name, fmt::format("{}", c.segments), percent(c.share(c.agree)), percent(c.share(c.near)),
                   percent(c.share(c.far)), percent(c.share(c.missed)), percent(c.share(c.invented)),
                   fmt::format("{}", c.left)});
    };
    for (std::size_t b = 0; b < bounces.size(); ++b) {
        add(fmt::format("{}", b + 1), bounces[b]);
    }
    add("all", all);
    fmt::print("{}\n", table.text());
    TextTable histogram({"off by, of the diagonal", "too near", "too far"});
    double from = 0;
    for (std::size_t i = 0; i < all.before.size(); ++i) {
        const bool last = i == kHitBins.size();
        histogram.add({last ? fmt::format("above {:g} %", 100 * from)
                            : fmt::format("{:g} to {:g} %", 100 * from, 100 * kHitBins[i]),
                       percent(all.share(all.before[i])), percent(all.share(all.behind[i]))});
        from = last ? from : kHitBins[i];
    }
    histogram.add({"missed: by exact ray alone", percent(all.share(all.missed)), ""});
    histogram.add({"invented: by image alone", percent(all.share(all.invented)), ""});
    fmt::print("{}", histogram.text());
}

ExitCode run_hits(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    std::vector<HitCounts> bounces;
    {
        Progress progress("tracing exact rays", flight_count(flights));
        bounces = measure_hits(flights, [&](std::uint64_t done) { progress.update(done); });
    }
    HitCounts all;
    for (const HitCounts& counts : bounces) {
        all += counts;
    }
    if (!options.json) {
        print_hits(bounces, all);
        return ExitCode::ok;
    }
    ordered_json root = head_json("hits", options.input);
    root["photons"] = flights.statistics.photons.emitted;
    root["tolerance"] = kHitTolerance;
    root["bins"] = kHitBins;
    root.update(json_of(all));
    root["bounces"] = ordered_json::array();
    for (const HitCounts& counts : bounces) {
        root["bounces"].push_back(json_of(counts));
    }
    fmt::print("{}\n", root.dump(2));
    return ExitCode::ok;
}

void print_coverage(const CoverageFigures& f) {
    TextTable table({"coverage", "standard error", "by eq. 1", "reached m2", "of m2", "points"});
    table.add({percent(f.coverage), percent(f.standard_error), percent(f.by_eq1),
               fmt::format("{:.4g}", f.reached_area), fmt::format("{:.4g}", f.area),
               fmt::format("{} of {}", f.reached, f.points)});
    fmt::print("{}\n", table.text());
    TextTable maps({"map", "sees", "alone"});
    for (std::size_t m = 0; m < f.seen_by_map.size(); ++m) {
        maps.add({fmt::format("{}", m), percent(f.seen_by_map[m]), percent(f.alone_by_map[m])});
    }
    fmt::print("{}", maps.text());
}

ExitCode run_coverage(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    CoverageFigures f;
    {
        Progress progress("asking points", static_cast<std::uint64_t>(options.points));
        f = measure_coverage(flights, options.points, gi::gi_settings(settings).seed,
                             [&](std::uint64_t done) { progress.update(done); });
    }
    if (f.reached == 0) {
        throw InputError(options.input.scene, "",
                         "found no surface that reflected light reaches, expected some");
    }
    if (!options.json) {
        print_coverage(f);
        return ExitCode::ok;
    }
    ordered_json root = head_json("coverage", options.input);
    root["coverage"] = f.coverage;
    root["standard_error"] = f.standard_error;
    root["coverage_by_eq1"] = f.by_eq1;
    root["area_m2"] = f.area;
    root["reached_m2"] = f.reached_area;
    root["points"] = f.points;
    root["points_reached"] = f.reached;
    root["maps"] = ordered_json::array();
    for (std::size_t m = 0; m < f.seen_by_map.size(); ++m) {
        root["maps"].push_back({{"sees", f.seen_by_map[m]}, {"alone", f.alone_by_map[m]}});
    }
    fmt::print("{}\n", root.dump(2));
    return ExitCode::ok;
}

void print_energy(const EnergyBalance& balance) {
    const double emitted = luminous(balance.first.incoming);
    const auto share = [&](const dvec3& flux) { return percent(luminous(flux) / emitted); };
    fmt::print("emitted {:.4g} lm; shares of it, by luminance:\n", emitted);
    TextTable table(
        {"step", "comes in", "stored", "lost", "of it truly", "absorbed", "reflected", "stored/exact"});
    const EnergyStep& first = balance.first;
    table.add({"first surface", share(first.incoming), share(first.stored), share(first.lost), "-",
               share(first.absorbed), share(first.reflected), "-"});
    for (std::size_t b = 0; b < balance.bounces.size(); ++b) {
        const EnergyStep& s = balance.bounces[b];
        table.add({fmt::format("bounce {}", b + 1), share(s.incoming), share(s.stored), share(s.lost),
                   share(s.lost_true), share(s.absorbed), share(s.reflected),
                   fmt::format("{:.4f}", luminous(s.stored) / luminous(s.stored_exact))});
    }
    fmt::print("{}", table.text());
}

ordered_json json_of(const EnergyStep& s) {
    return {{"incoming", colours(s.incoming)},
            {"stored", colours(s.stored)},
            {"lost", colours(s.lost)},
            {"absorbed", colours(s.absorbed)},
            {"reflected", colours(s.reflected)}};
}

ExitCode run_energy(const Options& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    EnergyBalance balance;
    {
        Progress progress("tracing exact rays", flight_count(flights));
        balance = measure_energy(flights, [&](std::uint64_t done) { progress.update(done); });
    }
    if (!options.json) {
        print_energy(balance);
        return ExitCode::ok;
    }
    ordered_json root = head_json("energy", options.input);
    root["unit"] = "lm";
    root["emitted"] = colours(balance.first.incoming);
    root["first_surface"] = json_of(balance.first);
    root["bounces"] = ordered_json::array();
    for (const EnergyStep& s : balance.bounces) {
        ordered_json step = json_of(s);
        step["lost_true"] = colours(s.lost_true);
        step["stored_exact"] = colours(s.stored_exact);
        root["bounces"].push_back(std::move(step));
    }
    fmt::print("{}\n", root.dump(2));
    return ExitCode::ok;
}

ExitCode run_flicker(const Options& options, Settings& settings) {
    MeasureInput input = options.input;
    input.size = parse_size(options.size);
    FlickerJob job = options.flicker;
    job.motion = options.motion == "pan" ? FlickerMotion::pan : FlickerMotion::light;
    configure(settings, input);
    FlickerFigures f;
    {
        Progress progress("rendering", static_cast<std::uint64_t>(job.warmup + job.frames + 1));
        f = measure_flicker(import_gltf(input.scene), settings, input, job,
                            [&](std::uint64_t done) { progress.update(done); });
    }
    if (options.json) {
        ordered_json root = head_json("flicker", options.input);
        root["technique"] = gi::technique_name(gi::gi_settings(settings).technique);
        root["motion"] = options.motion;
        root["step"] = options.flicker.step;
        root["frames"] = options.flicker.frames;
        root["flicker"] = number(f.ratio);
        root["change"] = f.change;
        root["reference_change"] = number(f.reference_change);
        root["reference_error"] = number(f.reference_error);
        root["reference_mean"] = f.reference_mean;
        root["by_frame"] = f.by_frame;
        fmt::print("{}\n", root.dump(2));
        return ExitCode::ok;
    }
    const auto of_mean = [&](double change) {
        return std::isnan(change) ? std::string("lost in noise")
                                  : fmt::format("{:.3f} %", 100 * change / f.reference_mean);
    };
    TextTable table({"flicker", "change", "reference's", "standard error", "of a mean of"});
    table.add({std::isnan(f.ratio) ? "unknown (more --spp)" : fmt::format("{:.3f}", f.ratio),
               of_mean(f.change), of_mean(f.reference_change), of_mean(f.reference_error),
               fmt::format("{:.4g} lx", f.reference_mean)});
    fmt::print("{}", table.text());
    return ExitCode::ok;
}

using Measurement = ExitCode (*)(const Options&, Settings&);

void add_common(CLI::App& command, Options& options) {
    command.add_option("SCENE", options.input.scene, "glTF 2.0 file (.gltf, .glb)")->required();
    command.add_option("--preset", options.input.preset, "low, medium, high or ultra");
    command
        .add_option("--set", options.input.set,
                    "KEY=VALUE, repeatable: any setting of render --list-settings")
        ->allow_extra_args(false);
    command.add_flag("--json", options.json, "print one JSON object");
}

}  // namespace

Command add_measure(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("measure", "What an image cannot tell of a scene's indirect light.");
    CLI::App* hits = command->add_subcommand(
        "hits",
        "Share of photon segments whose image-space hit lies within 2 % of the diagonal of Embree's.");
    CLI::App* coverage = command->add_subcommand(
        "coverage", "Area share of what reflected light reaches that a selected map sees, by Embree.");
    CLI::App* flicker = command->add_subcommand(
        "flicker",
        "Change from frame to frame of indirect light in a slow motion, over the reference's own.");
    CLI::App* energy =
        command->add_subcommand("energy", "Where the lights' flux goes: stored, absorbed, lost, by bounce.");
    for (CLI::App* measure : {hits, coverage, flicker, energy}) {
        add_common(*measure, *options);
    }
    coverage->add_option("--points", options->points, "points asked, spread evenly over all surfaces")
        ->check(CLI::Range(1, 100000000))
        ->capture_default_str();
    FlickerJob& job = options->flicker;
    flicker->add_option("--motion", options->motion, "light or pan")
        ->check(CLI::IsMember({"light", "pan"}))
        ->capture_default_str();
    flicker->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    flicker->add_option(
        "--camera", options->input.camera,
        "a camera node's name or a camera's number (default: the first); auto: one that sees everything");
    flicker->add_option("--frames", job.frames, "changes from frame to frame to measure")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    flicker->add_option("--warmup", job.warmup, "frames of the motion before")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    flicker->add_option("--step", job.step, "motion a frame: share of the scene's diagonal; radians of turns")
        ->check(CLI::Range(1e-6, 1.0))
        ->capture_default_str();
    flicker->add_option("--spp", job.spp, "samples a pixel of the reference, in each frame")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    return [=] {
        Measurement measurement = nullptr;
        for (const auto& [measure, run] : {std::pair<CLI::App*, Measurement>{hits, run_hits},
                                           {coverage, run_coverage},
                                           {flicker, run_flicker},
                                           {energy, run_energy}}) {
            measurement = measure->parsed() ? run : measurement;
        }
        if (measurement == nullptr) {
            throw InputError("measure: found no measure, expected hits, coverage, flicker or energy");
        }
        SettingsSchema schema;
        declare_all_settings(schema);
        Settings settings(schema);
        return measurement(*options, settings);
    };
}

}  // namespace lanthorn::tools
