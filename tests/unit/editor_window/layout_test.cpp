// Where the editor's panels lie.
#include "tools/editor/window/layout.h"

#include <gtest/gtest.h>

#include <vector>

namespace lanthorn::edit_window {
namespace {

float area(const Box& box) {
    return box.empty() ? 0 : box.width * box.height;
}

std::vector<Box> boxes(const Layout& at) {
    return {at.toolbar, at.left,          at.history,        at.picture,         at.drawer,          at.right,
            at.status,  at.left_splitter, at.right_splitter, at.drawer_splitter, at.history_splitter};
}

TEST(EditorLayout, CoversTheWindowOnceAtEverySizeAndScale) {
    Splits closed;
    closed.drawer_open = false;
    Splits extreme{3000, 3000, 3000, 3000};
    for (const ivec2 window : {ivec2(1280, 720), ivec2(960, 540), ivec2(3840, 2160), ivec2(1920, 1080)}) {
        for (const float unit : {0.75f, 1.0f, 1.75f}) {
            for (const Splits& splits : {Splits{}, closed, extreme}) {
                const Layout at = lay_out(window, unit, splits);
                float sum = 0;
                for (const Box& box : boxes(at)) {
                    sum += area(box);
                    EXPECT_GE(box.x, 0);
                    EXPECT_GE(box.y, 0);
                    EXPECT_LE(box.x + box.width, static_cast<float>(window.x) + 0.5f);
                    EXPECT_LE(box.y + box.height, static_cast<float>(window.y) + 0.5f);
                }
                EXPECT_NEAR(sum, static_cast<float>(window.x) * static_cast<float>(window.y), 1)
                    << window.x << " " << unit << " " << splits.left;
                for (float x = 1; x < static_cast<float>(window.x); x += 37) {
                    int owners = 0;
                    for (const Box& box : boxes(at)) {
                        owners += box.contains({x, static_cast<float>(window.y) / 2}) ? 1 : 0;
                    }
                    EXPECT_EQ(owners, 1) << x;
                }
            }
        }
    }
}

TEST(EditorLayout, AsTheDesignHasItAt1280And960) {
    const Layout wide = lay_out({1280, 720}, 1, {});
    EXPECT_FALSE(wide.narrow);
    EXPECT_EQ(wide.left.width, 248);
    EXPECT_EQ(wide.right.width, 288);
    EXPECT_NEAR(wide.picture.width, 740, 8);
    EXPECT_NEAR(wide.picture.height, 514, 4);
    Splits closed;
    closed.drawer_open = false;
    const Layout narrow = lay_out({960, 540}, 1, closed);
    EXPECT_TRUE(narrow.narrow);
    EXPECT_TRUE(narrow.left.empty());
    EXPECT_EQ(narrow.right.width, 264);
    EXPECT_NEAR(narrow.picture.width, 692, 4);
    EXPECT_NEAR(narrow.picture.height, 468, 2);
}

TEST(EditorLayout, NothingButThePicture) {
    Splits splits;
    splits.only_picture = true;
    const Layout at = lay_out({1280, 720}, 1, splits);
    EXPECT_EQ(at.picture, (Box{0, 0, 1280, 698}));
    EXPECT_TRUE(at.toolbar.empty());
}

}  // namespace
}  // namespace lanthorn::edit_window
