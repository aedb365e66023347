// What `drm` counts in a frame: a part of its GiStatistics.
#pragma once

namespace lanthorn::gi {

struct DrmStatistics {
    int pictures = 0;         // of lights, that samples are of
    int left_out = 0;         // pictures of lights beyond gi.drm.lights
    int dark = 0;             // lights of no power, which have none
    int samples = 0;          // that every pixel is lit by
    int sample_pictures = 0;  // samples that have a picture of what they see
    int faces_drawn = 0;      // of pictures of emissive surfaces and of samples, in this frame
    int mirrored = 0;  // texels of pictures whose light mirrors or glass send on, when samples were made last
    bool sampled = false;   // samples were made in this frame
    bool gathered = false;  // pixels were lit
};

}  // namespace lanthorn::gi
