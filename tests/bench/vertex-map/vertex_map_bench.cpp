// Figures 21 to 27 of Jozwowski 2002: what the stages of `vertex-map` cost, in the thesis's scene and with
// its settings, on one thread and by the processor's clock; medians over frames in each of which the light
// moves. Each is measured in two ways at once, as in the thesis and as it is here (stages.h).
//   bench_vertex_map [FRAMES [FOLDER]]   with FOLDER: writes figure-21.svg and .csv to figure-27 there
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/error.h"
#include "tests/bench/vertex-map/line_chart.h"
#include "tests/bench/vertex-map/stages.h"

using namespace lanthorn;
using namespace lanthorn::gi;

namespace {

using bench::Case;
using bench::Stages;
using bench::thesis_case;

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

// A ray that asks every surface meets what one that asks a tree does, but where two meet at an edge.
bool meets(const Stages& stages) {
    constexpr double kAgree = 0.999;
    if (stages.agree < kAgree) {
        fmt::print("{:.4f} of the rays meet the same surface whether all or a tree is asked, expected {}\n",
                   stages.agree, kAgree);
    }
    return stages.agree >= kAgree;
}

// What a frame takes without any speed-up, by surfaces: figure 24 finds it, the others are held against it.
struct Plain {
    std::vector<double> thesis, here;
};

// False: above a ceiling, or photons have not met what they should.
bool draw(const Figure& figure, int frames, const std::filesystem::path& folder, Plain& plain) {
    bool kept = true;
    bench::Chart chart{figure.title, figure.x_name, "ms a frame (processor)", {}, {}, figure.marks};
    chart.lines = {{"thesis: shooting", {}},
                   {"thesis: balancing", {}},
                   {"thesis: estimates", {}},
                   {"thesis: all", {}},
                   {"here: shooting", {}},
                   {"here: balancing", {}},
                   {"here: the same, rebuilt", {}},
                   {"here: estimates", {}},
                   {"here: all", {}}};
    fmt::print(
        "figure {}: {:>9} | thesis: shoot balance estimate all | here: shoot balance (rebuilt) estimate all, "
        "ms;"
        " estimates, photons\n",
        figure.number, figure.x_name);
    for (const int x : figure.x) {
        const Stages s = measure(figure.of(x), frames);
        chart.x.push_back(x);
        const double values[] = {s.thesis.shoot,   s.thesis.balance, s.thesis.estimate,
                                 s.thesis.whole(), s.here.shoot,     s.here.balance,
                                 s.rebuilt,        s.here.estimate,  s.here.whole()};
        fmt::print("           {:>9} |", x);
        for (std::size_t i = 0; i < chart.lines.size(); ++i) {
            chart.lines[i].values.push_back(values[i]);
            fmt::print(" {:>8.3f}{}", values[i], i == 3 ? " |" : "");
        }
        fmt::print("  {} {}\n", s.estimates, s.stored);
        kept = meets(s) && kept;
        for (const MostEstimates& most : kMostEstimates) {
            if (most.figure == figure.number && x == 256) {
                kept = holds(s.estimates, most.ceiling) && kept;
            }
        }
    }
    if (figure.number == 24) {
        plain = {chart.lines[3].values, chart.lines[8].values};
    } else if (figure.number > 24) {
        for (std::size_t i = 0; i < figure.x.size(); ++i) {
            fmt::print("           {:>9} | {:.2f} times as fast as figure 24 as in the thesis, {:.2f} here\n",
                       figure.x[i], plain.thesis[i] / chart.lines[3].values[i],
                       plain.here[i] / chart.lines[8].values[i]);
        }
        chart.lines.push_back({"thesis: all, figure 24", plain.thesis});
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
        Plain plain;
        bool kept = true;
        for (const Figure& figure : figures()) {
            kept = draw(figure, frames, argc > 2 ? argv[2] : "", plain) && kept;
        }
        // All speed-ups at once.
        Case c = with_surfaces(256);
        c.shot_side = 1;
        c.settings.corners = true;
        c.settings.skip = SkippedVertices::back_faces;
        const Stages s = measure(c, frames);
        const auto print = [](const char* way, const Stages::Way& w) {
            fmt::print(
                "  {}: {:.3f} ms a frame of one thread (shooting {:.3f}, balancing {:.3f}, estimates "
                "{:.3f})\n",
                way, w.whole(), w.shoot, w.balance, w.estimate);
        };
        fmt::print(
            "256 surfaces, 2000 photons, 100 a frame, 3 levels, corners shared, back faces skipped, photons "
            "meet 16 "
            "surfaces: {} estimates\n",
            s.estimates);
        print("as in the thesis", s.thesis);
        print("here", s.here);
        return holds(s.estimates, kFewestEstimates) && kept ? 0 : 1;
    } catch (const Error& error) {
        fmt::print(stderr, "bench_vertex_map: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
