// The real `lanthorn measure`: figures that are known beforehand, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "lanthorn/assets/image_io.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace measure_command_test {

using nlohmann::json;
using testing_tools::Outcome;

std::string asset(const std::string& name) {
    return support::repository_file("assets/" + name + ".glb");
}

Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "measure");
    return testing_tools::run_program(LANTHORN_BINARY, arguments);
}

json measure(const std::string& what, const std::string& scene, std::vector<std::string> more = {}) {
    more.insert(more.begin(),
                {what, asset(scene), "--json", "--set", "gi.photons=4000", "--set", "gi.emc.candidates=16"});
    const Outcome result = run(more);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "no progress bar in a pipe";
    return json::parse(result.out);
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
    testing_tools::expect_refusal(run(arguments), part, arguments);
}

TEST(MeasureCommand, HitsAgreeAndAllAreCounted) {
    const json hits = measure("hits", "cornell");
    EXPECT_GT(hits.at("agreement"), 0.96);
    ASSERT_EQ(hits.at("bounces").size(), 2u);
    for (const json& b : hits.at("bounces")) {
        EXPECT_GT(b.at("segments"), 1000);
        double sum = 0;
        for (const char* part : {"agreement", "near", "far", "missed", "invented"}) {
            sum += b.at(part).get<double>();
        }
        EXPECT_NEAR(sum, 1, 1e-9);
    }
    EXPECT_EQ(hits.at("bins").size() + 1, hits.at("before").size());
}

// Light that table and walls reflect before the ring does is followed like what comes straight from the lamp.
TEST(MeasureCommand, EffectsAreThoseOfThePathTracer) {
    const json effects =
        measure("effects", "ring",
                {"--size", "64x64", "--spp", "128", "--set", "gi.bounces=6", "--set", "gi.emc.rays=bvh"});
    std::map<std::string, double> ratios;
    for (const json& e : effects.at("effects")) {
        ratios[e.at("effect")] = e.at("ratio").get<double>();
        EXPECT_GT(e.at("share"), 0.02) << e;
    }
    EXPECT_NEAR(ratios.at("caustics"), 1, 0.1);
    EXPECT_NEAR(ratios.at("diffuse indirect"), 1, 0.1);
    EXPECT_NEAR(ratios.at("mirrored by metal"), 1, 0.1);
    EXPECT_NEAR(ratios.at("all"), 1, 0.1);
}

TEST(MeasureCommand, ThePapersSecantAgreesLess) {
    const json march = measure("hits", "cornell");
    const json secant = measure("hits", "cornell", {"--set", "gi.emc.search=secant"});
    EXPECT_LT(secant.at("agreement").get<double>(), march.at("agreement").get<double>() - 0.05);
}

TEST(MeasureCommand, TheMomentOfTheAnimationCounts) {
    const json start = measure("energy", "puppet"), later = measure("energy", "puppet", {"--time", "0.6"});
    EXPECT_EQ(start.at("first_surface"), measure("energy", "puppet", {"--time", "0"}).at("first_surface"));
    EXPECT_NE(start.at("first_surface"), later.at("first_surface")) << "the lantern swings";
    const json rest = measure("energy", "puppet", {"--time", "0.6", "--animation", "none"});
    EXPECT_NE(rest.at("first_surface"), later.at("first_surface"));
    expect_refused({"energy", asset("puppet"), "--animation", "fly"}, "found no animation 'fly'");
}

TEST(MeasureCommand, OneMapCoversLessThanEight) {
    const json one = measure("coverage", "cornell", {"--set", "gi.emc.count=1", "--points", "3000"});
    const json eight = measure("coverage", "cornell", {"--points", "3000"});
    EXPECT_EQ(one.at("maps").size(), 1u);
    EXPECT_EQ(one.at("coverage"), one.at("maps").at(0).at("sees"));
    EXPECT_LT(one.at("coverage").get<double>(), eight.at("coverage").get<double>() - 0.03);
    EXPECT_GT(eight.at("coverage"), 0.98);
    for (const json& chosen : {one, eight}) {
        const json& random = chosen.at("random");
        EXPECT_LT(random.at("mean"), chosen.at("coverage"));
        EXPECT_LE(random.at("least"), random.at("mean"));
        EXPECT_LE(random.at("mean"), random.at("most"));
    }
    EXPECT_LT(eight.at("reached_m2"), eight.at("area_m2"));
}

