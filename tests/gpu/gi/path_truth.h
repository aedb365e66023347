// What the path tracer finds, for tests to hold a technique against.
#pragma once

#include <vector>

#include "lanthorn/reference/path_tracer.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

// Twice, three floats a pixel: the noise of the two is not the same, so that errors against both have it
// taken off.
struct Truth {
    std::vector<float> halves[2];
};

// `spp` samples a pixel, both halves together.
Truth path_traced(const FrameScene& scene, ivec2 size, int bounces, int spp,
                  reference::PathAov what = reference::PathAov::indirect);  // or radiance

// One picture with these settings, three floats a pixel.
std::vector<float> path_picture(const FrameScene& scene, ivec2 size, const reference::PathSettings& settings,
                                reference::PathAov what = reference::PathAov::indirect);  // or radiance

// Over all pixels and channels. Fails the test at a pixel that is not finite.
Deviation against(const ImageF& image, const Truth& truth);
// Of a picture whose noise, if it has any, counts as an error.
Deviation against(const ImageF& image, const std::vector<float>& expected);

}  // namespace lanthorn::gi::test
