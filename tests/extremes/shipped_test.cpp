// Every row by what is shipped: the default settings, exact rays, photons, endless bounces and the default
// grid, in frames 1, 16 and 64, held against all bounces of the path tracer (or a closed form) and judged by
// the ordinary room's own error in the same frame.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <ostream>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/reference/path_tracer.h"
#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"
#include "tests/extremes/truth.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

// For GoogleTest's messages.
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

namespace {

constexpr ivec2 kSize(48);
constexpr int kSpp = 128;
constexpr std::array kFrames = {1, 16, 64};
using Measured = std::array<Difference, kFrames.size()>;

constexpr double kError = 2.1;   // bound of the relRMSE, in ordinary errors of the same frame
constexpr double kFlux = 0.05;   // of |flux ratio - 1|
constexpr double kLeak = 0.015;  // of light where there is none, over the picture's mean

std::vector<Row> all_rows() {
    std::vector<Row> rows;
    for (const auto& part : {rows_of_placement(), rows_of_light(), rows_of_counts(), rows_of_views(),
                             rows_of_triangles(), rows_of_rooms(), rows_of_skies(), rows_of_lamps()}) {
        rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
}

// Known: in some frame the row is off by so much and no more. Red, too, when it is within the usual bounds.
struct Known {
    const char* row;
    double error, flux, leak;  // at most; 0: the usual one
    const char* why;
};
constexpr const char* kSpot = "much of the light leaves one lit texel, which few rays meet";
constexpr Known kKnown[] = {
    {"bulb 5 mm off a sphere's wall", 5.9, 0.09, 0, kSpot},
    {"a sky of one pixel of 1e6 nits", 11.8, 0, 0,
     "a cell of the sky, six degrees wide, that rays find by chance"},
    {"k = 1", 2.45, 0, 0, "one map sees half of the room"},
    {"a block inside out", 4.4, 0.14, 0.039, "light leaks through map texels on the block's edges"},
    {"crawl space of 8 x 0.2 x 8 m", 2.55, 0, 0, "kernels of photons are wider than the room is high"},
    {"400 lamps", 3.4, 0.11, 0, "maps of so many lamps have 64 texels a side: lamps by a ceiling shade it"},
    {"a range of 1 m", 2.5, 0, 0, "light on a wall changes within few lit texels"},
    {"a lamp in a box with a gap of 3 mm", 900, 36, 34,
     "photons leave through walls whose inner side no map sees"},
};

// What reflects all but nothing of the light has no endless series worth the name: there bounces are counted.
bool endless(const Stage& stage) {
    return largest_albedo(stage) <= 0.95f;
}

Truth truth_of(const Row& row, const Stage& stage, const FrameScene& scene) {
    if (row.right == Right::constant && row.ordinary == Ordinary::sphere) {
        // The sphere's geometric series, whole where bounces are endless.
        const float albedo = largest_albedo(stage);
        const double counted = sphere_irradiance(albedo, row.settings.bounces);
        return constant_truth(
            row.lux / counted * sphere_irradiance(albedo, endless(stage) ? 200 : row.settings.bounces),
            kSize);
    }
    reference::PathSettings settings;
    settings.transport = reference::Transport::diffuse;
    settings.spp = kSpp;
    settings.bounces = row.settings.bounces;
    settings.unlimited = endless(stage);
    reference::PathTracer tracer(scene, kSize, settings, {.indirect = true});
    tracer.render({});
    return {tracer.image(reference::PathAov::indirect), tracer.noise(reference::PathAov::indirect)};
}

// The row's numbers at their ends, and the default for all else.
gi::GiSettings shipped(const Row& row, const Stage& stage) {
    gi::GiSettings settings = row.settings;
    const gi::EmcSettings standard;
    auto& emc = settings.edit<gi::EmcSettings>();
    emc.final_stage = standard.final_stage;
    emc.gather_endless = endless(stage);
    emc.rays = gi::EmcRays::bvh;  // `fastest` would measure which
    return settings;
}

Measured measure(const FrameScene& first, const gi::GiSettings& settings, const Truth& truth) {
    gi::add_embree_rays();
    gi::test::Bench bench;
    bench.settings = settings;
    FrameScene scene = first;
    Measured result;
    std::size_t next = 0;
    for (int frame = 1; frame <= kFrames.back(); ++frame) {
        if (frame == kFrames.at(next)) {
            const std::vector<float> lux = bench.frame(scene, kSize).pixels;
            EXPECT_TRUE(std::ranges::all_of(lux, [](float v) { return std::isfinite(v) && v >= 0; }))
                << frame;
            result.at(next++) = difference(lux, truth);
        } else {
            bench.show(scene, kSize);
        }
        gi::test::hold_still(scene);
    }
    EXPECT_EQ(bench.renderer().nan_count(), 0u);
    EXPECT_EQ(bench.technique().statistics(true).nan_count, 0u);
    return result;
}

const Measured& ordinary() {
    static const Measured made = [] {
        const FrameScene scene = frame_of(room(), {});
        return measure(scene, shipped(Row{}, room()), truth_of(Row{}, room(), scene));
    }();
    return made;
}

struct Line {
    std::string row;
    Measured off, usual;
    std::string why;
};
std::vector<Line>& lines() {
    static std::vector<Line> all;
    return all;
}

// LANTHORN_EXTREMES_PAGE names a file: the table as a page of HTML.
void write_page() {
    const char* file = std::getenv("LANTHORN_EXTREMES_PAGE");
    if (file == nullptr) {
        return;
    }
    std::ofstream page(file);
    page
        << "<!doctype html><meta charset=utf-8><title>Lanthorn: extremes by the shipped default</title>"
           "<style>body{font:14px sans-serif;margin:2em}td,th{padding:.2em "
           ".7em;text-align:right;border-bottom:1px "
           "solid "
           "#ddd}td:first-child,td:last-child,th:first-child{text-align:left}.off{background:#f6c9c0}</style>"
           "<h1>Extremes by the shipped default</h1><p>relRMSE of indirect irradiance in errors of the "
           "ordinary "
           "scene in the same frame, and flux over the path tracer's, in frames 1, 16 and "
           "64.<table><tr><th>row";
    for (const char* what : {"error", "flux"}) {
        for (const int frame : kFrames) {
            page << fmt::format("<th>{}, {}", what, frame);
        }
    }
    page << "<th>leak<th>known defect";
    for (const Line& line : lines()) {
        page << "<tr><td>" << line.row;
        const auto cell = [&](double value, bool off) {
            page << fmt::format("<td{}>{:.3f}", off ? " class=off" : "", value);
        };
        double leak = 0;
        for (std::size_t i = 0; i < kFrames.size(); ++i) {
            const double ratio = line.off.at(i).rel_rmse / line.usual.at(i).rel_rmse;
            cell(ratio, ratio > kError);
            leak = std::max(leak, line.off.at(i).leak);
        }
        for (const Difference& off : line.off) {
            cell(off.flux_ratio, std::abs(off.flux_ratio - 1) > kFlux);
        }
        cell(leak, leak > kLeak);
        page << "<td>" << line.why;
    }
    page << "</table>\n";
}

class ShippedExtremes : public testing::TestWithParam<Row> {
  protected:
    static void TearDownTestSuite() { write_page(); }
};

TEST_P(ShippedExtremes, Hold) {
    const Row& row = GetParam();
    const Stage stage = row.stage();
    const FrameScene scene = frame_of(stage, row.placement);
    const Measured off = measure(scene, shipped(row, stage), truth_of(row, stage, scene));
    const Measured& usual = ordinary();
    const auto known = std::ranges::find_if(kKnown, [&](const Known& k) { return k.row == row.name; });
    const bool is_known = known != std::end(kKnown);
    const auto or_usual = [&](double Known::*of, double bound) {
        return is_known && (*known).*of > 0 ? (*known).*of : bound;
    };
    bool within = true;
    for (std::size_t i = 0; i < kFrames.size(); ++i) {
        const double error = off.at(i).rel_rmse / usual.at(i).rel_rmse;
        const double flux = std::abs(off.at(i).flux_ratio - 1);
        std::printf("%-44s frame %2d: relRMSE %.4f (%.2f), flux %.4f, leak %.4f\n", row.name.c_str(),
                    kFrames.at(i), off.at(i).rel_rmse, error, off.at(i).flux_ratio, off.at(i).leak);
        if (row.bounces == 0) {
            EXPECT_EQ(off.at(i).rel_rmse, 0);
            continue;
        }
        EXPECT_LE(error, or_usual(&Known::error, kError)) << kFrames.at(i);
        EXPECT_LE(flux, or_usual(&Known::flux, kFlux)) << kFrames.at(i);
        EXPECT_LE(off.at(i).leak, or_usual(&Known::leak, kLeak)) << kFrames.at(i);
        within = within && error <= kError && flux <= kFlux && off.at(i).leak <= kLeak;
    }
    EXPECT_FALSE(is_known && within) << "this defect can go: " << (is_known ? known->why : "");
    lines().push_back({row.name, off, usual, is_known ? known->why : ""});
}

INSTANTIATE_TEST_SUITE_P(Rows, ShippedExtremes, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return plain(info.param.name); });

}  // namespace

}  // namespace lanthorn::extremes