// A closed sphere of albedo 0.5 around 100 cd: each step absorbs half of what comes in, nothing is lost.
TEST(MeasureCommand, AClosedSphereHalvesTheFluxAtEachStep) {
    const json energy = measure("energy", "furnace-sphere", {"--set", "gi.bounces=3"});
    const double emitted = 400 * 3.14159265;
    EXPECT_NEAR(energy.at("emitted").at(0), emitted, 1e-3 * emitted);
    EXPECT_NEAR(energy.at("first_surface").at("reflected").at(0), emitted / 2, 0.01 * emitted);
    double incoming = emitted / 2;
    ASSERT_EQ(energy.at("bounces").size(), 3u);
    for (const json& b : energy.at("bounces")) {
        EXPECT_NEAR(b.at("incoming").at(1), incoming, 0.02 * incoming);
        EXPECT_NEAR(b.at("stored_exact").at(1), b.at("incoming").at(1), 0.02 * incoming)
            << "a percent starts behind the sphere's next facet";
        EXPECT_NEAR(b.at("reflected").at(1).get<double>(), b.at("stored").at(1).get<double>() / 2,
                    0.002 * incoming);
        incoming /= 2;
    }
}

TEST(MeasureCommand, OpenScenesLoseLightForGood) {
    const json energy = measure("energy", "cornell");
    const json& first = energy.at("first_surface");
    EXPECT_GT(first.at("lost").at(0), 0.1 * energy.at("emitted").at(0).get<double>());
    const json& bounce = energy.at("bounces").at(0);
    EXPECT_NEAR(bounce.at("incoming").at(0), first.at("reflected").at(0), 1e-6);
    EXPECT_GT(bounce.at("lost_true").at(0), 0.9 * bounce.at("lost").at(0).get<double>());
}

TEST(MeasureCommand, FlickerIsRelativeToTheReferencesOwnChange) {
    // Measured: 2.929 and 1.740; with GALLIUM_OVERRIDE_CPU_CAPS=sse4.1 2.938 and 1.739.
    for (const auto& [motion, ceiling] : {std::pair("light", 3.1), std::pair("pan", 1.85)}) {
        const json flicker = measure("flicker", "two-rooms",
                                     {"--motion", motion, "--size", "48x32", "--frames", "2", "--warmup", "1",
                                      "--spp", "128", "--step", "0.01", "--set", "gi.emc.final=splat"});
        ASSERT_TRUE(flicker.at("reference_change").is_number()) << motion;
        EXPECT_EQ(flicker.at("by_frame").size(), 2u);
        EXPECT_NEAR(flicker.at("flicker").get<double>(),
                    flicker.at("change").get<double>() / flicker.at("reference_change").get<double>(), 1e-9);
        EXPECT_GT(flicker.at("flicker"), 0.5) << motion;
        EXPECT_LT(flicker.at("flicker"), ceiling) << motion;
    }
}

TEST(MeasureCommand, TheReferencesChangeGrowsWithTheStep) {
    double changes[2];
    for (int i = 0; i < 2; ++i) {
        const json flicker = measure("flicker", "two-rooms",
                                     {"--set", "gi.technique=none", "--size", "48x32", "--frames", "2",
                                      "--warmup", "0", "--spp", "128", "--step", i == 0 ? "0.01" : "0.02"});
        EXPECT_EQ(flicker.at("flicker"), 0) << "no indirect light, no flicker";
        changes[i] = flicker.at("reference_change");
    }
    EXPECT_NEAR(changes[1] / changes[0], 2, 0.5);
}

