#include "lanthorn/core/choice.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"

namespace lanthorn {
namespace {

TEST(Choice, NamesComeBeforeNumbers) {
    const std::vector<std::string> names{"front", "2", "door"};
    EXPECT_EQ(find_by_name_or_number(names, "door"), 2u);
    EXPECT_EQ(find_by_name_or_number(names, "0"), 0u);
    EXPECT_EQ(find_by_name_or_number(names, "2"), 1u) << "a name that is a number";
    for (const char* none : {"", "3", "-1", "1x", "0.5", "back"}) {
        EXPECT_EQ(find_by_name_or_number(names, none), std::nullopt) << none;
    }
    EXPECT_EQ(numbered_names(names), "0 'front', 1 '2', 2 'door'");
    EXPECT_EQ(numbered_names({}), "");
}

TEST(Choice, SizesAreRefusedByOptionAndRange) {
    EXPECT_EQ(parse_size("--size", "640x360", 1, 8192), ivec2(640, 360));
    for (const char* wrong :
         {"", "640", "640x", "x360", "0x360", "640x8193", "640x360x1", "-1x5", "640 x 360 "}) {
        try {
            parse_size("--size", wrong, 1, 8192);
            ADD_FAILURE() << "taken: " << wrong;
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(), "--size: found '" + std::string(wrong) +
                                        "', expected WIDTHxHEIGHT from 1x1 to 8192x8192");
        }
    }
}

TEST(Colour, EncodingAndDecodingAreInverse) {
    for (int level = 0; level < 256; ++level) {
        const double v = level / 255.0;
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(v)), v, 1e-6) << level;
    }
    EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
}

}  // namespace
}  // namespace lanthorn
