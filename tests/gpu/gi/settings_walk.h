// Every declared gi.* setting, changed under a technique at work.
#pragma once

#include <string>
#include <vector>

#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

// From the settings `base` ("NAME=VALUE") changes each declared setting of the indirect light alone, and
// back. Fails where the picture `frames` frames later is not, bit for bit, that of a technique that has known
// no other settings. `frames`: that a still picture needs until it changes no more. Returns the names of
// those that altered the picture. `by_history`: those that make the picture depend on what was remembered
// before; changed back they must leave nothing.
std::vector<std::string> walk_settings(const FrameScene& scene, const std::vector<std::string>& base,
                                       int frames, const std::vector<std::string>& by_history = {});

}  // namespace lanthorn::gi::test
