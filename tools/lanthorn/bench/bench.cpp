// lanthorn bench paper: the frame rates of Yao et al. 2010, Table 1, beside ours.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "lanthorn/core/choice.h"
#include "tools/lanthorn/bench/paper_bench.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

const std::vector<std::string> kFinals = {"splat", "gather"};

struct BenchOptions {
    std::vector<std::string> scenes, finals = kFinals, sizes = {"512x512", "1024x1024"};
    std::string share = "1";
    SettingsChoice settings;
    PaperJob job;
    bool full = false, json = false;
};

// "1/20" or "0.05".
double parse_share(const std::string& text) {
    const auto number = [](std::string_view part) -> std::optional<double> {
        double value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && end == part.data() + part.size() ? std::optional(value) : std::nullopt;
    };
    const std::size_t bar = text.find('/');
    const auto above = number(std::string_view(text).substr(0, bar));
    const auto below =
        bar == std::string::npos ? std::optional(1.0) : number(std::string_view(text).substr(bar + 1));
    const double share = above && below ? *above / *below : 0;
    if (!(share > 0 && share <= 1)) {
        throw InputError(fmt::format(
            "--photons-share: found '{}', expected a share above 0 and up to 1, 1/20 or 0.05", text));
    }
    return share;
}

std::string scene_names() {
    std::string names;
    for (const PaperRow& row : kPaperRows) {
        names += (names.empty() ? "" : ", ") + std::string(row.scene);
    }
    return names;
}

std::vector<const PaperRow*> rows_of(const std::vector<std::string>& scenes) {
    std::vector<const PaperRow*> rows;
    for (const std::string& name : scenes) {
        const auto* row =
            std::ranges::find_if(kPaperRows, [&](const PaperRow& r) { return r.scene == name; });
        if (row == kPaperRows.end()) {
            throw InputError(
                fmt::format("--scene: found no scene '{}', expected some of {}", name, scene_names()));
        }
        rows.push_back(row);
    }
    if (scenes.empty()) {
        for (const PaperRow& row : kPaperRows) {
            rows.push_back(&row);
        }
    }
    return rows;
}

// The paper's own at 512x512 and 1024x1024; it has no other.
std::optional<double> paper_fps(const PaperRow& row, ivec2 size) {
    return size == ivec2(512)    ? std::optional(row.fps_512)
           : size == ivec2(1024) ? std::optional(row.fps_1024)
                                 : std::nullopt;
}

struct Measured {
    std::string final;
    ivec2 size;
    PaperFigures figures;
};

std::uint64_t placed_triangles(const SceneData& scene) {
    std::uint64_t count = 0;
    for (const NodeData& node : scene.nodes) {
        for (const std::uint32_t mesh : node.meshes) {
            count += scene.meshes[mesh].indices.size() / 3;
        }
    }
    return count;
}

std::string size_name(ivec2 size) {
    return fmt::format("{}x{}", size.x, size.y);
}

void print_row(const PaperRow& row, double share, std::uint64_t triangles, const std::vector<Measured>& all) {
    fmt::print("{}, Fig. {}: {} triangles (paper: {}), {} photons, {} of caustics; bounces: {}, maps: {}\n",
               row.scene, row.figure, triangles, row.triangles, paper_share(row.photons, share),
               paper_share(row.caustic_photons, share), row.bounces, row.maps);
    TextTable rates(
        {"final", "size", "paper fps", "our fps", "times", "frame ms", "indirect ms", "processor ms"});
    std::vector<std::string> heading = {"pass, ms"};
    std::map<std::string, std::vector<std::string>> passes;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [final, size, figures] = all[i];
        const std::optional<double> paper = paper_fps(row, size);
        rates.add({final, size_name(size), paper ? fmt::format("{:.1f}", *paper) : "-",
                   fmt::format("{:.2f}", figures.fps()),
                   paper ? fmt::format("{:.2f}", figures.fps() / *paper) : "-",
                   fmt::format("{:.1f}", figures.frame), fmt::format("{:.1f}", figures.gi),
                   fmt::format("{:.1f}", figures.frame_cpu)});
        heading.push_back(final + " " + size_name(size));
        for (const auto& [name, ms] : figures.passes) {
            auto& cells = passes[name];
            cells.resize(i, "-");
            cells.push_back(fmt::format("{:.2f}", ms));
        }
    }
    TextTable table(heading);
    for (auto& [name, cells] : passes) {
        cells.resize(all.size(), "-");
        cells.insert(cells.begin(), name);
        table.add(cells);
    }
    fmt::print("{}\n{}\n", rates.text(), table.text());
    std::fflush(stdout);
}

