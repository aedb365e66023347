#include "lanthorn/replay/recording.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/replay/recording_format.h"
#include "engine/replay/steps_chunk.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "tests/support/repository.h"

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
        r.header.schemas = {0xfedcba9876543211ull, 2};
        r.header.sensors = {"far"};
        std::vector<std::uint64_t> before;
        for (unsigned i = 0; i < 5; ++i) {
            RecordedStep step;
            step.input = {std::byte(i), std::byte(2), std::byte(3)};
            mark_state(std::vector<std::uint64_t>{i / 2 * 11ull, ~0ull - i}, before, step);
            if (i % 2) {
                step.sensors = {{0, i, 0.25f * static_cast<float>(i)}};
            }
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
    static std::string refusal(const std::string& contents) {
        try {
            decoded_recording("bad.rec", std::as_bytes(std::span(contents)));
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

// Five steps in chunks of two.
std::string in_chunks(const Recording& r) {
    const std::span steps(r.steps);
    return encoded_beginning(r.header) + encoded_steps(r.header, 0, steps.first(2)) +
           encoded_steps(r.header, 2, steps.subspan(2, 2)) + encoded_steps(r.header, 4, steps.subspan(4)) +
           encoded_end(5);
}

TEST_F(RecordingFile, HoldsWhatIsSaidOfIt) {
    Recording r = example();
    r.annotations.marks = {{3, "door-open", "eyes", "", "usual"}};
    r.annotations.expectations = {"solved before 4"};
    r.annotations.notes = {"the crate falls over \xc3\xb6"};
    r.annotations.log = {"a build", "a machine"};
    r.annotations.states = {{0, std::string("\0state", 6)}, {4, "later"}};
    r.annotations.line = {{"an older build", "Bullet 3.25", {1, ~0ull}}};
    r.annotations.unknown = {{0x31324142, "what a later version has"}};
    write_recording(file(), r);
    EXPECT_EQ(read_recording(file()), r);
}

TEST_F(RecordingFile, PassesOverOptionalChunksThatItDoesNotKnowAndRefusesOthersByName) {
    const Recording r = example();
    const std::string rest = encoded_steps(r.header, 0, r.steps) + encoded_end(5);
    const auto with = [&](bool optional) {
        return encoded_beginning(r.header) +
               encoded_chunk(chunk_kind("ODD1"), "?", Packing::plain, optional) + rest;
    };
    EXPECT_EQ(refusal(with(true)), "");
    EXPECT_NE(refusal(with(false)).find("found a chunk 'ODD1', expected one that this version knows"),
              std::string::npos)
        << refusal(with(false));
}

TEST_F(RecordingFile, IsPacked) {
    Recording r = example();
    r.steps.resize(1);
    while (r.steps.size() < 6000) {
        r.steps.push_back(r.steps[0]);
        r.steps.back().changed.clear();
        r.steps.back().root = r.steps.size() * 0x9e3779b97f4a7c15ull;
    }
    write_recording(file(), r);
    EXPECT_EQ(read_recording(file()), r);
    EXPECT_LT(bytes(file()).size(), 6000u * 9) << "little more than the roots";
}

TEST_F(RecordingFile, MayBeOfManyChunks) {
    put(file(), in_chunks(example()));
    EXPECT_EQ(read_recording(file()), example());
}

TEST_F(RecordingFile, CutOffAnywhereItHoldsItsWholeChunks) {
    const std::string whole = in_chunks(example());
    const std::size_t header = encoded_beginning(example().header).size();
    std::size_t most = 0;
    for (std::size_t n = 0; n < whole.size(); ++n) {
        if (n < header) {
            const std::string message = refusal(whole.substr(0, n));
            ASSERT_NE(message, "") << "of " << n << " bytes";
            ASSERT_EQ(message.find('\n'), std::string::npos);
            ASSERT_NE(message.find("bad.rec"), std::string::npos);
            continue;
        }
        put(file(), whole.substr(0, n));
        const Recording cut = read_recording(file());
        ASSERT_NE(cut.cut_off.find("cut off at byte " + std::to_string(n)), std::string::npos) << cut.cut_off;
        ASSERT_EQ(cut.cut_off.find('\n'), std::string::npos);
        ASSERT_GE(cut.steps.size(), most);
        most = cut.steps.size();
        ASSERT_TRUE(std::equal(cut.steps.begin(), cut.steps.end(), example().steps.begin()));
    }
    EXPECT_EQ(most, 5u);
}

TEST_F(RecordingFile, RefusesAChunkThatIsMissing) {
    const Recording r = example();
    const std::span steps(r.steps);
    EXPECT_NE(
        refusal(encoded_beginning(r.header) + encoded_steps(r.header, 2, steps.subspan(2)) + encoded_end(5))
            .find("steps from 2"),
        std::string::npos);
    EXPECT_NE(
        refusal(encoded_beginning(r.header) + encoded_steps(r.header, 0, steps.first(2)) + encoded_end(5)),
        "");
    EXPECT_NE(refusal(in_chunks(r) + "x"), "");
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
    // A step that claims four billion readings: the checksums are right, the room is not there.
    const Recording r = example();
    std::string chunk = encoded_steps(r.header, 0, r.steps);
    const std::uint32_t huge = 0xffffffffu;
    const std::size_t head = 24, readings = head + 8 + 4 + r.steps.size() * r.header.input_size;
    std::memcpy(chunk.data() + readings, &huge, sizeof huge);
    const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(chunk).first(chunk.size() - 8)));
    std::memcpy(chunk.data() + chunk.size() - 8, &sum, sizeof sum);
    const std::string message = refusal(encoded_beginning(r.header) + chunk);
    EXPECT_NE(message.find("sensor readings"), std::string::npos) << message;
}

TEST_F(RecordingFile, ABillionStepsThatAreClaimedAreRefusedBeforeThereIsRoomForThem) {
    const Recording r = example();
    std::string body = steps_body(r.header, 0, r.steps);
    const std::uint32_t claimed = 1'000'000'000;
    std::memcpy(body.data() + 8, &claimed, sizeof claimed);
    const std::string message =
        refusal(encoded_beginning(r.header) + encoded_chunk(chunk_kind("STEP"), body, Packing::plain));
    EXPECT_NE(message.find("found 1000000000 steps, more than the chunk has room for"), std::string::npos)
        << message;
}

TEST_F(RecordingFile, ABombIsRefusedBeforeItIsUnpacked) {
    const Recording r = example();
    std::string packed(ZSTD_compressBound(kMostBody), '\0');
    const std::string zeros(kMostBody, '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 3));
    struct {
        std::uint32_t kind, stored, unpacked, flags;
    } head{static_cast<std::uint32_t>(chunk_kind("NOTE")), static_cast<std::uint32_t>(packed.size()),
           kMostBody, 1};
    std::string chunk(reinterpret_cast<const char*>(&head), sizeof head);
    const auto seal = [&] {
        const std::uint64_t sum = hash_bytes(std::as_bytes(std::span(chunk)));
        chunk.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    };
    seal();
    chunk += packed;
    seal();
    const std::string message = refusal(encoded_beginning(r.header) + chunk);
    EXPECT_NE(message.find("claims 16777216 unpacked"), std::string::npos) << message;
}

TEST_F(RecordingFile, ReadsVersion2) {
    const Recording old = read_recording(support::repository_file("tests/unit/replay/version-2.rec"));
    EXPECT_EQ(old.header.level, "room.glb");
    EXPECT_EQ(old.header.schemas, (std::vector<std::uint64_t>{0, 0})) << "not known";
    Recording expected = example();
    expected.header.schemas = {0, 0};
    EXPECT_EQ(old, expected);
    write_recording(file(), old);
    EXPECT_EQ(read_recording(file()), old) << "as version 3";
}

TEST_F(RecordingFile, NamesAnotherVersion) {
    write_recording(file(), example());
    std::string later = bytes(file());
    for (const char version : {1, 4}) {
        later[8] = version;
        EXPECT_NE(refusal(later).find("version " + std::to_string(version)), std::string::npos);
        EXPECT_NE(refusal(later).find(version == 1 ? "record the session again" : "a later program"),
                  std::string::npos);
    }
}

TEST_F(RecordingFile, SaysWhatIsMissing) {
    EXPECT_THROW(read_recording(file("none.rec")), InputError);
    EXPECT_THROW(write_recording(file("no/such/folder.rec"), example()), InputError);
    EXPECT_NE(refusal("glTF, not a recording").find("LANTHREC"), std::string::npos);
}

// The beginning of a file with this text as its header.
std::string beginning_with(const std::string& header) {
    const auto put = [](std::string& to, auto number) {
        to.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const auto hash = [](const std::string& of) { return hash_bytes(std::as_bytes(std::span(of))); };
    const std::string beginning = encoded_beginning({});
    std::string chunk = beginning.substr(12, 4);
    put(chunk, static_cast<std::uint32_t>(header.size()));
    put(chunk, static_cast<std::uint32_t>(header.size()));
    put(chunk, std::uint32_t{0});
    put(chunk, hash(chunk));
    chunk += header;
    put(chunk, hash(chunk));
    return beginning.substr(0, 12) + chunk;
}

TEST_F(RecordingFile, ADamagedHeaderIsNamedByItsMember) {
    EXPECT_EQ(refusal(beginning_with("{")),
              "bad.rec: header: JSON line 1, column 2: is not JSON: syntax error while parsing object key - "
              "unexpected end of input; expected string literal");
    EXPECT_EQ(refusal(beginning_with("[]")), "bad.rec: header: level: is missing, expected a string");
    EXPECT_EQ(refusal(beginning_with(R"({"level":5})")),
              "bad.rec: header: level: found 5, expected a string");
    EXPECT_EQ(refusal(beginning_with(R"({"level":"a","level_hash":"b"})")),
              "bad.rec: header: level_hash: found \"b\", expected a number");
    const std::string until_parts =
        R"({"level":"a","level_hash":1,"seed":1,"step_rate":60,"build":"","input_format":"","input_size":1)";
    EXPECT_EQ(refusal(beginning_with(until_parts + R"(,"parts":[1]})")),
              "bad.rec: header: parts: found [1], expected a list of strings");
    EXPECT_EQ(refusal(beginning_with(until_parts + R"(,"parts":[]})")),
              "bad.rec: header: schemas: is missing, expected a list of numbers");
    EXPECT_EQ(refusal(beginning_with(until_parts + R"(,"parts":[],"schemas":[]})")),
              "bad.rec: header: sensors: is missing, expected a list of strings");
    EXPECT_EQ(refusal(beginning_with(until_parts + R"(,"parts":["a"],"schemas":[],"sensors":[]})")),
              "bad.rec: header: parts: found 1 parts and 0 schemas, expected as many of both, at most 256");
}

}  // namespace
}  // namespace lanthorn::replay
