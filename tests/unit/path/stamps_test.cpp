// Which input makes a pass due.
#include "gi_module/shared/stamps.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

enum class Input { shape, light, view };
using Pass = Stamps<Input, 3>;

TEST(Stamps, WhatWasNeverMadeIsDueForNoInput) {
    Pass pass{Input::shape};
    EXPECT_TRUE(pass.empty());
    EXPECT_TRUE(pass.due({}));
    EXPECT_FALSE(pass.other({}));
    pass.made({});
    EXPECT_FALSE(pass.due({}));
    pass.forget();
    EXPECT_TRUE(pass.due({}));
}

TEST(Stamps, TheFirstInputThatDiffersIsTheReason) {
    Pass pass{Input::shape, Input::light, Input::view};
    pass.made({1, 1, 1});
    EXPECT_EQ(pass.other({1, 2, 2}), Input::light);
    EXPECT_EQ(pass.other({0, 2, 2}), Input::shape);
    pass.made({0, 2, 2});
    EXPECT_FALSE(pass.other({0, 2, 2}));
}

TEST(Stamps, WhatAPassIsNotMadeFromDoesNotCount) {
    Pass pass{Input::light};
    pass.made({1, 1, 1});
    EXPECT_FALSE(pass.due({2, 1, 3}));
    EXPECT_EQ(pass.other({2, 2, 3}), Input::light);
}

TEST(Stamps, ThePassSaysWhichInputIsTheBetterReason) {
    Pass pass{Input::view, Input::shape};
    pass.made({1, 1, 1});
    EXPECT_EQ(pass.other({2, 1, 2}), Input::view);
    EXPECT_TRUE(pass.differs(Input::shape, {2, 1, 1}));
    EXPECT_FALSE(pass.differs(Input::view, {2, 1, 1}));
    pass.forget();
    EXPECT_FALSE(pass.differs(Input::view, {2, 2, 2})) << "there is nothing to differ from";
}

TEST(Versioned, GrowsWithEachOtherValue) {
    Versioned<int> number;
    number.follow(4);
    const std::uint64_t first = number.version();
    number.follow(4);
    EXPECT_EQ(number.version(), first);
    number.follow(5);
    number.follow(4);
    EXPECT_EQ(number.version(), first + 2);
}

TEST(SceneVersions, GrowByPart) {
    SceneChanges none;
    none.assets = none.geometry = none.lights = none.camera = false;
    SceneVersions versions;
    versions.follow(none);
    EXPECT_EQ(versions.geometry + versions.surfaces + versions.lights + versions.camera, 0u);
    SceneChanges moved = none;
    moved.lights = true;
    versions.follow(moved);
    EXPECT_EQ(versions.lights, 1u);
    SceneChanges painted = none;
    painted.painted = {0};
    versions.follow(painted);
    EXPECT_EQ(versions.surfaces, 1u);
    EXPECT_EQ(versions.paint, 1u);
    EXPECT_EQ(versions.geometry + versions.camera + versions.relief + versions.pattern, 0u);
}

}  // namespace
}  // namespace lanthorn::gi
