#include <gtest/gtest.h>

#include <limits>

#include "engine/core/base64.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/math.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/core/progress.h"

namespace lanthorn {
namespace {

TEST(InputError, JoinsFilePlaceAndProblem) {
    EXPECT_STREQ(InputError("a.glb", "/meshes/0", "found 1, expected 2").what(),
                 "a.glb: /meshes/0: found 1, expected 2");
    EXPECT_STREQ(InputError("a.glb", "", "is missing").what(), "a.glb: is missing");
    EXPECT_EQ(InputError("x").code(), ExitCode::bad_input);
}

TEST(InputError, IsOneShortLineOfPlainText) {
    EXPECT_STREQ(InputError("a\nb.glb", "/x\x1b[2J", "found '\x07\xff\xc2\x9b'").what(),
                 "a\\nb.glb: /x\\x1b[2J: found '\\x07\\xff\\x9b'");
    const std::string line = InputError("a.glb", std::string(5000, 'p'), std::string(5000, 'x')).what();
    EXPECT_EQ(line.size(), 500u);
    EXPECT_TRUE(line.ends_with("x..."));
}

TEST(InputError, IsShortWhateverIsLong) {
    const std::string file = "/tmp/" + std::string(3000, '\x1b') + "/scene.glb", key(3000, 'p');
    for (const std::string& place : {std::string(), key}) {
        for (const std::string& problem : {std::string("is missing"), key}) {
            const std::string line = InputError(file, place, problem).what();
            EXPECT_LE(line.size(), 500u);
            EXPECT_TRUE(line.starts_with("...")) << line;
            EXPECT_NE(line.find("\\x1b/scene.glb: "), std::string::npos)
                << "a path's end says most: " << line;
            EXPECT_NE(line.find(problem.substr(0, 10)), std::string::npos) << line;
        }
    }
    EXPECT_EQ(std::string(InputError(std::string(400, 'f'), "", "is missing").what()).size(), 412u)
        << "what fits is whole";
}

TEST(InputError, WithoutAFileIsShortToo) {
    EXPECT_STREQ(InputError("found 'a\nb', expected NAME=VALUE").what(),
                 "found 'a\\nb', expected NAME=VALUE");
    EXPECT_EQ(std::string(InputError(std::string(5000, 'x')).what()).size(), 500u);
}

TEST(Printable, KeepsWordsOfAnyLanguage) {
    const std::string words = "Tür, 扉, 🚪";
    EXPECT_EQ(printable(words), words);
    EXPECT_EQ(printable("a\tb\r\n"), "a\\tb\\r\\n");
    EXPECT_EQ(printable("\u202eevil"), "\\u202eevil");
    EXPECT_EQ(printable("\xc0\xaf\xed\xa0\x80"), "\\xc0\\xaf\\xed\\xa0\\x80") << "overlong and surrogate";
}

TEST(Printable, NothingIsReadAsMarkup) {
    EXPECT_EQ(markup_text("<b a=\"1\" c='2'> Tür & 扉\n"),
              "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; Tür &amp; 扉\n");
    EXPECT_EQ(markup_text("\x1b[0m\xc0 end"), "?[0m? end");
}

TEST(Base64, IsTheStandards) {  // RFC 4648, section 10, and all bits
    const char* const expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (std::size_t size = 0; size <= 6; ++size) {
        EXPECT_EQ(base64(std::string_view("foobar").substr(0, size)), expected[size]);
    }
    EXPECT_EQ(base64("\xff\xef\xbe"), "/+++");
}

TEST(Printable, ShortTextsAreNotCutWithinACharacter) {
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abc...");
    EXPECT_EQ(shortened("ab\u00fcdefg", 6), "ab...");
    EXPECT_EQ(shortened_front("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened_front("abcdefg", 6), "...efg");
    EXPECT_EQ(shortened_front("abcd\u00fcfg", 6), "...fg");
}

TEST(Aabb, StartsEmptyAndGrows) {
    Aabb box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.diagonal(), 0);
    box.add(vec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.centre(), vec3(1, 2, 3));
    box.add(vec3(-1, 2, 5));
    EXPECT_EQ(box.size(), vec3(2, 0, 2));
}

TEST(Aabb, TransformedHoldsEveryTransformedCorner) {
    const Aabb box{{-1, -2, -3}, {4, 5, 6}};
    mat4 m(glm::mat4_cast(glm::angleAxis(0.7f, glm::normalize(vec3(1, -2, 0.5f)))));
    m[0] *= 2.0f;
    m[3] = vec4(10, 20, 30, 1);
    Aabb exact;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                     corner & 4 ? box.upper.z : box.lower.z);
        exact.add(vec3(m * vec4(p, 1)));
    }
    const Aabb result = transformed(box, m);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(result.lower[i], exact.lower[i], 1e-4);
        EXPECT_NEAR(result.upper[i], exact.upper[i], 1e-4);
    }
    EXPECT_TRUE(transformed(Aabb{}, m).empty());
}

TEST(DurationWords, HaveTheUnitThatTheyNeed) {
    EXPECT_EQ(duration_words(0.44), "0.4 s");
    EXPECT_EQ(duration_words(9.94), "9.9 s");
    EXPECT_EQ(duration_words(9.96), "10 s");
    EXPECT_EQ(duration_words(59.4), "59 s");
    EXPECT_EQ(duration_words(59.6), "1 min 00 s");
    EXPECT_EQ(duration_words(150), "2 min 30 s");
    EXPECT_EQ(duration_words(3599.4), "59 min 59 s");
    EXPECT_EQ(duration_words(3599.6), "1 h 00 min");
    EXPECT_EQ(duration_words(7529), "2 h 05 min");
    EXPECT_EQ(duration_words(7531), "2 h 06 min");
}

TEST(DurationWords, AreWordsAtExtremes) {
    EXPECT_EQ(duration_words(0), "0.1 s");
    EXPECT_EQ(duration_words(-7), "0.1 s");
    EXPECT_EQ(duration_words(std::numeric_limits<double>::quiet_NaN()), "0.1 s");
    EXPECT_EQ(duration_words(std::numeric_limits<double>::infinity()), "277777 h 47 min");
}

TEST(Progress, LineTellsShareAndRemainingTime) {
    EXPECT_EQ(Progress::line("rendering", 0, 4, 0), "rendering [                              ]   0 %");
    EXPECT_EQ(Progress::line("rendering", 2, 4, 3),
              "rendering [###############               ]  50 %  3.0 s left");
    EXPECT_EQ(Progress::line("rendering", 1, 100, 10),
              "rendering [                              ]   1 %  16 min 30 s left");
    EXPECT_EQ(Progress::line("rendering", 1, 3601, 2),
              "rendering [                              ]   0 %  2 h 00 min left");
    EXPECT_EQ(Progress::line("rendering", 4, 4, 6), "rendering [##############################] 100 %");
    EXPECT_EQ(Progress::line("nothing", 0, 0, 0), "nothing [##############################] 100 %");
    EXPECT_EQ(Progress::line("more", 9, 4, 0), "more [##############################] 100 %");
}

TEST(Progress, IsSilentWithoutATerminal) {
    testing::internal::CaptureStderr();  // a file
    {
        Progress progress("rendering", 2);
        EXPECT_FALSE(progress.visible());
        progress.update(1);
        progress.update(2);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace lanthorn
