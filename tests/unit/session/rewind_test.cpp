// Going back in a session, and returning.
#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/world_hash.h"
#include "lanthorn/replay/recording.h"
#include "tests/unit/session/counting_app.h"

namespace lanthorn::session {
namespace {

std::vector<std::uint64_t> hashes(Played& played) {
    return ecs::state_hashes(played.app().registry(), played.app().world());
}

TEST(SessionRewind, DoesTheSameAgain) {
    Played played({});
    played.steps(10);
    const Moment moment = played.session().keep();
    EXPECT_EQ(moment.step(), 10u);
    const auto then = hashes(played);
    played.steps(20);
    const auto later = hashes(played);
    for (int i = 0; i < 3; ++i) {
        played.session().rewind(moment);
        EXPECT_TRUE(played.session().in_the_past());
        EXPECT_EQ(played.session().steps(), 10u);
        EXPECT_EQ(played.app().time().moment, 10.0 / 60);
        EXPECT_EQ(hashes(played), then);
        played.steps(20);
        EXPECT_EQ(hashes(played), later);
    }
}

TEST(SessionRewind, ComesBackToWhereItLeft) {
    Played played({});
    const Moment first = played.session().keep();
    played.steps(10);
    const Moment second = played.session().keep();
    played.steps(5);
    const auto present = hashes(played);
    played.session().rewind(second);
    played.session().rewind(first);
    EXPECT_EQ(played.value(), 0);
    played.steps(1);
    played.session().come_back();
    EXPECT_FALSE(played.session().in_the_past());
    EXPECT_EQ(played.session().steps(), 15u);
    EXPECT_EQ(hashes(played), present);
    played.session().come_back();
    EXPECT_EQ(hashes(played), present);
}

TEST(SessionRewind, TheSourceIsAskedAnew) {
    std::int8_t by = 1;
    Played played({}, [&](const ecs::World&, std::uint64_t) { return Push{by}; });
    const Moment moment = played.session().keep();
    played.steps(10);
    by = 5;
    played.session().rewind(moment);
    played.steps(10);
    EXPECT_EQ(played.value(), 50);
    played.session().come_back();
    EXPECT_EQ(played.value(), 10);
}

TEST(SessionRewind, ARecordingGoesOnAfterTheReturn) {
    const RecordingName file;
    {
        Played played(recording_to(file.path()));
        const Moment moment = played.session().keep();
        played.steps(10);
        played.session().rewind(moment);
        played.steps(7);
        played.session().come_back();
        played.to_the_end();
        played.session().finish();
    }
    EXPECT_EQ(replay::read_recording(file.path()).steps.size(), 100u);
    Played played(replaying(file.path()));
    played.to_the_end();
    EXPECT_EQ(played.session().divergence(), "");
}

TEST(SessionRewind, AReplayTakesTheRecordedStepsAgain) {
    const RecordingName file;
    {
        Played played(recording_to(file.path()));
        played.to_the_end();
        played.session().finish();
    }
    Played played(replaying(file.path()));
    played.steps(30);
    const Moment moment = played.session().keep();
    played.to_the_end();
    const auto last = hashes(played);
    played.session().rewind(moment);
    EXPECT_FALSE(played.session().done());
    played.to_the_end();
    EXPECT_EQ(played.session().divergence(), "");
    EXPECT_EQ(hashes(played), last);
    played.session().come_back();
    EXPECT_TRUE(played.session().done());
}

TEST(SessionRewind, FindsWhatDiffersInThePastToo) {
    const RecordingName file;
    {
        Played played(recording_to(file.path()));
        played.to_the_end();
    }
    Played played(replaying(file.path()));
    const Moment moment = played.session().keep();
    played.steps(20);
    played.session().rewind(moment);
    played.steps(3);
    played.app().world().query<ecs::Write<Counter>>().each([](Counter& counter) { ++counter.value; });
    played.steps(3);
    EXPECT_EQ(played.session().divergence().substr(0, 17), "step 3: counter: ");
}

TEST(SessionRewind, GoesBackToWhatWasDestroyed) {
    Played played({});
    const Moment moment = played.session().keep();
    played.app().world().destroy(played.sensor_entity());
    played.steps(1);
    played.session().rewind(moment);
    EXPECT_EQ(played.sensor().readings, 0u);
}

TEST(SessionJump, GoesWhereAnotherRunWas) {
    const RecordingName file;
    {
        Played played(recording_to(file.path()));
        EXPECT_THROW(played.session().jump(played.session().keep()), Error) << "it is recorded";
        played.to_the_end();
        played.session().finish();
    }
    Played first(replaying(file.path()));
    first.steps(40);
    const std::string state = ecs::Snapshot::save(first.app().world(), first.app().registry()).to_bytes();
    first.steps(20);
    Played second(replaying(file.path()));
    second.session().jump(Moment(40, ecs::Snapshot::from_bytes(state, second.app().registry(), "state")));
    EXPECT_EQ(second.session().steps(), 40u);
    second.steps(20);
    EXPECT_EQ(hashes(second), hashes(first));
    EXPECT_EQ(second.session().divergence(), "");
    EXPECT_EQ(second.session().comparison()->steps, 20u);
}

TEST(SessionRewind, RefusesWhatIsYetToCome) {
    Played played({});
    const Moment start = played.session().keep();
    played.steps(10);
    const Moment later = played.session().keep();
    played.session().rewind(start);
    EXPECT_THROW(played.session().rewind(later), Error);
    played.session().come_back();
    EXPECT_EQ(played.session().steps(), 10u);
}

}  // namespace
}  // namespace lanthorn::session
