#include "engine/core/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lanthorn/core/error.h"

namespace lanthorn {
namespace {

std::string refusal(std::string_view text) {
    try {
        parse_json(text, "f");
    } catch (const InputError& error) {
        EXPECT_FALSE(json_if_valid(text));
        return error.what();
    }
    EXPECT_TRUE(json_if_valid(text));
    return "";
}

TEST(Json, IsTakenAsItStands) {
    EXPECT_EQ(parse_json("\xef\xbb\xbf {\"b\": [1, -2.5e3, null], \"a\": \"\\u00e4\"} ", "f").dump(),
              "{\"a\":\"ä\",\"b\":[1,-2500.0,null]}");
    EXPECT_EQ(parse_ordered_json(R"({"b": 1, "a": 2})", "f").dump(), R"({"b":1,"a":2})");
    EXPECT_EQ(parse_json("1.7976931348623157e308", "f").get<double>(), 1.7976931348623157e308);
}

TEST(Json, IsRefusedInOneLineWithItsPlace) {
    EXPECT_EQ(
        refusal("{\n  \"a\": }"),
        "f: JSON line 2, column 8: is not JSON: syntax error while parsing value - unexpected '}'; expected "
        "'[', '{', or a literal");
    EXPECT_EQ(refusal("[1,\n 1e999]"), "f: JSON line 2, column 2: number overflow parsing '1e999'");
    EXPECT_EQ(refusal("").substr(0, 38), "f: JSON line 1, column 1: is not JSON:");
    EXPECT_EQ(refusal("{} x").substr(0, 38), "f: JSON line 1, column 4: is not JSON:");
    EXPECT_EQ(refusal("\"\xff\"").substr(0, 38), "f: JSON line 1, column 2: is not JSON:");
    EXPECT_EQ(refusal("[NaN]").substr(0, 25), "f: JSON line 1, column 2:");
}

TEST(Json, NestsOnlySoDeep) {
    const auto deep = [](int levels) {
        const auto n = static_cast<std::size_t>(levels);
        return std::string(n, '[') + std::string(n, ']');
    };
    EXPECT_EQ(refusal(deep(kDeepestJson)), "");
    EXPECT_EQ(refusal(deep(kDeepestJson + 1)),
              "f: JSON line 1, column 65: found nesting deeper than 64 levels");
    EXPECT_EQ(refusal(deep(1'000'000)), "f: JSON line 1, column 65: found nesting deeper than 64 levels");
    EXPECT_EQ(refusal("\"" + std::string(1000, '[') + "\""), "") << "in text nothing nests";
}

}  // namespace
}  // namespace lanthorn
