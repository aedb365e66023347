// Recordings judged, faults found and made small: the library of `lanthorn replay`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "game/rules/components.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "tests/support/repository.h"
#include "tools/lanthorn/replay/cause.h"
#include "tools/lanthorn/replay/expectations.h"
#include "tools/lanthorn/replay/heavy.h"
#include "tools/lanthorn/replay/judge.h"
#include "tools/lanthorn/replay/minimise.h"
#include "tools/lanthorn/replay/reduce_steps.h"
#include "tools/lanthorn/replay/seek.h"

namespace lanthorn::tools {
namespace {

std::string recording_file(const char* name = "pool") {
    return support::repository_file("tests/replay/" + std::string(name) + ".rec");
}

struct Opened {
    explicit Opened(const char* name = "pool")
        : file(recording_file(name)),
          recording(std::make_shared<replay::Recording>(replay::read_recording(file))),
          level(read_level(file, recording->header, "")) {}
    std::string file;
    std::shared_ptr<replay::Recording> recording;
    std::shared_ptr<const LevelFile> level;
};

// A fault: what is pushed comes a hair too far, once it has been pushed some way.
void plant(App& app) {
    app.fixed_schedule()
        .add("planted",
             [](ecs::Query<ecs::Write<game::Pushed>> pushed) {
                 pushed.each([](game::Pushed& one) {
                     if (one.share > 0.1 && one.share < 0.9) {
                         one.share += 1e-9;
                     }
                 });
             })
        .after("settle")
        .before("remember");
}

Check check_of(const Verdict& verdict, const std::string& name) {
    const auto found = std::ranges::find(verdict.checks, name, &Check::name);
    return found == verdict.checks.end() ? Check{} : *found;
}

TEST(Expectations, AreToldOfByTheStepsThatTheyName) {
    EXPECT_TRUE(is_told_within("solved before 100", 100));
    EXPECT_TRUE(is_told_within("green-pane pushed.share > 0.3 before 50", 100));
    for (const char* line :
         {"solved", "solved before 101", "solved after 50", "before 50", "solved before fifty"}) {
        EXPECT_FALSE(is_told_within(line, 100)) << line;
    }
}

TEST(ReplayJudge, FindsARecordingAsItWas) {
    const Verdict verdict = judge(recording_file());
    EXPECT_FALSE(verdict.failed()) << verdict_text(verdict);
    EXPECT_EQ(check_of(verdict, "live").verdict, Check::Verdict::ok);
    EXPECT_EQ(check_of(verdict, "state").verdict, Check::Verdict::ok);
    EXPECT_EQ(check_of(verdict, "sensors").verdict, Check::Verdict::none) << "nothing was drawn";
    EXPECT_GT(verdict.comparison.live, verdict.steps / 2);
    EXPECT_EQ(verdict.timeline.inputs.size(), verdict.timeline.parts.size());
    const auto ran =
        std::ranges::find(verdict.systems_ran, "physics", &std::pair<std::string, std::uint64_t>::first);
    ASSERT_NE(ran, verdict.systems_ran.end());
    EXPECT_EQ(ran->second, verdict.steps);
}

TEST(ReplayJudge, AFaultIsFoundAtItsStepAndPart) {
    JudgeChoice choice;
    choice.extend = plant;
    const Verdict verdict = judge(recording_file(), choice);
    EXPECT_TRUE(verdict.failed());
    ASSERT_FALSE(verdict.comparison.divergences.empty());
    EXPECT_EQ(verdict.comparison.divergences.front().parts, (std::vector<std::string>{"pushed"}));
    EXPECT_NE(check_of(verdict, "state").text.find("pushed differs"), std::string::npos);
}

TEST(ReplayJudge, WhatIsExpectedIsHeldAgainstWhatHappens) {
    Opened opened;
    const std::string file = testing::TempDir() + "expected.rec";
    const auto verdict_of = [&](const char* line) {
        opened.recording->annotations.expectations = {line};
        replay::write_recording(file, *opened.recording);
        return check_of(judge(file, {.level = opened.level->path}), "expectations").verdict;
    };
    EXPECT_EQ(verdict_of("solved"), Check::Verdict::ok);
    EXPECT_EQ(verdict_of("solved after 500"), Check::Verdict::ok);
    EXPECT_EQ(verdict_of("solved before 500"), Check::Verdict::failed);
    EXPECT_THROW(verdict_of("solved by step 500"), InputError);
    // Of entities by their declared fields.
    EXPECT_EQ(verdict_of("emerald crystal.awake before 1500"), Check::Verdict::ok);
    EXPECT_EQ(verdict_of("emerald crystal.awake before 300"), Check::Verdict::failed);
    EXPECT_EQ(verdict_of("green-pane pushed.share > 0.3 after 100"), Check::Verdict::ok);
    EXPECT_EQ(verdict_of("green-pane pushed.share > 2"), Check::Verdict::failed);
    EXPECT_EQ(verdict_of("ruby crystal.symbol = square"), Check::Verdict::failed);
    for (const char* line :
         {"event door.opened", "emerald crystal.open", "emerald door.open", "emerald crystal.charge",
          "emerald crystal.charge > much", "emerald crystal.symbol > 1", "emerald awake",
          "emerald crystal.awake by 300", "emerald crystal.awake before", ""}) {
        EXPECT_THROW(verdict_of(line), InputError) << line;
    }
    std::filesystem::remove(file);
}

TEST(ReplayJudge, ASessionInWhichNothingHappensProvesNothing) {
    Opened opened;
    opened.recording->steps.resize(1);
    const std::string file = testing::TempDir() + "short.rec";
    replay::write_recording(file, *opened.recording);
    EXPECT_EQ(check_of(judge(file, {.level = opened.level->path}), "live").verdict, Check::Verdict::failed);
    std::filesystem::remove(file);
}

TEST(ReplayCause, NamesSystemEntityFieldAndBothValues) {
    const Opened opened;
    const ReplayChoice here{.extend = plant};
    const auto reference = own_reference(*opened.level, {});
    const auto step = first_unequal(*opened.level, *opened.recording, here);
    ASSERT_TRUE(step);
    const auto cause = find_cause(*opened.level, *opened.recording, *step, here, *reference);
    ASSERT_TRUE(cause);
    EXPECT_EQ(cause->system, "planted");
    EXPECT_EQ(cause->parts, (std::vector<std::string>{"pushed"}));
    ASSERT_EQ(cause->fields.size(), 1u);
    EXPECT_EQ(cause->fields[0].name(), "pushed.share");
    EXPECT_NE(cause->fields[0].entity.find("v1)"), std::string::npos) << cause->fields[0].entity;
    EXPECT_EQ(cause->fields[0].sign, 1);
    EXPECT_GT(cause->fields[0].ulps, 1u);
}

TEST(ReplayCause, ThereIsNoneWhereNothingDiffers) {
    const Opened opened;
    EXPECT_FALSE(first_unequal(*opened.level, *opened.recording, {}));
    const auto reference = own_reference(*opened.level, {});
    EXPECT_FALSE(find_cause(*opened.level, *opened.recording, 10, {}, *reference));
}

TEST(ReplayMinimise, KeepsTheFaultAndLittleElse) {
    const Opened opened;
    const auto reference = own_reference(*opened.level, {});
    MinimiseChoice choice;
    choice.here.extend = plant;
    const Minimised minimised = minimise(*opened.level, *opened.recording, *reference, choice);
    EXPECT_LT(minimised.recording.steps.size(), 180u) << "3 s";
    EXPECT_LE(presses(minimised.recording.steps), 3u);
    EXPECT_EQ(minimised.cause.fields.at(0).name(), "pushed.share");
    // It is a test: red with the fault, green without it.
    EXPECT_EQ(first_unequal(*opened.level, minimised.recording, choice.here),
              minimised.recording.steps.size() - 1);
    EXPECT_FALSE(first_unequal(*opened.level, minimised.recording, {}));
}

// The recorded inputs, and then none for a while: long enough for key steps.
std::shared_ptr<replay::Recording> lengthened(const Opened& opened, std::size_t steps) {
    replay::Recording inputs = *opened.recording;
    inputs.steps.resize(steps);
    for (std::size_t i = opened.recording->steps.size(); i < steps; ++i) {
        inputs.steps[i].input.assign(inputs.header.input_size, std::byte{0});
    }
    return std::make_shared<replay::Recording>(played_again(*opened.level, inputs, {}));
}

TEST(ReplayHeavy, AStateIsAllThereIs) {
    for (const char* name : {"pool", "mirrors"}) {
        const Opened opened(name);
        const auto recording = lengthened(opened, 2000);
        const Check check = heavy_check(*opened.level, opened.file, recording, 101);
        EXPECT_EQ(check.verdict, Check::Verdict::ok) << name << ": " << check.text;
        EXPECT_NE(check.text.find("1 seeks to key steps"), std::string::npos) << check.text;
    }
}

// Two faults a minute apart are two findings: behind the first, the replay goes on from the recording's own
// state.
TEST(ReplayJudge, EveryFaultIsFoundWhereTheRecordingHasStates) {
    const Opened opened;
    const auto recording = lengthened(opened, 5000);
    recording->annotations.states = key_states(*opened.level, opened.file, recording, 1);
    ASSERT_EQ(recording->annotations.states.size(), 2u);
    const std::string file = testing::TempDir() + "two-faults.rec";
    replay::write_recording(file, *recording);
    JudgeChoice choice{.level = opened.level->path};
    choice.extend = [](App& app) {
        app.fixed_schedule()
            .add("planted",
                 [](ecs::Res<Time> time, ecs::Query<ecs::Write<game::Eyes>> eyes,
                    ecs::Query<ecs::Write<game::Pushed>> pushed) {
                     if (time->steps == 501) {
                         eyes.each([](game::Eyes& one) { one.pitch += 1e-9; });
                     }
                     if (time->steps == 4101) {
                         pushed.each([](game::Pushed& one) { one.share *= 0.999; });
                     }
                 })
            .after("settle")
            .before("remember");
    };
    const Verdict verdict = judge(file, choice);
    const auto& found = verdict.comparison.divergences;
    ASSERT_EQ(found.size(), 2u) << verdict_text(verdict);
    EXPECT_EQ(found[0].step, 500u);
    EXPECT_EQ(found[0].parts, (std::vector<std::string>{"eyes"}));
    EXPECT_LT(found[0].last, 1800u) << "up to the next state at most";
    EXPECT_EQ(found[1].step, 4100u);
    EXPECT_EQ(found[1].parts, (std::vector<std::string>{"pushed"}));
    std::filesystem::remove(file);
}

TEST(ReplayHeavy, WhatASystemKeepsToItselfIsFoundOut) {
    const Opened opened;
    const auto hides = [](App& app) {
        app.fixed_schedule()
            .add("hides",
                 [count = 0](ecs::Query<ecs::Write<game::Eyes>> all) mutable {
                     ++count;
                     all.each([&](game::Eyes& eyes) { eyes.pitch += 1e-12 * (count % 7); });
                 })
            .after("settle")
            .before("remember");
    };
    const Check check = heavy_check(*opened.level, opened.file, opened.recording, 37, {.extend = hides});
    EXPECT_EQ(check.verdict, Check::Verdict::failed);
    EXPECT_NE(check.text.find("goes on differently after loading"), std::string::npos) << check.text;
}

}  // namespace
}  // namespace lanthorn::tools
