// Contracts of light: against light that is known on paper, and as the command line checks a file.
#include "tools/workbench/measure/light_contracts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::workbench {
namespace {

using support::lambertian;
using support::point_light;
using support::quad;
using testing_tools::Outcome;

// A black floor of 40 x 40 m with a lamp of 90 cd 2 m above the origin: E = I h / (h^2 + r^2)^(3/2).
FrameScene lit_floor() {
    return support::scene_of({quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0)}, {lambertian(vec3(0))},
                             {point_light({0, 2, 0}, 90)}, vec3(0, 1, 3), vec3(0));
}
double expected(double r) {
    return 90 * 2 / std::pow(4 + r * r, 1.5);
}

PlacedContract box(const vec3& at, const vec3& size, float lower, float upper) {
    PlacedContract contract;
    contract.name = "box";
    contract.asked = {lower, upper, size, 0.95f};
    mat4 from(1);
    for (int axis = 0; axis < 3; ++axis) {
        from[axis] *= size[axis];
    }
    from[3] = vec4(at, 1);
    contract.from_box = from;
    contract.to_box = glm::inverse(from);
    return contract;
}

TEST(LightContract, OfABoxIsOfTheSurfacesWithin) {
    const FrameScene scene = lit_floor();
    const reference::LightSplitter light(scene, {});
    const ContractVerdict small = check_contract(box({1.5f, 0, 0}, vec3(0.1f), 5, 20), light, {64, 16});
    EXPECT_EQ(small.places, 64);
    EXPECT_NEAR(small.mean, expected(1.5), 0.02 * expected(1.5));
    EXPECT_EQ(small.within, 1);
    EXPECT_TRUE(small.kept);
    // A metre wide on each side: a share that the closed form says, the radius where it is 10 lx.
    const ContractVerdict wide = check_contract(box({0, 0, 0}, {6, 1, 0.02f}, 10, 0), light, {4000, 16});
    const double radius = std::sqrt(std::pow(90 * 2 / 10.0, 2.0 / 3) - 4);
    EXPECT_NEAR(wide.within, radius / 3, 0.01);
    EXPECT_NEAR(wide.less, 1 - radius / 3, 0.01);
    EXPECT_FALSE(wide.kept);
    EXPECT_NE(contract_words(wide).find("broken"), std::string::npos);
    EXPECT_NE(contract_words(wide).find("darker"), std::string::npos);
    const ContractVerdict nothing = check_contract(box({0, 5, 0}, vec3(1), 1, 0), light, {64, 16});
    EXPECT_EQ(nothing.places, 0);
    EXPECT_FALSE(nothing.kept);
    EXPECT_EQ(contract_words(nothing), "box: no surface is there, expected 1.00 lx or more");
}

TEST(LightContract, OfASensorIsWhatItReads) {
    const FrameScene scene = lit_floor();
    const reference::LightSplitter light(scene, {});
    PlacedContract contract;
    contract.name = "crystal";
    contract.sensor = true;
    contract.position = vec3(1, 0, 0);
    contract.direction = vec3(0, 1, 0);
    contract.radius = 0.1f;
    contract.filter = vec3(1, 0, -0.5f);  // half of what white light gives
    const double reads = 0.5 * expected(1);
    contract.asked.lower = static_cast<float>(0.8 * reads);
    ContractVerdict verdict = check_contract(contract, light, {256, 16});
    EXPECT_NEAR(verdict.mean, reads, 0.01 * reads);
    EXPECT_TRUE(verdict.kept);
    EXPECT_NE(contract_words(verdict).find("margin +25 %"), std::string::npos) << contract_words(verdict);
    contract.asked.lower = static_cast<float>(1.1 * reads);
    verdict = check_contract(contract, light, {256, 16});
    EXPECT_FALSE(verdict.kept);
}

class ContractCommand : public testing::Test {
  protected:
    // A room of the editor's with a contract at its middle.
    std::string room(const std::string& contract) {
        std::ofstream(folder.path("a.edits"))
            << "new-room\nadd-node / study 0 0 0\n"
            << (contract.empty() ? "" : "set /study extras.light_contract " + contract) << "\nsave "
            << folder.path("room.glb") << "\n";
        const Outcome made =
            testing_tools::run_program(LANTHORN_BINARY, {"edit", "--script", folder.path("a.edits")});
        EXPECT_EQ(made.code, 0) << made.err;
        return folder.path("room.glb");
    }
    static Outcome check(const std::string& file) {
        return testing_tools::run_program(
            LANTHORN_BINARY, {"measure", "contracts", file, "--json", "--places", "64", "--paths", "64"});
    }
    testing_tools::TemporaryFolder folder;
};

TEST_F(ContractCommand, EndsWith1WhereOneIsBroken) {
    const Outcome kept = check(room(R"({"lower":1,"upper":10000,"size":[2,0.5,2]})"));
    EXPECT_EQ(kept.code, 0) << kept.err;
    const nlohmann::json said = nlohmann::json::parse(kept.out);
    EXPECT_EQ(said["broken"], 0);
    EXPECT_EQ(said["contracts"][0]["name"], "study");
    EXPECT_EQ(said["contracts"][0]["places"], 64);
    EXPECT_GT(said["contracts"][0]["mean"], 1);
    const Outcome broken = check(room(R"({"lower":100000,"size":[2,0.5,2]})"));
    EXPECT_EQ(broken.code, 1) << broken.err;
    EXPECT_EQ(nlohmann::json::parse(broken.out)["broken"], 1);
    const Outcome none = check(room(""));
    EXPECT_EQ(none.code, 2);
    EXPECT_EQ(none.error_lines(), 1) << none.err;
}

}  // namespace
}  // namespace lanthorn::workbench
