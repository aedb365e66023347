// What is right: a closed form, or the path-traced reference with its own noise.
#pragma once

#include <vector>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::extremes {

struct Truth {
    std::vector<float> lux;  // indirect irradiance, three floats a pixel, rows from the top
    double noise = 0;        // its own relRMSE, by its two halves
};

Truth constant_truth(double lux, ivec2 size);
Truth traced_truth(const FrameScene& scene, ivec2 size, int bounces, int spp);

// The same picture in a light so much stronger.
Truth brighter(Truth truth, double gain);

struct Difference {
    // Root of the summed squares over the values that are not 0 in truth, over the mean of those: a dark half
    // adds what leaks into it, and does not make the lit half's error sqrt(2) times as large. Less the
    // truth's own noise: sqrt(measured^2 - noise^2), 0 if that is negative.
    double rel_rmse = 0;
    double flux_ratio = 0;  // mean over the truth's mean; 1 where both are 0
    double dark = 0;        // share of values that are 0 in truth
    double leak = 0;        // their mean over the truth's mean; 0 where there are none
};

Difference difference(const std::vector<float>& lux, const Truth& truth);

}  // namespace lanthorn::extremes
