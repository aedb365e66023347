#include "lanthorn/replay/recording.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lanthorn/core/error.h"
#include "lanthorn/replay/state_hash.h"

namespace lanthorn::replay {
namespace {

namespace fs = std::filesystem;

class RecordingFile : public testing::Test {
  protected:
    RecordingFile()
        : folder_(fs::temp_directory_path() / ("lanthorn-recording-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~RecordingFile() override { fs::remove_all(folder_); }

    std::string file(const std::string& name = "a.rec") const { return (folder_ / name).string(); }

    static Recording example() {
        Recording r;
        r.header.level = "room.glb";
        r.header.level_hash = 0xfedcba9876543210ull;  // more than 53 bits: no double on the way
        r.header.seed = 7;
        r.header.build = "test";
        r.header.input_format = "test-1";
        r.header.input_size = 3;
        r.header.parts = {"door", "player"};
        r.header.sensors = {"far"};
        for (unsigned i = 0; i < 5; ++i) {
            RecordedStep step;
            step.input = {std::byte(i), std::byte(2), std::byte(3)};
            step.hashes = {i * 11ull, ~0ull - i};
            if (i % 2) step.sensors = {{0, 0.25f * static_cast<float>(i)}};
            r.steps.push_back(step);
        }
        return r;
    }

    std::string bytes(const std::string& path) const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    void put(const std::string& path, const std::string& contents) const {
        std::ofstream(path, std::ios::binary) << contents;
    }
    // The message that reading `contents` ends with; empty if it is read.
    std::string refusal(const std::string& contents) const {
        put(file("bad.rec"), contents);
        try {
            read_recording(file("bad.rec"));
        } catch (const InputError& e) {
            return e.what();
        }
        return {};
    }

    fs::path folder_;
};

TEST_F(RecordingFile, ComesBackAsItWas) {
    write_recording(file(), example());
    EXPECT_EQ(read_recording(file()), example());
}

TEST_F(RecordingFile, LeavesNothingElseBehind) {
    write_recording(file(), example());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(RecordingFile, MayHaveNoSteps) {
    Recording r = example();
    r.steps.clear();
    write_recording(file(), r);
    EXPECT_EQ(read_recording(file()), r);
}

TEST_F(RecordingFile, RefusesEveryTruncation) {
    write_recording(file(), example());
    const std::string whole = bytes(file());
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const std::string message = refusal(whole.substr(0, n));
        ASSERT_NE(message, "") << "of " << n << " bytes";
        ASSERT_EQ(message.find('\n'), std::string::npos);
        ASSERT_NE(message.find("bad.rec"), std::string::npos);
    }
}

TEST_F(RecordingFile, RefusesEveryFlippedBit) {
    write_recording(file(), example());
    const std::string whole = bytes(file());
    for (std::size_t i = 0; i < whole.size() * 8; ++i) {
        std::string damaged = whole;
        damaged[i / 8] = static_cast<char>(damaged[i / 8] ^ (1 << (i % 8)));
        ASSERT_NE(refusal(damaged), "") << "bit " << i;
    }
}

TEST_F(RecordingFile, RefusesLiesBehindARightChecksum) {
    // A step that claims four billion readings: the checksum is right, the room is not there.
    write_recording(file(), example());
    std::string lie = bytes(file());
    const std::size_t first_step = lie.find("STEP");
    ASSERT_NE(first_step, std::string::npos);
    const std::uint32_t huge = 0xffffffffu;
    std::memcpy(lie.data() + first_step + 4 + 3, &huge, sizeof huge);
    const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(lie).first(lie.size() - 8)));
    std::memcpy(lie.data() + lie.size() - 8, &sum, sizeof sum);
    EXPECT_NE(refusal(lie).find("sensor readings"), std::string::npos) << refusal(lie);
}

TEST_F(RecordingFile, NamesAnotherVersion) {
    write_recording(file(), example());
    std::string later = bytes(file());
    later[8] = 2;
    EXPECT_NE(refusal(later).find("version 2"), std::string::npos);
}

TEST_F(RecordingFile, SaysWhatIsMissing) {
    EXPECT_THROW(read_recording(file("none.rec")), InputError);
    EXPECT_THROW(write_recording(file("no/such/folder.rec"), example()), InputError);
    EXPECT_NE(refusal("glTF, not a recording").find("LANTHREC"), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::replay
