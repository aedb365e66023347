#include "game/presentation/progress.h"

#include <cstring>
#include <span>

#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "tests/support/kept_folder.h"

namespace lanthorn::game {
namespace {

using support::damaged;

Progress some() {
    return {.solved = {"first", "second"},
            .level = "third",
            .level_hash = 0xfedcba9876543210u,
            .state = std::string("state\0of a world\xff", 17)};
}

// The head of `whole` for other words and state.
std::string head_of(const std::string& whole, const std::string& rest) {
    std::string head = whole.substr(0, 32);
    const std::uint64_t hash = replay::hash_bytes(std::as_bytes(std::span(rest)));
    std::memcpy(&head[24], &hash, sizeof hash);
    return head;
}

TEST(Progress, IsReadAsWritten) {
    EXPECT_EQ(progress_from_bytes(to_bytes(some()), "f"), some());
    EXPECT_EQ(progress_from_bytes(to_bytes({}), "f"), Progress());
}

TEST(Progress, OfAnotherVersionIsRefusedByIt) {
    std::string bytes = to_bytes(some());
    bytes[8] = 7;
    try {
        progress_from_bytes(bytes, "f");
        ADD_FAILURE();
    } catch (const InputError& e) {
        EXPECT_STREQ(e.what(), "f: version: found 7, expected 1");
    }
}

// The words of a build that had other ones.
TEST(Progress, GoesByNames) {
    const std::string whole = to_bytes({.solved = {"first"}, .level = "third", .state = ""});
    EXPECT_NE(whole.find("\"level_hash\""), std::string::npos);
    std::string altered = whole.substr(32);
    altered.replace(altered.find("\"level_hash\""), 12, "\"play_clock\"");
    EXPECT_EQ(progress_from_bytes(head_of(whole, altered) + altered, "f"),
              (Progress{.solved = {"first"}, .level = "third", .state = ""}));
}

TEST(Progress, SaysWhatAnotherBuildKept) {
    EXPECT_EQ(left_out_line("f", {"door.swing", "torch"}),
              "f: kept by another build; left out: door.swing, torch");
    EXPECT_EQ(left_out_line("f", {"a", "b", "c", "d", "e", "f", "g", "h"}),
              "f: kept by another build; left out: a, b, c, d, e, f and 2 more");
}

// Everything behind the mark and the version is under the checksum or compared with it.
TEST(Progress, NoAlteredByteGoesUnseen) {
    const std::string whole = to_bytes(some());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string altered = whole;
        altered[i] = static_cast<char>(altered[i] ^ 0x20);
        EXPECT_THROW(progress_from_bytes(altered, "f"), InputError) << "byte " << i;
        EXPECT_THROW(progress_from_bytes(whole.substr(0, i), "f"), InputError) << "cut at " << i;
    }
}

class ProgressFile : public support::KeptFolder {};

TEST_F(ProgressFile, ADamagedOneIsNoProgressAndKeptAside) {
    std::mt19937 random(2);
    for (int i = 0; i < 2000; ++i) {
        const std::string bytes = damaged(to_bytes(some()), random);
        put(bytes);
        shell::KeptFile kept = file();
        said.clear();
        const Progress read = read_progress(kept);
        if (bytes == to_bytes(some())) {
            continue;  // the damage undid itself
        }
        EXPECT_EQ(read, Progress());
        EXPECT_EQ(get("kept.damaged"), bytes);
        EXPECT_EQ(said.size(), 1u);
    }
}

}  // namespace
}  // namespace lanthorn::game
