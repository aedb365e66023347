#include "gi_module/techniques/emc/emc_ladder.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "lanthorn/gi/gi_plugin.h"

namespace lanthorn::gi {
namespace emc_ladder_test {

double time_of(const BudgetLadder& ladder, const BudgetRung& rung) {
    double time = 0;
    for (std::size_t g = 0; g < kCostGroups; ++g) {
        time += ladder.shares[g] * rung.cost[g];
    }
    return time;
}

TEST(EmcLadder, EachRungIsCheaperAndWorseThanTheOneBefore) {
    SettingsSchema schema;
    declare_settings(schema);
    for (const char* preset : {"low", "medium", "high", "ultra"}) {
        for (const ivec2 size : {ivec2(64), ivec2(256), ivec2(640, 360), ivec2(3840, 2160)}) {
            Settings settings(schema);
            settings.apply_preset(preset);
            const BudgetLadder ladder = quality_ladder(settings, size, true);
            ASSERT_GT(ladder.rungs.size(), 8u) << preset;
            EXPECT_TRUE(ladder.rungs.front().set.empty());
            EXPECT_NEAR(std::accumulate(ladder.shares.begin(), ladder.shares.end(), 0.0), 1, 1e-9);
            for (std::size_t i = 1; i < ladder.rungs.size(); ++i) {
                const BudgetRung &before = ladder.rungs[i - 1], &rung = ladder.rungs[i];
                EXPECT_LT(time_of(ladder, rung), time_of(ladder, before)) << preset << ' ' << rung.name;
                EXPECT_GE(rung.error, before.error) << preset << ' ' << rung.name;
                EXPECT_LE(rung.scale, before.scale) << preset << ' ' << rung.name;
                Settings lowered = settings;
                for (const std::string& assignment : rung.set) {
                    EXPECT_NO_THROW(lowered.set_from_text(assignment)) << assignment;
                }
            }
            EXPECT_LT(ladder.rungs.back().scale, 0.4);
        }
    }
}

TEST(EmcLadder, PixelsAreSparedLastAndOnlyWhereTheyMay) {
    SettingsSchema schema;
    declare_settings(schema);
    const Settings settings(schema);
    for (const BudgetRung& rung : quality_ladder(settings, ivec2(512), false).rungs) {
        EXPECT_EQ(rung.scale, 1);
    }
}

TEST(EmcLadder, SplatsAndOtherTechniquesSpareLampsMapsAndThenPixels) {
    SettingsSchema schema;
    declare_settings(schema);
    for (const char* chosen : {"gi.emc.final=splat", "gi.technique=none"}) {
        Settings settings(schema);
        settings.set_from_text(chosen);
        const BudgetLadder ladder = quality_ladder(settings, ivec2(256, 144), false);
        ASSERT_EQ(ladder.rungs.size(), 5u) << chosen;  // 512, 384, 256, 192, 128
        EXPECT_EQ(ladder.rungs.back().set.front(), "render.shadow.resolution=128") << chosen;
        EXPECT_NEAR(ladder.rungs.back().cost[static_cast<std::size_t>(CostGroup::shadows)], 1.0 / 16, 1e-12);
        const BudgetLadder smaller = quality_ladder(settings, ivec2(256, 144), true);
        ASSERT_GT(smaller.rungs.size(), 8u) << chosen;
        EXPECT_EQ(smaller.rungs.back().set, ladder.rungs.back().set) << chosen;
        EXPECT_LT(smaller.rungs.back().scale, 0.4) << chosen;
    }
}

// They are maps of lamps, too, and in the same passes.
TEST(EmcLadder, MapsOfEmissiveSurfacesShrinkWithThoseOfLamps) {
    SettingsSchema schema;
    declare_settings(schema);
    Settings settings(schema);
    settings.set_from_text("render.area_lights.resolution=200");
    const auto lowered = [&](const char* technique) {
        settings.set_from_text(std::string("gi.technique=") + technique);
        Settings result = settings;
        const BudgetLadder ladder = quality_ladder(settings, ivec2(144), false);
        for (const std::string& assignment : ladder.rungs.back().set) {
            result.set_from_text(assignment);
        }
        return result.get<int>("render.area_lights.resolution");
    };
    EXPECT_EQ(lowered("emc"), 50);
    EXPECT_EQ(lowered("none"), 50);
    settings.set_from_text("render.area_lights.resolution=64");
    EXPECT_EQ(lowered("emc"), 32);  // no fewer
    settings.set_from_text("render.area_lights.resolution=16");
    EXPECT_EQ(lowered("emc"), 16);
}

// Where a lamp's maps take most of a frame, as a carried lantern's do: they come before pixels, and no
// coarser than the picture can show.
TEST(EmcLadder, MapsOfLampsAreSparedBeforePixels) {
    SettingsSchema schema;
    declare_settings(schema);
    const Settings settings(schema);
    for (const ivec2 size : {ivec2(256, 144), ivec2(1280, 720)}) {
        const BudgetLadder ladder = quality_ladder(settings, size, true);
        constexpr auto kShadows = static_cast<std::size_t>(CostGroup::shadows);
        double least = 1;
        for (const BudgetRung& rung : ladder.rungs) {
            EXPECT_LE(rung.cost[kShadows], least) << rung.name;
            if (rung.scale < 1) {
                EXPECT_EQ(rung.cost[kShadows], least) << rung.name;
            }
            least = rung.cost[kShadows];
            Settings lowered = settings;
            for (const std::string& assignment : rung.set) {
                lowered.set_from_text(assignment);
            }
            const auto share = static_cast<double>(lowered.get<int>("render.shadow.resolution")) /
                               settings.get<int>("render.shadow.resolution");
            EXPECT_NEAR(rung.cost[kShadows], share * share, 1e-9) << rung.name;
        }
        EXPECT_DOUBLE_EQ(least, size.y < 384 ? 1.0 / 16 : 1.0 / 4) << size.y;
    }
}

TEST(GroupCosts, MapsOfLampsAreAGroup) {
    const std::vector<double> ms =
        group_costs(std::vector<gpu::PassTimer::Span>{{"light_maps", 0, 9, 12}}, 10, true);
    EXPECT_EQ(ms[static_cast<std::size_t>(CostGroup::shadows)], 12);
    EXPECT_EQ(ms[static_cast<std::size_t>(CostGroup::rest)], 0);
}

TEST(GroupCosts, APassWithinAnotherCountsOnce) {
    const std::vector<gpu::PassTimer::Span> passes = {{"gbuffer", 0, 5, 6},    {"lit_photons", 6, 3, 4},
                                                      {"lit_maps", 6, 10, 14}, {"gather_rays", 17, 4, 5},
                                                      {"gather", 17, 20, 30},  {"filter", 37, 2, 3}};
    const std::vector<double> ms = group_costs(passes, 50, false), cpu = group_costs(passes, 80, true);
    const auto of = [](const std::vector<double>& groups, CostGroup group) {
        return groups[static_cast<std::size_t>(group)];
    };
    EXPECT_EQ(of(ms, CostGroup::pixels), 5);
    EXPECT_EQ(of(ms, CostGroup::photons), 3);
    EXPECT_EQ(of(ms, CostGroup::lit_maps), 7);
    EXPECT_EQ(of(ms, CostGroup::gather), 20);
    EXPECT_EQ(of(ms, CostGroup::filter), 2);
    EXPECT_EQ(of(ms, CostGroup::rest), 13);
    EXPECT_EQ(of(cpu, CostGroup::lit_maps), 10);
    EXPECT_EQ(of(cpu, CostGroup::rest), 27);
    EXPECT_EQ(std::accumulate(ms.begin(), ms.end(), 0.0), 50);
}

}  // namespace emc_ladder_test
}  // namespace lanthorn::gi
