// Recording and replaying an App that is none of the game's.
#include "lanthorn/session/session.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "lanthorn/core/error.h"
#include "lanthorn/replay/recording.h"
#include "tests/support/file_size_limit.h"
#include "tests/unit/session/counting_app.h"

namespace lanthorn::session {
namespace {

// 100 steps of 1, 2, 3, 1, ...
constexpr std::int64_t kSum = 33 * 6 + 1;

void record(const std::string& file, std::uint64_t seed = 1) {
    Played played(recording_to(file, seed));
    played.to_the_end();
    played.session().finish();
}

// As a program that was killed leaves it: in chunks of half a second.
void record_unfinished(const std::string& file) {
    Played played(recording_to(file));
    played.to_the_end();
}

std::string refusal(const std::function<void()>& attempt) {
    try {
        attempt();
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Session, AsksItsSourceOnceAStep) {
    std::vector<std::uint64_t> asked;
    Played played(
        {},
        [&](const ecs::World&, std::uint64_t step) {
            asked.push_back(step);
            return Push{2};
        },
        4);
    EXPECT_EQ(played.session().length(), 4u);
    played.to_the_end();
    EXPECT_EQ(asked, (std::vector<std::uint64_t>{0, 1, 2, 3}));
    EXPECT_EQ(played.value(), 8);
    played.steps(3);
    EXPECT_EQ(played.value(), 8) << "beyond the end nothing comes in";
}

TEST(Session, WithoutASourceNothingHappens) {
    Played played({}, {}, {});
    EXPECT_FALSE(played.session().length());
    played.steps(5);
    EXPECT_FALSE(played.session().done());
    EXPECT_EQ(played.value(), 0);
    EXPECT_EQ(played.app().world().resource<Push>().by, 0);
}

TEST(Session, IsWholeHoweverTheAppIsRun) {
    Played played({});
    played.app().show_at(10.25 / 60);
    EXPECT_EQ(played.session().steps(), 11u);
    EXPECT_EQ(played.value(), 3 * 6 + 1 + 2);
}

TEST(Session, AReplayIsWhatWasRecorded) {
    const RecordingName file;
    record(file.path(), 5);
    Played played(replaying(file.path()), [](const ecs::World&, std::uint64_t) -> Push {
        ADD_FAILURE() << "the recording drives";
        return {};
    });
    EXPECT_EQ(played.session().length(), 100u);
    EXPECT_EQ(played.session().seed(), 5u);
    played.to_the_end();
    EXPECT_EQ(played.session().divergence(), "");
    EXPECT_EQ(played.value(), kSum);
    EXPECT_TRUE(played.warnings().empty());
    played.steps(2);
    EXPECT_EQ(played.value(), kSum);
}

TEST(Session, AReplayMayBeRecorded) {
    const RecordingName file;
    record(file.path(), 5);
    const std::string copy = file.path() + ".copy";
    {
        Config config = replaying(file.path());
        config.record = copy;
        Played played(config);
        played.to_the_end();
        played.session().finish();
    }
    EXPECT_EQ(replay::read_recording(copy), replay::read_recording(file.path()));
    std::filesystem::remove(copy);
}

TEST(Session, NamesTheStepAndThePartThatDiffer) {
    const RecordingName file;
    record(file.path());
    replay::Recording altered = replay::read_recording(file.path());
    altered.steps[42].input[0] ^= std::byte{4};
    replay::write_recording(file.path(), altered);
    Played played(replaying(file.path()));
    played.steps(42);
    EXPECT_EQ(played.session().divergence(), "");
    played.to_the_end();
    EXPECT_EQ(played.session().divergence().substr(0, 18), "step 42: counter: ");
}

TEST(Session, ProgramsOfOtherRulesAreFoundOut) {
    const RecordingName file;
    record(file.path());
    Played played(replaying(file.path()), pushed, {}, 2);
    played.to_the_end();
    EXPECT_EQ(played.session().divergence().substr(0, 17), "step 0: counter: ");
}

TEST(Session, ReplaysWhatIsWholeOfAFileThatIsCutOff) {
    const RecordingName file;
    record_unfinished(file.path());
    std::filesystem::resize_file(file.path(), std::filesystem::file_size(file.path()) * 2 / 3);
    Played played(replaying(file.path()));
    ASSERT_EQ(played.warnings().size(), 1u);
    EXPECT_NE(played.warnings()[0].find(file.path() + ": cut off at byte"), std::string::npos);
    EXPECT_GT(*played.session().length(), 20u);
    EXPECT_LT(*played.session().length(), 100u);
    played.to_the_end();
    EXPECT_EQ(played.session().divergence(), "");
}

TEST(Session, RefusesARecordingOfSomethingElse) {
    const RecordingName file;
    record(file.path());
    EXPECT_NE(refusal([&] {
                  Played(replaying(file.path()), pushed, {}, 1, "counter-2");
              }).find("recorded with counter-1 (1 bytes), but this program has counter-2 (1 bytes)"),
              std::string::npos);
    const auto refused = [&](auto alter) {
        Config config = replaying(file.path());
        alter(config);
        return refusal([&] { Played played(config); });
    };
    EXPECT_NE(refused([](Config& s) { s.content = "abacus"; }), "");
    EXPECT_NE(refused([](Config& s) { s.content_hash = 8; }), "");
    EXPECT_NE(refused([](Config& s) { s.replay += ".none"; }), "");
    std::ofstream(file.path()) << "no recording";
    EXPECT_NE(refused([](Config&) {}), "");
}

TEST(Session, SaysAtOnceThatItCannotRecord) {
    EXPECT_NE(refusal([] { Played played(recording_to("/no/such/folder/a.rec")); }), "");
}

TEST(Session, RefusesAnAppThatItCannotWatch) {
    App bare;
    EXPECT_NE(
        refusal([&] { Session(bare, InputStream::of<Push>("counter-1"), {}); }).find("without ScenePlugin"),
        std::string::npos);
    App late;
    build_counter(late);
    late.world().insert_resource(Push{});
    late.step();
    EXPECT_NE(refusal([&] { Session(late, InputStream::of<Push>("counter-1"), {}); }).find("with steps"),
              std::string::npos);
}

TEST(Session, PlaysOnWhereTheDiskIsFull) {
    const RecordingName file;
    record_unfinished(file.path());
    const std::uintmax_t whole = std::filesystem::file_size(file.path());
    Played played(recording_to(file.path()));
    {
        const support::FileSizeLimit limit(whole * 2 / 3);
        played.to_the_end();
        played.session().finish();
    }
    EXPECT_TRUE(played.session().recording_failed());
    EXPECT_EQ(played.value(), kSum);
    ASSERT_EQ(played.warnings().size(), 1u);
    EXPECT_NE(played.warnings()[0].find("cannot be written"), std::string::npos);
    Played replayed(replaying(file.path()));
    EXPECT_GT(*replayed.session().length(), 0u);
    replayed.to_the_end();
    EXPECT_EQ(replayed.session().divergence(), "");
}

TEST(Session, SaysWhereItWasStopped) {
    const RecordingName file;
    const StopSignal stop;
    Played played(recording_to(file.path()));
    played.steps(12);
    EXPECT_EQ(played.session().stopped(stop), "");
    std::raise(SIGTERM);
    EXPECT_EQ(played.session().stopped(stop),
              "SIGTERM: stopped after 12 of 100 steps, which are in " + file.path());
    Played live({}, pushed, {});
    EXPECT_EQ(live.session().stopped(stop), "SIGTERM: stopped after 0 steps");
}

// On replay the recorded readings enter the simulation, and fresh ones are held against them.
TEST(Session, ReplaysTheReadingsOfSensors) {
    const RecordingName file;
    const auto play = [](Played& played, float lux) {
        while (!played.session().done()) {
            const std::uint64_t steps = played.session().steps();
            if (steps % 10 == 5) {
                played.app().world().resource_mut<SensorInbox>().samples = {
                    {played.sensor_entity().index, steps - 2, lux}};
            }
            played.app().step();
        }
    };
    {
        Played played(recording_to(file.path()));
        play(played, 2.5f);
        played.session().finish();
        EXPECT_EQ(played.sensor().readings, 10u);
    }
    Played alike(replaying(file.path()));
    play(alike, 2.6f);
    EXPECT_EQ(alike.session().divergence(), "");
    EXPECT_EQ(alike.sensor().lux, 2.5f);
    Played other(replaying(file.path()));
    play(other, 0.5f);
    EXPECT_EQ(other.session().divergence(), "step 3: sensor eye: read 0.5, recorded 2.5 to 2.5");
    EXPECT_EQ(other.sensor().lux, 2.5f);
}

}  // namespace
}  // namespace lanthorn::session
