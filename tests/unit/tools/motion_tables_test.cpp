// What `lanthorn inspect` says of what moves, and which moment of it `lanthorn render` shows.
#include "tools/lanthorn/common/motion_tables.h"

#include <gtest/gtest.h>

#include "lanthorn/workbench/render_job.h"
#include "tests/support/sliding_node.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {
namespace {

TEST(RenderJob, TheLastFrameShowsTheTimeAndThoseBeforeLeadUpToIt) {
    RenderJob job;
    job.frames = 30;
    EXPECT_DOUBLE_EQ(shown_time(job), 0.5);
    EXPECT_DOUBLE_EQ(shown_time(job, 29), 1.0 / 60);
    EXPECT_EQ(shown_time(job, 40), 0);  // warm-up before the start
    job.view.time = 2;
    EXPECT_EQ(shown_time(job), 2);
    EXPECT_DOUBLE_EQ(shown_time(job, 6), 1.9);
}

TEST(MotionTables, SayWhatMoves) {
    SceneData s = support::sliding_node();
    s.animations[1].channels[0].path = AnimationPath::rotation;
    s.animations[1].channels.push_back(s.animations[0].channels[0]);
    s.skins = {{"rig", {0, 1}, {mat4(1), mat4(1)}}};
    EXPECT_EQ(animation_table(s).text(),
              "  #  name  seconds  channels  nodes  moves\n"
              "  0  east  2.000    1         1      translation\n"
              "  1  up    2.000    2         1      translation, rotation\n");
    EXPECT_EQ(skin_table(s).text(), "  #  name  joints\n  0  rig   2\n");
    Mesh mesh;
    EXPECT_EQ(deformation_text(mesh), "-");
    mesh.skin.resize(2);
    mesh.skin[0].weights = {0.5f, 0.3f, 0.2f};
    mesh.skin[1].weights = {1};
    mesh.morphs.resize(4);
    mesh.cage = SubdivisionCage{};
    mesh.cage->level = 3;
    EXPECT_EQ(deformation_text(mesh), "skin of up to 3 joints, 4 morph targets, catmull-clark to level 3");
}

}  // namespace
}  // namespace lanthorn::tools
