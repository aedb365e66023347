// The frame as the schedule has it: the order that every program shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"

namespace lanthorn {
namespace {

struct Scheduled {
    Scheduled() {
        add_scene_plugins(app);
        app.add<RenderPlugin>().add<gi::GiPlugin>();
    }
    App app;
};

void expect_in_order(const std::vector<std::string>& order, const std::vector<std::string>& wanted) {
    auto at = order.begin();
    for (const std::string& name : wanted) {
        const auto found = std::find(at, order.end(), name);
        EXPECT_NE(found, order.end())
            << name << (std::ranges::count(order, name) > 0 ? " comes earlier" : " is not there");
        at = found == order.end() ? at : found;
    }
}

TEST(Schedules, AFrameIsTheDesignsSentence) {
    Scheduled s;
    const auto order = s.app.frame_schedule().order();
    expect_in_order(order, {"interpolate", "animation", "transforms", "morphs", "skinning", "subdivision",
                            "bounds", "extract", "gi.plan", "gi.update", "gi.indirect", "composite"});
    expect_in_order(order, {"transforms", "detail", "gi.detail", "skinning"});
    expect_in_order(order, {"extract", "upload", "light_maps", "gi.update"});
    expect_in_order(order, {"upload", "light_maps", "direct", "composite"});
    expect_in_order(order, {"upload", "gbuffer", "gi.indirect"});
}

TEST(Schedules, AStepAnimatesBeforeBodiesMove) {
    Scheduled s;
    expect_in_order(s.app.fixed_schedule().order(),
                    {"restore", "gameplay.end", "animation", "transforms", "physics", "settle", "remember"});
}

// Only what alters the world's make-up from outside systems runs alone: the ends of the phases.
TEST(Schedules, NoSystemOfTheEngineTakesTheWholeWorld) {
    Scheduled s;
    std::istringstream lines(s.app.schedule_dot());
    for (std::string line; std::getline(lines, line);) {
        if (line.find("style=bold") != std::string::npos) {
            EXPECT_TRUE(line.find(".begin\"") != std::string::npos ||
                        line.find(".end\"") != std::string::npos)
                << line;
        }
    }
}

TEST(Schedules, ArePrintedBoth) {
    Scheduled s;
    const std::string dot = s.app.schedule_dot();
    for (const char* text :
         {"digraph \"fixed\"", "digraph \"frame\"", " gi.update", " skinning", " physics"}) {
        EXPECT_NE(dot.find(text), std::string::npos) << text << "\n" << dot;
    }
}

}  // namespace
}  // namespace lanthorn
