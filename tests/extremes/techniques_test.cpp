// The table's scenes by every technique that has a folder of its own: finite, not negative, dark where no
// light comes, and with the flux that the path tracer finds for the bounces that the technique traces.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <utility>

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
constexpr int kFrames = 4;  // still ones: techniques that trace some light a frame have begun to agree
constexpr int kSpp = 64;

std::vector<Row> all_rows() {
    std::vector<Row> rows;
    for (const auto& part : {rows_of_placement(), rows_of_light(), rows_of_views(), rows_of_triangles(),
                             rows_of_rooms(), rows_of_skies()}) {
        rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
}

// Of the mean over the path tracer's, and of light where there is none, over the picture's mean. Measured,
// with some room.
struct Bounds {
    const char* technique;
    double least, most, leak;
};
constexpr Bounds kBounds[] = {
    {"coarse-path", 0.9, 1.1, 0.12},  // points are as far apart as the leak reaches
    {"drm", 0.65, 1.15, 0.9},         // nothing hides a sample
    {"splat", 0.9, 1.1, 0.05},
    {"vertex-map", 0.9, 1.1, 0.08},
};
constexpr Bounds kUsual = {"", 0.95, 1.05, 0.02};

// Known: the mean is off by so much and no more. Red, too, when it is within the bounds again.
struct Known {
    const char* technique;
    const char* row;
    double least, most;
    const char* why;
};
constexpr const char* kCoincide =
    "surfaces that coincide count as two: photons lie on one, the picture shows the other";
constexpr const char* kWide = "lengths are relative to the whole scene";
constexpr const char* kFarLamp =
    "photons are shared by flux: a dome that gives the room nothing has them all";
constexpr const char* kNoSky = "skies have no picture";
constexpr Known kKnown[] = {
    {"coarse-path", "bulb 5 mm off a sphere's wall", 0.5, 0.6,
     "paths seldom meet the bright spot that lights all"},
    {"coarse-path", "a sky of one pixel of 1e6 nits", 1.1, 1.25,
     "few paths, and a filter that spreads the brightest"},
    {"drm", "an even sky", 0, 0, kNoSky},
    {"drm", "a sky of one pixel of 1e6 nits", 0, 0, kNoSky},
    {"drm", "crawl space of 8 x 0.2 x 8 m", 0.01, 0.02, "samples stand further apart than the room is high"},
    {"drm", "in a box of 1e+06 m", 0.2, 0.3, kWide},
    {"drm", "in a box of 1e+06 m off its middle", 0.2, 0.3, kWide},
    {"drm", "in a glowing box of 1e+06 m", 0.2, 0.3, kWide},
    {"splat", "a hut on a plain of 100 m", 0.55, 0.7, kWide},
    {"splat", "a hut on a plain of 3000 m", 0.55, 0.7, kWide},
    {"splat", "in a glowing box of 1000 m", 0, 0.1, kFarLamp},
    {"splat", "in a glowing box of 1e+06 m", 0, 0.1, kFarLamp},
    {"splat", "coplanar walls", 0.8, 0.87, kCoincide},
    {"splat", "bulb in the ceiling's plane", 1.15, 1.22, "a ceiling lit at grazing angles, near the bulb"},
    {"vertex-map", "in a box of 1000 m", 0.08, 0.2, kWide},
    {"vertex-map", "in a box of 1e+06 m", 0.05, 0.15, kWide},
    {"vertex-map", "in a box of 1e+06 m off its middle", 0.05, 0.15, kWide},
    {"vertex-map", "in a glowing box of 1000 m", 0, 0.1, kFarLamp},
    {"vertex-map", "in a glowing box of 1e+06 m", 0, 0.1, kFarLamp},
    {"vertex-map", "a hut on a plain of 100 m", 0.77, 0.87, kWide},
    {"vertex-map", "a hut on a plain of 3000 m", 0, 0.07, kWide},
    {"vertex-map", "coplanar walls", 0.84, 0.9, kCoincide},
    {"vertex-map", "bulb in the ceiling's plane", 1.17, 1.24,
     "a ceiling lit at grazing angles, near the bulb"},
};

// The truth by as many bounces as the technique has traced. Closed forms that count more are left to the path
// tracer.
const Truth& truth_of(const Row& row, const FrameScene& scene, int bounces) {
    static std::map<std::pair<std::string, int>, Truth> known;
    const auto [entry, fresh] = known.try_emplace({row.name, bounces});
    if (fresh) {
        if (row.right == Right::traced || (row.right == Right::constant && bounces != row.settings.bounces)) {
            entry->second = traced_truth(scene, kSize, bounces, kSpp);
        } else if (row.right == Right::constant) {
            entry->second = constant_truth(row.lux, kSize);
        } else if (row.ordinary == Ordinary::sphere) {
            entry->second = constant_truth(row.gain * sphere_irradiance(0.5f, bounces), kSize);
        } else {
            entry->second = brighter(traced_truth(frame_of(room(), {}), kSize, bounces, kSpp), row.gain);
        }
    }
    return entry->second;
}

// The last of some frames, in each of which no value of any picture may be bad; and the bounces that the
// technique traced.
std::pair<ImageF, int> last_frame(std::ptrdiff_t kind, const Row& row, std::uint32_t seed) {
    gi::test::Bench bench(static_cast<gi::TechniqueKind>(kind));
    const gi::TechniqueKind wanted = bench.settings.technique;
    bench.settings = row.settings;
    bench.settings.technique = wanted;
    bench.settings.seed = seed;
    FrameScene scene = frame_of(row.stage(), row.placement);
    ImageF image;
    for (int i = 0; i < kFrames; ++i) {
        image = bench.frame(scene, kSize);
        for (const render::Aov aov :
             {render::Aov::indirect, render::Aov::direct, render::Aov::radiance, render::Aov::final}) {
            const std::vector<float> pixels = bench.renderer().read(aov).pixels;
            EXPECT_TRUE(std::ranges::all_of(pixels, [](float v) { return std::isfinite(v); }))
                << static_cast<int>(aov);
        }
        EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return v >= 0; }));
        EXPECT_EQ(bench.renderer().nan_count(), 0u);
        gi::test::hold_still(scene);
    }
    const gi::GiStatistics statistics = bench.technique().statistics(true);
    EXPECT_EQ(statistics.nan_count, 0u);
    for (const gi::PlanEntry& entry : statistics.plan.entries) {
        EXPECT_FALSE(entry.why.empty()) << entry.pass;
    }
    return {std::move(image), statistics.plan.bounces};
}

