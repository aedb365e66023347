// Whole frames of a small room.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace {

using testing::SceneBuilder;

class Picture : public ::testing::TestWithParam<bool> {};

TEST_P(Picture, SmallRoom) {
    testing::context();
    render::FrameRenderer renderer;
    const FrameScene scene = testing::small_room(1, GetParam()).build();
    testing::render_once(renderer, scene, {512, 512});
    const ImageF final = renderer.read(render::Aov::final);
    testing::save_picture(final, GetParam() ? "room-area" : "room-point");
    testing::save_picture(renderer.read(render::Aov::albedo), "room-albedo");
    EXPECT_EQ(renderer.nan_count(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Lamps, Picture, ::testing::Bool());

}  // namespace
}  // namespace lanthorn
