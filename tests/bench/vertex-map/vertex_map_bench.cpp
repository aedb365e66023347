// Figures 21 to 27 of Jozwowski 2002: what the stages of `vertex-map` cost, in the thesis's scene and with
// its settings, on one thread and by the processor's clock; medians over frames in each of which the light
// moves. Balancing is measured in two ways at once: the tree built anew in every frame, as there, and kept.
//   bench_vertex_map [FRAMES [FOLDER]]   with FOLDER: writes figure-21.svg and .csv to figure-27 there
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "gi_module/techniques/vertex-map/kept_tree.h"
#include "gi_module/techniques/vertex-map/photon_turns.h"
#include "gi_module/techniques/vertex-map/shot_scene.h"
#include "gi_module/techniques/vertex-map/vertex_scene.h"
#include "lanthorn/core/error.h"
#include "tests/bench/vertex-map/line_chart.h"
#include "tests/bench/vertex-map/thesis_scene.h"

using namespace lanthorn;
using namespace lanthorn::gi;

namespace {

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Case {
    int side = 1;       // 16 side^2 surfaces
    int shot_side = 0;  // of the surfaces that photons meet; 0: the same
    VertexMapSettings settings;
};

// Sec. 5.1: 2000 photons, 100 a frame, 3 levels, 100 in an estimate, no speed-ups.
Case thesis_case(int side) {
    Case c;
    c.side = side;
    c.settings.total = 2000;
    c.settings.per_frame = 100;
    c.settings.max_level = 3;
    c.settings.nearest = 100;
    c.settings.distance = 0.3f;
    c.settings.kernel = EstimateKernel::constant;
    c.settings.edge = 1;
    c.settings.density = 0;
    c.settings.corners = false;
    c.settings.skip = SkippedVertices::none;
    c.settings.threads = 1;
    return c;
}

struct Stages {
    double shoot = 0, rebuilt = 0, kept = 0, estimate = 0;  // ms a frame
    std::size_t estimates = 0, stored = 0;
    double whole() const { return shoot + kept + estimate; }
};

Stages measure(const Case& c, int frames) {
    FrameScene drawn = bench::thesis_scene(c.side);
    FrameScene shot = bench::thesis_scene(c.shot_side > 0 ? c.shot_side : c.side);
    reference::TileWorkers workers(c.settings.threads);
    ShotScene scene;
    PhotonTurns turns;
    PhotonStore store;
    store.reset(static_cast<std::size_t>(c.settings.total), static_cast<std::size_t>(c.settings.max_level));
    KeptTree kept;
    const auto rebuilt = make_rebuilt_tree();
    VertexScene vertices;
    vertices.follow(drawn, c.settings);
    std::vector<double> shoot, balance, keep, estimate;
    Stages result;
    for (int frame = 0; frame <= frames; ++frame) {
        bench::circle_light(drawn, frame);
        bench::circle_light(shot, frame);
        const double start = processor_ms();
        scene.follow(shot, 0);
        turns.outdate();
        const auto count = static_cast<std::uint64_t>(frame == 0 ? c.settings.total : c.settings.per_frame);
        turns.shoot(scene.tracer({c.settings.max_level - 1, 1, PhotonScattering::even}), scene.sources(),
                    shot, count, c.settings, true, store, workers);
        const double shot_at = processor_ms();
        rebuilt->update(store, frame == 0);
        const double rebuilt_at = processor_ms();
        kept.update(store, frame == 0);
        store.forget_changed();
        const double kept_at = processor_ms();
        const std::vector<std::uint32_t> wanted = c.settings.skip == SkippedVertices::none
                                                      ? std::vector<std::uint32_t>()
                                                      : vertices.facing(drawn.camera);
        result.estimates = vertices.estimate(wanted, static_cast<std::uint64_t>(frame) + 1, kept, store,
                                             c.settings, workers);
        const double estimated_at = processor_ms();
        if (frame > 0) {  // the first one shoots all, and finds areas
            shoot.push_back(shot_at - start);
            balance.push_back(rebuilt_at - shot_at);
            keep.push_back(kept_at - rebuilt_at);
            estimate.push_back(estimated_at - kept_at);
        }
    }
    result.shoot = median(shoot);
    result.rebuilt = median(balance);
    result.kept = median(keep);
    result.estimate = median(estimate);
    result.stored = store.used();
    return result;
}

struct Figure {
    int number;
    std::string title, x_name;
    std::vector<int> x;
    std::vector<bench::ChartMark> marks;
    Case (*of)(int x);
};

Case with_surfaces(int surfaces) {
    int side = 1;
    while (16 * side * side < surfaces) {
        ++side;
    }
    return thesis_case(side);
}

std::vector<Figure> figures() {
    const std::vector<int> surfaces{16, 64, 256, 1024, 4096};
    const bench::ChartMark forty{"thesis: 256 surfaces, 40 frames/s", 25};
    return {
        {21,
         "Figure 21: photons a frame",
         "per_frame",
         {25, 50, 100, 200, 400, 800},
         {{"thesis: whole frame below", 60}},
         [](int x) {
             Case c = thesis_case(1);
             c.settings.per_frame = x;
             return c;
         }},
        {22,
         "Figure 22: photons kept",
         "total",
         {500, 1000, 2000, 4000, 8000},
         {{"thesis: whole frame at most", 40}},
         [](int x) {
             Case c = thesis_case(1);
             c.settings.total = x;
             return c;
         }},
        {23,
         "Figure 23: hits of a photon",
         "max_level",
         {1, 2, 3, 4, 5, 6},
         {},
         [](int x) {
             Case c = thesis_case(1);
             c.settings.max_level = x;
             return c;
         }},
        {24,
         "Figure 24: surfaces",
         "surfaces",
         surfaces,
         {{"thesis: many surfaces, above", 1000}},
         [](int x) { return with_surfaces(x); }},
        {25,
         "Figure 25: surfaces, photons meet 16",
         "surfaces",
         surfaces,
         {},
         [](int x) {
             Case c = with_surfaces(x);
             c.shot_side = 1;
             return c;
         }},
        {26,
         "Figure 26: the same, back faces skipped",
         "surfaces",
         surfaces,
         {forty},
         [](int x) {
             Case c = with_surfaces(x);
             c.shot_side = 1;
             c.settings.skip = SkippedVertices::back_faces;
             return c;
         }},
        {27,
         "Figure 27: the same, corners shared",
         "surfaces",
         surfaces,
         {forty},
         [](int x) {
             Case c = with_surfaces(x);
             c.shot_side = 1;
             c.settings.corners = true;
             return c;
         }},
    };
}

// Estimates of a frame at 256 surfaces by figure: ceilings, which only go down.
struct MostEstimates {
    int figure;
    std::size_t ceiling;
};
constexpr MostEstimates kMostEstimates[] = {{24, 1536}, {25, 1536}, {26, 1152}, {27, 400}};
constexpr std::size_t kFewestEstimates = 300;  // with all speed-ups

bool holds(std::size_t estimates, std::size_t ceiling) {
    if (estimates > ceiling) {
        fmt::print("above its ceiling: {} estimates, at most {}\n", estimates, ceiling);
    }
    return estimates <= ceiling;
}

// `plain`: what a frame takes without any speed-up, drawn beside those that have some; figure 24 finds it.
// False: above a ceiling.
bool draw(const Figure& figure, int frames, const std::filesystem::path& folder, std::vector<double>& plain) {
    bool kept = true;
    bench::Chart chart{figure.title, figure.x_name, "ms a frame (processor)", {}, {}, figure.marks};
    chart.lines = {{"shooting", {}},
                   {"balancing: built anew", {}},
                   {"balancing: kept", {}},
                   {"radiance estimates", {}},
                   {"all, tree kept", {}}};
    fmt::print("figure {}: {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  ms; estimates, photons\n", figure.number,
               figure.x_name, "shoot", "rebuilt", "kept", "estimate", "all");
    for (const int x : figure.x) {
        const Stages s = measure(figure.of(x), frames);
        chart.x.push_back(x);
        const double values[] = {s.shoot, s.rebuilt, s.kept, s.estimate, s.whole()};
        for (std::size_t i = 0; i < chart.lines.size(); ++i) {
            chart.lines[i].values.push_back(values[i]);
        }
        fmt::print("           {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f}  {} {}\n", x, s.shoot,
                   s.rebuilt, s.kept, s.estimate, s.whole(), s.estimates, s.stored);
        for (const MostEstimates& most : kMostEstimates) {
            if (most.figure == figure.number && x == 256) {
                kept = holds(s.estimates, most.ceiling) && kept;
            }
        }
    }
    if (figure.number == 24) {
        plain = chart.lines.back().values;
    } else if (figure.number > 24) {
        chart.lines.push_back({"all, no speed-up (figure 24)", plain});
    }
    if (!folder.empty()) {
        const std::string name = fmt::format("figure-{}", figure.number);
        bench::write_svg(chart, folder / (name + ".svg"));
        bench::write_csv(chart, folder / (name + ".csv"));
    }
    return kept;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int frames = argc > 1 ? std::atoi(argv[1]) : 60;
        if (frames < 1) {
            fmt::print(stderr, "bench_vertex_map: '{}' where frames were expected, at least 1\n", argv[1]);
            return 2;
        }
        std::vector<double> plain;
        bool kept = true;
        for (const Figure& figure : figures()) {
            kept = draw(figure, frames, argc > 2 ? argv[2] : "", plain) && kept;
        }
        // All speed-ups at once.
        Case c = with_surfaces(256);
        c.settings.corners = true;
        c.settings.skip = SkippedVertices::back_faces;
        const Stages s = measure(c, frames);
        fmt::print(
            "256 surfaces, 2000 photons, 100 a frame, 3 levels, corners shared, back faces skipped: {:.3f} "
            "ms a "
            "frame of one thread (shooting {:.3f}, balancing {:.3f}, {} estimates {:.3f})\n",
            s.whole(), s.shoot, s.kept, s.estimates, s.estimate);
        return holds(s.estimates, kFewestEstimates) && kept ? 0 : 1;
    } catch (const Error& error) {
        fmt::print(stderr, "bench_vertex_map: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
