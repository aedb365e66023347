// The real `lanthorn bench`: the paper's counts, by scene and share, and what it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/tools/refused.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using nlohmann::json;
using testing_tools::Outcome;

Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    return testing_tools::run_program(LANTHORN_BINARY, arguments);
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
    testing_tools::expect_refusal(run(arguments), part, arguments);
}

const std::vector<std::string> kSmall = {"paper",
                                         "--scene",
                                         "diffuse-box",
                                         "--size",
                                         "64x48",
                                         "--warmup",
                                         "1",
                                         "--frames",
                                         "2",
                                         "--photons-share",
                                         "1/100",
                                         "--set",
                                         "gi.emc.candidates=16"};

TEST(BenchCommand, MeasuresThePapersCountsByShare) {
    std::vector<std::string> arguments = kSmall;
    arguments.emplace_back("--json");
    const Outcome result = run(arguments);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "no progress bar in a pipe";
    const json root = json::parse(result.out);
    EXPECT_EQ(root.at("rows").size(), 1u);
    const json& row = root.at("rows").at(0);
    EXPECT_EQ(row.at("scene"), "diffuse-box");
    EXPECT_EQ(row.at("photons"), 3760);
    EXPECT_EQ(row.at("caustic_photons"), 0);
    EXPECT_EQ(row.at("bounces"), 3);
    ASSERT_EQ(row.at("runs").size(), 2u);
    const json &splat = row.at("runs").at(0), &gather = row.at("runs").at(1);
    EXPECT_EQ(splat.at("final"), "splat");
    EXPECT_EQ(gather.at("final"), "gather");
    EXPECT_NEAR(splat.at("photons_emitted").get<double>(), 3760, 40) << "rounded by lamp";
    EXPECT_TRUE(splat.at("paper_fps").is_null()) << "the paper has no such size";
    for (const json& one : row.at("runs")) {
        EXPECT_GT(one.at("frame_ms"), one.at("gi_ms"));
        EXPECT_NEAR(one.at("fps").get<double>() * one.at("frame_ms").get<double>(), 1000, 1e-6);
        EXPECT_EQ(one.at("nan_count"), 0);
    }
    EXPECT_GT(splat.at("gi_passes").at("bounces"), 0) << "photons are traced in every frame";
    EXPECT_GT(splat.at("gi_passes").at("splats"), 0);
}

TEST(BenchCommand, TablesAreForPeople) {
    std::vector<std::string> arguments = kSmall;
    arguments.insert(arguments.end(), {"--final", "splat"});
    const Outcome result = run(arguments);
    ASSERT_EQ(result.code, 0) << result.err;
    for (const char* part : {"diffuse-box, Fig. 1 (a)", "paper fps", "our fps", "pass, ms", "bounces"}) {
        EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
    }
    EXPECT_EQ(result.out.find("gather"), std::string::npos);
}

TEST(BenchCommand, BadInputIsOneLine) {
    expect_refused({}, "expected paper");
    expect_refused({"speed"}, "speed");
    expect_refused({"paper", "--scene", "attic"}, "found no scene 'attic', expected some of diffuse-box");
    expect_refused({"paper", "--photons-share", "2"}, "--photons-share: found '2'");
    expect_refused({"paper", "--photons-share", "1/0"}, "--photons-share");
    expect_refused({"paper", "--photons-share", "half"}, "--photons-share");
    expect_refused({"paper", "--size", "big"}, "--size");
    expect_refused({"paper", "--final", "paint"}, "paint");
    expect_refused({"paper", "--frames", "0"}, "--frames");
    expect_refused({"paper", "--set", "gi.photos=1"}, "gi.photos");
}

}  // namespace
}  // namespace lanthorn
