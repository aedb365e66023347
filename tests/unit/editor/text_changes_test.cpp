// What saving says that it changes.
#include <gtest/gtest.h>

#include "tools/editor/core/text_changes.h"

namespace lanthorn::editor {
namespace {

TEST(TextChanges, OfLines) {
    const TextChanges changes = text_changes("a\nb\nc\nd\n", "a\nB\nc\nd\ne\n");
    EXPECT_EQ(changes.changed_lines, 2u);
    EXPECT_EQ(changes.changed_bytes, 2u);
    ASSERT_EQ(changes.lines.size(), 3u);
    EXPECT_EQ(changes.lines[0].text, "b");
    EXPECT_FALSE(changes.lines[0].added);
    EXPECT_EQ(changes.lines[0].line, 2u);
    EXPECT_EQ(changes.lines[1].text, "B");
    EXPECT_TRUE(changes.lines[1].added);
    EXPECT_EQ(changes.lines[2].text, "e");
    EXPECT_EQ(summary(changes, 4100000), "2 lines, 2 bytes of 4.1 MB");
    EXPECT_EQ(summary(text_changes("a", "a"), 1), "nothing");
}

TEST(TextChanges, OfOneLongLine) {
    std::string before = R"({"nodes":[)", after;
    for (int i = 0; i < 100; ++i) {
        before += (i > 0 ? "," : "") + std::string(R"({"name":"n)") + std::to_string(i) +
                  R"(","translation":[1,2,3]})";
    }
    before += "]}";
    after = before;
    const std::size_t at = after.find("n50");
    after.replace(after.find("[1,2,3]", at), 7, "[1.5,2,3]");
    const TextChanges changes = text_changes(before, after);
    EXPECT_EQ(changes.changed_lines, 1u);
    ASSERT_EQ(changes.lines.size(), 2u);
    EXPECT_EQ(changes.lines[1].text, R"("translation":[1.5,2,3]},)");
}

// Apart at several places, and too different to be told apart.
TEST(TextChanges, OfMuch) {
    std::string before, after;
    for (int i = 0; i < 3000; ++i) {
        before += "line " + std::to_string(i) + "\n";
        after += (i % 500 == 7 ? "other " : "line ") + std::to_string(i) + "\n";
    }
    EXPECT_EQ(text_changes(before, after).changed_lines, 6u);
    std::string all;
    for (int i = 0; i < 3000; ++i) {
        all += "new " + std::to_string(i) + "\n";
    }
    EXPECT_EQ(text_changes(before, all).changed_lines, 3000u);
    EXPECT_EQ(text_changes("", "a\nb\n").changed_lines, 2u);
    EXPECT_EQ(text_changes("a\nb\n", "").changed_lines, 2u);
}

}  // namespace
}  // namespace lanthorn::editor
