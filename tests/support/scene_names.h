// Names of tests that every generated scene or level has:
//   testing::ValuesIn(scene_generator::level_scenes()), support::scene_name
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tools/scene_generator/scenes.h"

namespace lanthorn::support {

// "levels_burning_glass" of "levels/burning-glass": a test's name has letters, digits and _ alone.
inline std::string scene_name(const testing::TestParamInfo<scene_generator::NamedScene>& of) {
    std::string name = of.param.name;
    std::ranges::replace_if(
        name, [](char c) { return c == '-' || c == '/'; }, '_');
    return name;
}

}  // namespace lanthorn::support
