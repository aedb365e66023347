// lanthorn edit --script, as a person runs it.
#include <gtest/gtest.h>

#include <fstream>

#include "lanthorn/replay/recording.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using testing_tools::Outcome;
using Words = std::vector<std::string>;

class Script : public testing::Test {
  protected:
    Outcome run(const std::string& text, const Words& more = {}) {
        std::ofstream(folder.path("a.edits"), std::ios::binary) << text;
        Words all{"edit", "--script", folder.path("a.edits")};
        all.insert(all.end(), more.begin(), more.end());
        return testing_tools::run_program(LANTHORN_BINARY, all);
    }
    // The line of standard error, without the folder.
    std::string told(const Outcome& outcome) const {
        std::string text = outcome.err;
        for (std::size_t at; (at = text.find(folder.path() + '/')) != std::string::npos;) {
            text.erase(at, folder.path().size() + 1);
        }
        return text;
    }
    testing_tools::TemporaryFolder folder;
};

// docs/editor.md shows it.
TEST_F(Script, OfTheGuideHolds) {
    const Outcome outcome = testing_tools::run_program(
        LANTHORN_BINARY,
        {"edit", "--preset", "low", "--script", support::repository_file("docs/editor/first-minute.edits"),
         support::repository_file("assets/levels/red-wall.glb")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("= game"), std::string::npos) << outcome.out;
}

TEST_F(Script, OfTheWishesHolds) {
    const Outcome outcome = testing_tools::run_program(
        LANTHORN_BINARY, {"edit", "--script", support::repository_file("docs/editor/wishes.edits")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("/study: asked 60 lx, has "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("3 of 3 wishes met"), std::string::npos) << outcome.out;
    const Outcome wrong = run("new-room\nwish 1,2 60\n");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(told(wrong),
              "lanthorn: a.edits:2: wish: found 2 numbers in '1,2', expected a path, X,Y,Z in metres, or "
              "X,Y,Z,NX,NY,NZ\n");
    EXPECT_EQ(run("new-room\nwish 0,0,0 60\nexpect wishes met\n").code, 1);
}

// The beginning of a level's recording wakes none of its crystals: which, and how many lux are missing.
TEST_F(Script, SaysWhetherTheLevelIsStillSolvable) {
    const std::string level = support::repository_file("assets/levels/red-wall.glb");
    replay::Recording recording =
        replay::read_recording(support::repository_file("tests/replay/red-wall.rec"));
    recording.annotations = {};
    recording.steps.resize(30);
    replay::write_recording(folder.path("short.rec"), recording);
    const Outcome outcome = run("expect solvable " + folder.path("short.rec") + "\n", {level});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("a.edits:1: not solved: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(" lx"), std::string::npos) << outcome.err;
    EXPECT_EQ(run("print solvable " + folder.path("none.rec") + "\n", {level}).code, 2);
    EXPECT_EQ(run("new-room\nprint solvable\n").code, 2);
}

// Two techniques in one picture, each with its time.
TEST_F(Script, ComparesTwoWaysToDraw) {
    const std::string picture = folder.path("two.png");
    const Outcome outcome = run("new-room\ncompare " + picture + " none emc/low 64x36 2\ncompare " + picture +
                                " emc emc 64x36 2\n");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("A: none, "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("B: emc low, "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("A has no indirect light"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("relRMSE 0.000, flux 1.000"), std::string::npos) << outcome.out;
    EXPECT_TRUE(std::filesystem::exists(picture));
    for (const char* wrong : {"nothing emc", "emc/fine emc", "emc"}) {
        const Outcome bad = run("new-room\ncompare " + folder.path("no.png") + " " + wrong + "\n");
        EXPECT_EQ(bad.code, 2) << wrong;
        EXPECT_EQ(bad.error_lines(), 1) << bad.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("no.png")));
}

// The path tracer's samples line by line, and back to the technique before it; the same lines twice.
TEST_F(Script, TracesAPictureAndLeavesIt) {
    const std::string text =
        "new-room\ntechnique path\nexpect technique path\ntrace 64x36 3\nexpect progress 3 64\n"
        "print progress 500\ntrace 64x36\nexpect progress 4 64\nmove /room/lamp 0 1 0\ntrace 64x36 2\n"
        "expect progress 2 64\ntechnique back\nexpect technique emc\nprint progress\n";
    const Outcome outcome = run(text);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "3 of 64 samples\n3 of 64 samples, 31 s left\n4 of 64 samples\n2 of 64 samples\nnothing is "
              "traced\n");
    EXPECT_EQ(run(text).out, outcome.out);
    const Outcome all = run("new-room\ntechnique path\ntrace 16x9 70\nprint progress 500\n");
    EXPECT_EQ(all.out, "64 of 64 samples\n64 of 64 samples\n") << all.err;
    EXPECT_EQ(run("new-room\ntechnique path\ntrace 64x36\nexpect progress 2 64\n").code, 1);
    for (const char* wrong : {"trace 64x36", "technique nothing", "technique back", "technique"}) {
        const Outcome bad = run(std::string("new-room\n") + wrong + "\n");
        EXPECT_EQ(bad.code, 2) << wrong;
        EXPECT_EQ(bad.error_lines(), 1) << bad.err;
    }
}

// A level as a recorded session leaves it: one step, seen by the player's eyes.
TEST_F(Script, BeginsInTheStateOfARecording) {
    const std::string level = support::repository_file("assets/levels/shutter.glb");
    const std::string recording = support::repository_file("tests/replay/shutter.rec");
    const Outcome outcome =
        run("expect steps 1\nexpect dirty\nprint history\nprint render-line\nundo\nexpect clean\n",
            {level, "--at", recording + ":300"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("as after step 300 of shutter.rec"), std::string::npos) << outcome.out;
    const Outcome begin = run("expect steps 0\nprint render-line\n", {level, "--at", recording + ":0"});
    EXPECT_EQ(begin.code, 0) << begin.err;
    const auto pose = [](const Outcome& of) {
        const std::size_t at = of.out.find("--pose=");
        return of.out.substr(at, of.out.find(' ', at) - at);
    };
    EXPECT_NE(pose(begin), pose(outcome));
    for (const std::string& at : {recording + ":99999999", recording, recording + ":x", level + ":3"}) {
        const Outcome wrong = run("expect steps 0\n", {level, "--at", at});
        EXPECT_EQ(wrong.code, 2) << at;
        EXPECT_EQ(wrong.error_lines(), 1) << wrong.err;
    }
    EXPECT_EQ(run("new-room\n", {"--at", recording + ":3"}).code, 2);
    EXPECT_EQ(run("expect steps 0\n",
                  {support::repository_file("assets/levels/red-wall.glb"), "--at", recording + ":3"})
                  .code,
              2);
}

TEST_F(Script, ABadLineIsNamedAndEndsWith2) {
    const Outcome wrong = run("new-room\n\nmove /room/lamp 1 2\n");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(told(wrong), "lanthorn: a.edits:3: move: found 3 words behind it, expected move PATH X Y Z\n");
    EXPECT_EQ(run("open nothing.glb\n").code, 2);
    EXPECT_EQ(run("begin drag\nnew-room\n").code, 2);
    EXPECT_EQ(run("new-room\nbegin drag\nmove /room/lamp 1 2 3\n").code, 2);
    EXPECT_EQ(run("move /a 1 2 3\n").code, 2);
    EXPECT_EQ(run("expect nonsense 1\n").code, 2);
    const Outcome none =
        testing_tools::run_program(LANTHORN_BINARY, {"edit", "--script", folder.path("no.edits")});
    EXPECT_EQ(none.code, 2);
}

TEST_F(Script, AnExpectationThatIsNotMetEndsWith1) {
    const Outcome outcome =
        run("new-room\nexpect /room/lamp light.intensity 80\nexpect /room/lamp translation [1,2,3]\n");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(told(outcome), "lanthorn: a.edits:3: /room/lamp translation is [0,2.4,0], expected [1,2,3]\n");
    EXPECT_EQ(run("new-room\nexpect hash 0\n").code, 1);
    EXPECT_EQ(run("new-room\nexpect gone /room\n").code, 1);
    EXPECT_EQ(run("new-room\nexpect warning watts\n").code, 1);
}

// What a point's light is made of, how wrong the picture is, and the page that says it all.
TEST_F(Script, TellsWhyAndHowWrongAndWritesAReview) {
    const Outcome outcome =
        run("new-room\nset /room/lamp light.intensity 150\nadd-node / study 0 0 0\n"
            "set /study light_contract.lower 2\nprint why 48,50 96x64\nprint error 96x64 2\nreview " +
                folder.path("page.html") + " 96x64 2\nexpect steps 3\n",
            {"--preset", "low"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("floor at 48,50"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("lamp "), std::string::npos);
    EXPECT_NE(outcome.out.find("reflected by "), std::string::npos);
    EXPECT_NE(outcome.out.find("\nerror "), std::string::npos);
    const std::string page = testing_tools::file_bytes(folder.path("page.html"));
    std::size_t pictures = 0;
    for (std::size_t at = 0; (at = page.find("src='data:image/png;base64,", at)) != std::string::npos; ++at) {
        ++pictures;
    }
    EXPECT_EQ(pictures, 6u);  // final, lux and error, before and after
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_NE(page.find("study: "), std::string::npos);
    EXPECT_NE(page.find("<li>set lamp light.intensity"), std::string::npos)
        << page.substr(page.size() - 3000);
    const Outcome sky = run("new-room\nprint why 5000,2\n");
    EXPECT_EQ(sky.code, 2);
    EXPECT_EQ(told(sky), "lanthorn: a.edits:2: found '5000', expected a column from 0 to 639\n");
}

}  // namespace
}  // namespace lanthorn