nlohmann::ordered_json row_json(const PaperRow& row, double share, std::uint64_t triangles,
                                const std::vector<Measured>& all) {
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const auto& [final, size, figures] : all) {
        const std::optional<double> paper = paper_fps(row, size);
        runs.push_back({{"final", final},
                        {"size", {size.x, size.y}},
                        {"paper_fps", paper ? nlohmann::ordered_json(*paper) : nullptr},
                        {"fps", figures.fps()},
                        {"frame_ms", figures.frame},
                        {"gi_ms", figures.gi},
                        {"frame_cpu_ms", figures.frame_cpu},
                        {"gi_cpu_ms", figures.gi_cpu},
                        {"gi_passes", figures.passes},
                        {"photons_emitted", figures.photons},
                        {"nan_count", figures.nan_count}});
    }
    return {{"scene", row.scene},
            {"figure", row.figure},
            {"triangles", triangles},
            {"paper_triangles", row.triangles},
            {"photons", paper_share(row.photons, share)},
            {"caustic_photons", paper_share(row.caustic_photons, share)},
            {"bounces", row.bounces},
            {"maps", row.maps},
            {"runs", std::move(runs)}};
}

ExitCode run(BenchOptions options) {
    options.job.moving = options.job.moving || options.full;
    const double share = parse_share(options.share);
    const std::vector<const PaperRow*> rows = rows_of(options.scenes);
    std::vector<ivec2> sizes;
    for (const std::string& size : options.sizes) {
        sizes.push_back(parse_size("--size", size, 1, kLargestPicture));
    }
    const ChosenSettings chosen(options.settings);

    MeasuredSteps work("bench", "what was measured until then is printed",
                       rows.size() * sizes.size() * options.finals.size());
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string renderer;
    for (const PaperRow* row : rows) {
        const SceneData scene = paper_scene(*row);
        std::vector<Measured> all;
        const auto measure = [&](const std::string& final, ivec2 size) {
            Settings settings = chosen.settings;
            settings.set_from_text("gi.technique", "emc");
            settings.set_from_text("gi.emc.final", final);
            apply_row(*row, share, settings);
            PaperJob job = options.job;
            job.size = size;
            job.mover = row->mover;
            all.push_back({final, size, measure_row(scene, settings, job)});
            renderer = all.back().figures.renderer;
            work.step();
        };
        const bool whole = work.part([&] {
            for (const std::string& final : options.finals) {
                for (const ivec2 size : sizes) {
                    measure(final, size);
                }
            }
        });
        if (all.empty()) {
            break;  // stopped
        }
        if (options.json) {
            list.push_back(row_json(*row, share, placed_triangles(scene), all));
        } else {
            print_row(*row, share, placed_triangles(scene), all);
        }
        if (!whole) {
            break;
        }
    }
    if (options.json) {
        const nlohmann::ordered_json root{{"bench", "paper"},
                                          {"photons_share", share},
                                          {"frames", options.job.frames},
                                          {"moving", options.job.moving},
                                          {"renderer", renderer},
                                          {"preset", options.settings.preset},
                                          {"set", options.settings.set},
                                          {"rows", std::move(list)}};
        fmt::print("{}\n", root.dump(2));
    } else {
        fmt::print(
            "Ours: {}, medians of {} frames in which lamps change and {}. The paper's: GeForce GTX 260.\n",
            renderer, options.job.frames, options.job.moving ? "things move" : "nothing moves");
    }
    work.finish();
    return ExitCode::ok;
}

}  // namespace

Command add_bench(CLI::App& app) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* bench = app.add_subcommand("bench", "Speed beside what others have published.");
    CLI::App* paper = bench->add_subcommand(
        "paper",
        "Frame rates of Yao et al. 2010, Table 1, beside ours: the paper's counts of photons, bounces and "
        "maps, "
        "by pass. The lamps change in every frame, so that all photons are traced in each. Where the final "
        "stage gathers, photons on the picture are those of caustics alone.");
    paper->add_option("--scene", options->scenes, scene_names() + " (default: all), separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false);
    paper->add_option("--size", options->sizes, "WIDTHxHEIGHT in pixels, several separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str("512x512,1024x1024");
    paper->add_option("--final", options->finals, "splat, the paper's, gather, or both (default)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(kFinals));
    paper
        ->add_option("--photons-share", options->share,
                     "of the paper's photons: 1/20 for software rasterisers")
        ->capture_default_str();
    paper->add_option("--frames", options->job.frames, "that are measured")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    paper->add_option("--warmup", options->job.warmup, "frames before")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    add_settings_options(*paper, options->settings);
    paper->add_flag("--moving", options->job.moving,
                    "one thing of each scene slides, or its animation goes on, so that maps are redrawn and "
                    "updated; without it geometry stands still");
    paper->add_flag("--full", options->full, "the paper's table whole: --moving, all photons, both sizes")
        ->excludes("--photons-share", "--size");
    paper->add_flag("--json", options->json, "print one JSON object");
    return [options, paper] {
        if (paper->parsed()) {
            return run(*options);
        }
        throw InputError("bench: found no benchmark, expected paper");
    };
}

}  // namespace lanthorn::tools
