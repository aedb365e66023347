#include "lanthorn/replay/recorder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lanthorn/core/error.h"
#include "tests/support/file_size_limit.h"
#include "tests/unit/replay/test_header.h"

namespace lanthorn::replay {
namespace {

namespace fs = std::filesystem;

class RecorderFile : public testing::Test {
  protected:
    RecorderFile()
        : folder_(fs::temp_directory_path() / ("lanthorn-recorder-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~RecorderFile() override { fs::remove_all(folder_); }

    std::string file() const { return (folder_ / "a.rec").string(); }
    std::string bytes() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    static void play(Recorder& recorder, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const SensorReading reading{0, 2, 0.5f};
            recorder.add(Input{static_cast<std::int16_t>(i), 1}, std::span(&reading, i % 7 == 1 ? 1u : 0u),
                         std::vector<std::uint64_t>{10u + i, 20u});
        }
    }

    fs::path folder_;
};

TEST_F(RecorderFile, WhatEndedIsWhole) {
    {
        Recorder recorder(file(), header());
        play(recorder, 100);
        recorder.finish();
    }
    const Recording recording = read_recording(file());
    EXPECT_EQ(recording.cut_off, "");
    EXPECT_EQ(recording.header, header());
    ASSERT_EQ(recording.steps.size(), 100u);
    EXPECT_EQ(recording.steps[99].root, root_of(std::vector<std::uint64_t>{109, 20}));
    EXPECT_EQ(recording.steps[0].changed, (std::vector<ChangedPart>{{0, 10}, {1, 20}}));
    EXPECT_EQ(recording.steps[99].changed, (std::vector<ChangedPart>{{0, 109}}));
    EXPECT_EQ(recording.steps[8].sensors, (std::vector<SensorReading>{{0, 2, 0.5f}}));
}

TEST_F(RecorderFile, AKilledProgramLosesLessThanASecond) {
    constexpr std::size_t kSteps = 100;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        Recorder recorder(file(), header());
        play(recorder, kSteps);
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);

    const Recording recording = read_recording(file());
    EXPECT_GT(recording.steps.size(), kSteps - 60);
    EXPECT_LE(recording.steps.size(), kSteps);
    EXPECT_NE(recording.cut_off.find("cut off at byte"), std::string::npos) << recording.cut_off;
    EXPECT_NE(recording.cut_off.find(std::to_string(recording.steps.size()) + " steps"), std::string::npos);
}

TEST_F(RecorderFile, AnExceptionLosesNothing) {
    { play(*std::make_unique<Recorder>(file(), header()), 100); }
    EXPECT_EQ(read_recording(file()).steps.size(), 100u);
    EXPECT_NE(read_recording(file()).cut_off, "");
}

TEST_F(RecorderFile, AFullDiskKeepsWhatWasWritten) {
    Recorder recorder(file(), header());
    {
        const support::FileSizeLimit limit(1500);
        play(recorder, 100);
        EXPECT_NE(recorder.failure().find("a.rec: cannot be written: "), std::string::npos)
            << recorder.failure();
        EXPECT_EQ(recorder.failure().find('\n'), std::string::npos);
    }
    play(recorder, 100);  // room again: a recording with a gap would be none
    recorder.finish();
    const Recording recording = read_recording(file());
    EXPECT_EQ(recording.steps.size(), recorder.steps());
    EXPECT_GT(recording.steps.size(), 0u);
    EXPECT_LT(recording.steps.size(), 100u);
    EXPECT_NE(recording.cut_off, "");
    EXPECT_NE(recorder.failure().find(std::to_string(recording.steps.size()) + " steps"), std::string::npos);
}

TEST_F(RecorderFile, WithNoRoomForABeginningTheOldFileStays) {
    std::ofstream(file()) << "old";
    const support::FileSizeLimit limit(60);
    EXPECT_THROW(Recorder(file(), header()), InputError);
    EXPECT_EQ(bytes(), "old");
}

}  // namespace
}  // namespace lanthorn::replay