TEST(MeasureCommand, TablesAreForPeople) {
    const Outcome result = run({"hits", asset("cornell"), "--set", "gi.photons=500"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("agreement"), std::string::npos);
    EXPECT_NE(result.out.find("too near"), std::string::npos);
}

// Jozwowski 2002, Table 1: by the costs that were measured, shooting takes as long as balancing, to a photon.
TEST(MeasureCommand, PhotonsAreThoseThatAFrameHasTimeFor) {
    const Outcome result =
        run({"photons", asset("cornell"), "--json", "--size", "32x32", "--frames", "3", "--frame-ms", "200"});
    ASSERT_EQ(result.code, 0) << result.err;
    const json root = json::parse(result.out);
    const json &chosen = root.at("chosen"), &found = root.at("found");
    ASSERT_EQ(root.at("measured").size(), 3u);
    for (const json& frame : root.at("measured")) {
        for (const char* stage : {"shoot_ms", "balance_ms", "estimate_ms"}) {
            EXPECT_GT(frame.at(stage), 0) << stage;
        }
    }
    const int total = chosen.at("total"), per_frame = chosen.at("per_frame");
    EXPECT_GT(total, 100);
    EXPECT_GE(total, per_frame);
    EXPECT_LE(chosen.at("whole_ms"), 200);
    if (per_frame > 1) {
        EXPECT_LE(chosen.at("shoot_ms"), chosen.at("balance_ms"));
    }
    if (per_frame > 100 && per_frame < total) {
        EXPECT_GT(chosen.at("shoot_ms").get<double>(), 0.98 * chosen.at("balance_ms").get<double>());
    }
    EXPECT_EQ(found.at("total"), total);
    EXPECT_GT(found.at("whole_ms"), 0);
    EXPECT_EQ(root.at("frames_until_new"), (total + per_frame - 1) / per_frame);
    expect_refused({"photons", asset("cornell"), "--frame-ms", "0"}, "--frame-ms");
    expect_refused({"photons", asset("cornell"), "--size", "32x32", "--frames", "1", "--frame-ms", "0.001"},
                   "expected at least");
}

TEST(MeasureCommand, BadInputIsOneLine) {
    expect_refused(
        {},
        "expected hits, coverage, flicker, energy, effects, motions, frames, costs, estimate, budget, "
        "photons, plan, why or contracts");
    expect_refused({"beauty", asset("cornell")}, "beauty");
    expect_refused({"coverage", "none.glb"}, "none.glb");
    expect_refused({"hits", asset("cornell"), "--preset", "best"}, "low, medium, high, ultra");
    expect_refused({"energy", asset("cornell"), "--set", "gi.technique=none"}, "gi.technique: found 'none'");
    expect_refused({"flicker", asset("cornell"), "--size", "5"}, "--size");
    expect_refused({"flicker", asset("cornell"), "--camera", "sky"}, "sky");
}

// The figures of `motions` from the pictures that it was made of: the references that it keeps, and a picture
// by `render` of what the last frame shows.
TEST(MeasureCommand, MotionsAreComparedWithTheReferencesTheyKeep) {
    const testing_tools::TemporaryFolder folder;
    const Outcome outcome = run({"motions",
                                 asset("cornell"),
                                 "--json",
                                 "--size",
                                 "40x40",
                                 "--frames",
                                 "6",
                                 "--spp",
                                 "8",
                                 "--motion",
                                 "rest,walk,lamp",
                                 "--references",
                                 folder.path("references"),
                                 "--set",
                                 "gi.emc.final=splat",
                                 "--set",
                                 "gi.photons=4000",
                                 "--set",
                                 "gi.emc.candidates=16",
                                 "--case",
                                 "gi.technique=none",
                                 "--case",
                                 "gi.technique=emc"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const json root = json::parse(outcome.out);
    EXPECT_EQ(root.at("references_traced"), 3) << "the last moment of all, one more of the lamp and the walk";
    const auto files = testing_tools::files_in(folder.path("references"));
    ASSERT_EQ(files.size(), 6u);
    const auto figures = [&](int one, const char* motion) {
        return root.at("scenes").at(0).at("cases").at(one).at("motions").at(motion);
    };
    const double mean = figures(0, "rest").at("reference_mean");

    // Without indirect light the error is the light itself, of which the two halves are independent
    // estimates.
    ASSERT_EQ(
        testing_tools::run_program(
            LANTHORN_BINARY, {"render", asset("cornell"), "-o", folder.path("picture.exr"), "--aov",
                              "indirect", "--aov", "depth", "--size", "40x40", "--set", "gi.emc.final=splat",
                              "--set", "gi.photons=4000", "--set", "gi.emc.candidates=16"})
            .code,
        0);
    const ImageF picture = read_image(folder.path("picture-indirect.exr"));
    const ImageF depth = read_image(folder.path("picture-depth.exr"));
    double black = -1, emc = -1, closest = 1e9;
    for (std::size_t f = 0; f + 1 < files.size(); f += 2) {
        const ImageF a = read_image(folder.path("references/" + files[f]));
        const ImageF b = read_image(folder.path("references/" + files[f + 1]));
        double sum = 0, products = 0, errors = 0, pixels = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            if (depth.pixels[i / 3] == 0) {
                continue;
            }
            sum += 0.5 * (static_cast<double>(a.pixels[i]) + b.pixels[i]);
            products += static_cast<double>(a.pixels[i]) * b.pixels[i];
            errors +=
                (static_cast<double>(picture.pixels[i]) - a.pixels[i]) * (picture.pixels[i] - b.pixels[i]);
            ++pixels;
        }
        if (std::abs(sum / pixels - mean) < closest) {  // the one that shows the last moment
            closest = std::abs(sum / pixels - mean);
            black = std::sqrt(products / pixels) / (sum / pixels);
            emc = std::sqrt(errors / pixels) / (sum / pixels);
        }
    }
    EXPECT_NEAR(closest, 0, 1e-4 * mean);
    for (const char* motion : {"rest", "walk", "lamp"}) {
        EXPECT_NEAR(figures(0, motion).at("relrmse"), black, 1e-3 * black) << motion;
        EXPECT_EQ(figures(0, motion).at("flux"), 0) << motion;
        EXPECT_GT(figures(0, motion).at("unlit"), 10) << motion;
        EXPECT_EQ(figures(0, motion).at("nan_count"), 0) << motion;
        EXPECT_LT(figures(1, motion).at("relrmse"), 0.5 * black) << motion;
    }
    // Each pass without those within it: together no more than the whole.
    const json passes = figures(1, "lamp").at("gi_passes");
    double sum = 0;
    for (const auto& [name, pass] : passes.items()) {
        EXPECT_GE(pass.at("ms"), 0) << name;
        sum += pass.at("ms").get<double>();
    }
    EXPECT_GT(passes.at("bounces").at("ms"), 0);
    EXPECT_GT(passes.at("splats").at("cpu_ms"), 0);
    EXPECT_NEAR(sum, figures(1, "lamp").at("gi_ms"), 0.3 * sum) << "sums of medians and medians of sums";
    EXPECT_EQ(figures(0, "walk").at("change_of_mean"), 0);
    EXPECT_EQ(figures(0, "lamp").at("flicker"), 0) << "nothing changes, where the reference does";
    EXPECT_NEAR(figures(1, "rest").at("relrmse"), emc, 1e-3 * emc) << "the same picture as render's";
    EXPECT_EQ(figures(1, "rest").at("by_frame").size(), 7u);
    EXPECT_EQ(figures(1, "rest").at("worst_rise"), 1) << "nothing is done while nothing moves";
    EXPECT_GT(figures(1, "walk").at("change_of_mean"), 0.001);
    EXPECT_GT(figures(1, "lamp").at("gi_ms"), figures(1, "rest").at("gi_ms"));

    const Outcome again =
        run({"motions", asset("cornell"), "--json", "--size", "40x40", "--frames", "6", "--spp", "8",
             "--motion", "lamp", "--references", folder.path("references"), "--case", "gi.technique=none"});
    EXPECT_EQ(json::parse(again.out).at("references_traced"), 0);
}

TEST(MeasureCommand, MotionsRefuseWhatIsWrongBeforeTheyBegin) {
    const std::string scene = asset("cornell");
    expect_refused({"motions", scene, asset("nowhere")}, "nowhere.glb");
    expect_refused({"motions", scene + "@roof"}, "roof");
    expect_refused({"motions", scene, "--case", "gi.photos=1"}, "gi.photos");
    expect_refused({"motions", scene, "--case", "preset=best"}, "best");
    expect_refused({"motions", scene, "--motion", "jump"}, "jump");
    expect_refused({"motions", scene, "--frames", "3"}, "--frames");
    expect_refused({"motions", scene, "--size", "12"}, "--size");
    expect_refused({"motions", scene, "--references", "/dev/null/here"}, "/dev/null/here");
    expect_refused({"motions"}, "SCENE");
}

}  // namespace measure_command_test
}  // namespace lanthorn