class OtherTechniques : public testing::TestWithParam<std::tuple<std::string, Row>> {};

TEST_P(OtherTechniques, Hold) {
    const auto& [technique, row] = GetParam();
    const auto kind =
        std::ranges::find(gi::techniques(), technique, &gi::TechniqueEntry::name) - gi::techniques().begin();
    // All that it shows is one spot, for which a few dozen photons stand: seven seeds halve their noise and
    // more.
    const int seeds = row.name == "field of view 1 degrees" ? 7 : 1;
    const FrameScene first = frame_of(row.stage(), row.placement);
    ImageF image;
    int bounces = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const auto [picture, of] =
            last_frame(kind, row, row.settings.seed + static_cast<std::uint32_t>(seed));
        image.pixels.resize(picture.pixels.size());
        std::ranges::transform(image.pixels, picture.pixels, image.pixels.begin(),
                               [&](float sum, float v) { return sum + v / static_cast<float>(seeds); });
        bounces = of;
    }
    if (row.bounces == 0) {
        EXPECT_EQ(bounces, 0);
        EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float v) { return v == 0; }));
        return;
    }
    const Difference off = difference(image.pixels, truth_of(row, first, bounces));
    const auto listed = std::ranges::find(kBounds, technique, &Bounds::technique);
    const Bounds& bounds = listed == std::end(kBounds) ? kUsual : *listed;
    const auto known = std::ranges::find_if(
        kKnown, [&](const Known& k) { return k.technique == technique && k.row == row.name; });
    if (known == std::end(kKnown)) {
        EXPECT_GE(off.flux_ratio, bounds.least);
        EXPECT_LE(off.flux_ratio, bounds.most);
    } else {
        EXPECT_GE(off.flux_ratio, known->least) << known->why;
        EXPECT_LE(off.flux_ratio, known->most) << known->why;
        EXPECT_FALSE(off.flux_ratio >= bounds.least && off.flux_ratio <= bounds.most)
            << "this defect can go: " << known->why;
    }
    EXPECT_LE(off.leak, bounds.leak);
    std::printf("%-14s %-44s flux %.4f, relRMSE %.3f, leak %.4f\n", technique.c_str(), row.name.c_str(),
                off.flux_ratio, off.rel_rmse, off.leak);
}

std::vector<std::string> folders() {
    std::vector<std::string> names = gi::technique_names();
    std::erase_if(names,
                  [](const std::string& name) { return name == "emc" || name == "none" || name == "path"; });
    return names;
}

INSTANTIATE_TEST_SUITE_P(Techniques, OtherTechniques,
                         testing::Combine(testing::ValuesIn(folders()), testing::ValuesIn(all_rows())),
                         [](const auto& info) {
                             return plain(std::get<0>(info.param)) + "_" +
                                    plain(std::get<1>(info.param).name);
                         });

}  // namespace

}  // namespace lanthorn::extremes
