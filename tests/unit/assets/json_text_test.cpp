#include "engine/assets/json_text.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"

namespace lanthorn {
namespace json_text_test {

constexpr const char* kText =
    "{ \"a\" : [1, 2.50 ,\n\t3e0] , \"\\u0062\": {\"c\":\"}]\\\"\", \"d\" :{ } },\"e\":[ ] }";

TEST(JsonText, LookingIntoItChangesNothing) {
    JsonText text(kText);
    EXPECT_EQ(text.size(), 3u);
    EXPECT_EQ(text.find("a")->size(), 3u);
    EXPECT_EQ(text.find("a")->at(1).text(), "2.50");
    EXPECT_EQ(text.key(1), "b") << "an escaped name";
    ASSERT_NE(text.find("b"), nullptr);
    EXPECT_EQ(text.find("b")->find("c")->text(), "\"}]\\\"\"");
    EXPECT_EQ(text.find("b")->find("d")->size(), 0u);
    EXPECT_EQ(text.find("e")->size(), 0u);
    EXPECT_EQ(text.find("f"), nullptr);
    EXPECT_EQ(text.find("a")->find("b"), nullptr) << "no object";
    EXPECT_EQ(text.text(), kText);
}

TEST(JsonText, AnEditKeepsAllElse) {
    JsonText text(kText);
    text.find("a")->at(2) = JsonText("4");
    text.find("b")->set("c", JsonText("null"));
    text.find("b")->find("d")->set("new", JsonText("[]"));
    text.find("e")->append(JsonText("7"));
    text.find("e")->append(JsonText("8"));
    EXPECT_EQ(text.text(),
              "{ \"a\" : [1, 2.50 ,\n\t4] , \"\\u0062\": {\"c\":null, \"d\" :{\"new\":[] } },\"e\":[7,8 ] }");
}

TEST(JsonText, WhatIsAddedLooksLikeItsNeighbour) {
    JsonText text("{\n  \"a\": 1\n}");
    text.set("b", JsonText("2"));
    EXPECT_EQ(text.text(), "{\n  \"a\": 1,\n  \"b\": 2\n}");
    text.erase("b");
    EXPECT_EQ(text.text(), "{\n  \"a\": 1\n}");
    text.erase("a");
    EXPECT_EQ(text.text(), "{\n}");
}

TEST(JsonText, OfMembersWithOneNameTheLastCounts) {
    JsonText text(R"({"a":1,"b":2,"a":3})");
    EXPECT_EQ(text.find("a")->text(), "3");
    text.set("a", JsonText("4"));
    EXPECT_EQ(text.text(), R"({"a":1,"b":2,"a":4})");
    EXPECT_TRUE(text.erase("a"));
    EXPECT_EQ(text.text(), R"({"b":2})");
    EXPECT_FALSE(text.erase("a"));
}

TEST(JsonText, CopiesAreTheirOwn) {
    JsonText text(kText);
    text.find("a")->at(0) = JsonText("true");
    const JsonText copy = text;
    text.find("a")->at(0) = JsonText("false");
    text.erase("b");
    EXPECT_EQ(copy.find("a")->at(0).text(), "true");
    EXPECT_NE(copy.find("b"), nullptr);
}

TEST(JsonText, QuotesWhatJsonEscapes) {
    EXPECT_EQ(json_quoted("a\"\\\n\xc3\xa4"), "\"a\\\"\\\\\\n\xc3\xa4\"");
    EXPECT_THROW(json_quoted("\xff"), InputError);
}

}  // namespace json_text_test
}  // namespace lanthorn
