#include "lanthorn/replay/sensor_check.h"

#include <gtest/gtest.h>

namespace lanthorn::replay {
namespace sensor_check_test {

// One sensor: 1 lux at step 10, 2 lux at step 20, each three steps late.
Recording recorded() {
    Recording recording;
    recording.header.sensors = {"far"};
    recording.steps.resize(30);
    recording.steps[13].sensors = {{0, 3, 1.0f}};
    recording.steps[23].sensors = {{0, 3, 2.0f}};
    return recording;
}

TEST(SensorCheck, TakesWhatIsNearTheRecordedReadingsAround) {
    SensorCheck check(recorded());
    check.check(0, 10, 1.0);
    check.check(0, 15, 0.6);
    check.check(0, 15, 2.7);
    check.check(0, 20, 2.7);
    EXPECT_FALSE(check.divergence()) << check.divergence()->describe();
    EXPECT_EQ(check.checked(), 4u);
}

TEST(SensorCheck, FindsWhatIsNot) {
    for (const auto& [step, value] : {std::pair(10, 0.4), std::pair(10, 1.6), std::pair(15, 2.8)}) {
        SensorCheck check(recorded());
        check.check(0, static_cast<std::uint64_t>(step), value);
        check.check(0, 20, 100);
        ASSERT_TRUE(check.divergence()) << value;
        EXPECT_EQ(check.divergence()->step, static_cast<std::uint64_t>(step));
        EXPECT_EQ(check.divergence()->actual, value);
    }
    SensorCheck check(recorded());
    check.check(0, 15, 5);
    EXPECT_EQ(check.divergence()->describe(), "step 15: sensor far: read 5, recorded 1 to 2");
}

TEST(SensorCheck, BearsReadingsBelowZero) {
    Recording recording = recorded();
    recording.steps[13].sensors[0].value = -8;
    recording.steps[23].sensors[0].value = -4;
    SensorCheck check(recording);
    check.check(0, 10, -8);
    check.check(0, 10, -10.2);
    check.check(0, 15, -2.8);
    EXPECT_FALSE(check.divergence()) << check.divergence()->describe();
    check.check(0, 15, -2.7);
    EXPECT_TRUE(check.divergence());
}

TEST(SensorCheck, PassesOverWhatNothingWasRecordedAround) {
    SensorCheck check(recorded());
    check.check(0, 9, 100);
    check.check(0, 21, 100);
    check.check(1, 15, 100);
    EXPECT_FALSE(check.divergence());
    EXPECT_EQ(check.checked(), 0u);
}

}  // namespace sensor_check_test
}  // namespace lanthorn::replay
