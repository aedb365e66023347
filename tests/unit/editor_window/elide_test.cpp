// Names for which there is too little room.
#include "tools/editor/window/elide.h"

#include <gtest/gtest.h>

namespace lanthorn::edit_window {
namespace {

// Each byte is as wide as another.
float bytes(std::string_view text) {
    return static_cast<float>(text.size());
}

TEST(Elide, KeepsTheEndsOfWhatIsTooWide) {
    EXPECT_EQ(elided("lantern-light-12", 16, bytes), "lantern-light-12");
    EXPECT_EQ(elided("lantern-light-12", 15, bytes), "lanter...ght-12");
    EXPECT_EQ(elided("lantern-light-12", 10, bytes), "lant...-12");
    EXPECT_EQ(elided("lantern-light-12", 5, bytes), "l...2");
    EXPECT_EQ(elided("lantern-light-12", 4, bytes), "...");
    EXPECT_EQ(elided("", -1, bytes), "...");
}

TEST(Elide, CutsNoCharacterInTwo) {
    // Of two bytes each.
    EXPECT_EQ(elided("\u00e4\u00f6\u00fc\u00e5\u00e9", 9, bytes), "\u00e4\u00f6...\u00e9");
    EXPECT_EQ(elided("\u00e4\u00f6\u00fc\u00e5\u00e9", 8, bytes), "\u00e4...\u00e9");
}

}  // namespace
}  // namespace lanthorn::edit_window
