// How far a picture of indirect light is from two independent references of it, and how much pictures of one
// place change from frame to frame. Plain functions of images; all O(pixels).
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/workbench/image_error.h"
#include "lanthorn/workbench/metrics.h"

namespace lanthorn::workbench {

// What a picture shows: of each pixel, where its surface is.
struct Surfaces {
    CameraView camera;
    ivec2 size{0};
    float tolerance = 0;          // metres: how far apart points of one surface may seem
    std::vector<vec3> positions;  // render space
    std::vector<vec3> normals;
    std::vector<float> depths;  // metres from the camera; 0: background

    PixelMask seen() const;
};
// From the AOVs depth and normal of a perspective camera. Throws InputError for an orthographic one.
Surfaces surfaces_of(const FrameScene& frame, const ImageF& depth, const ImageF& normal);

// What pictures are compared with, where they are.
struct Truth {
    const ReferencePair* pair;
    PixelMask mask;
    std::vector<float> brightness;  // the reference's luminance, a mean over the neighbours on one surface,
                                    // so that its noise does not weigh pixels; 0 off the mask
};
Truth truth_at(const ReferencePair& pair, const Surfaces& surfaces, PixelMask mask);

// Noise of the references taken off. All 0 where the mask is empty or the reference is black.
ImageError image_error(const ImageF& image, const Truth& truth);

// What relrmse and local would be of the mean of both references, noise not taken off.
ImageError noise_of(const Truth& truth);

// Pixels of the mask with no direct light and less than a hundredth of the indirect light that the reference
// has around them (a single pixel of it may have a hundred times too much by chance), where it has any.
// `direct` in nits, `indirect` in lux.
std::uint64_t unlit_pixels(const ImageF& direct, const ImageF& indirect, const Truth& truth);

// Pixels whose surface is at most so many metres from a box.
PixelMask near_box(const Surfaces& surfaces, const Aabb& box, float metres);

// Where the points that one frame shows lie in the picture of another: of each pixel the four around it with
// their weights. A point counts only where all that weigh show its surface: normals agree and the planes are
// nearer than the tolerance plus 0.4 % of the distance.
class SamePoints {
  public:
    SamePoints(const Surfaces& before, const Surfaces& now);

    const PixelMask& mask() const { return mask_; }
    // An image of `now`, as the pixels of `before` would show it; 0 off the mask.
    ImageF seen_from_before(const ImageF& image) const;

  private:
    struct Place {
        std::uint32_t pixel[4];
        float weight[4];
    };
    PixelMask mask_;
    std::vector<Place> places_;
};

// Mean over the pixels of a mask (empty: all) and their channels of the product of two images' changes, and
// the variance of that mean, pixels (not their channels) taken as independent. 0 where there are no pixels.
struct MeanProduct {
    double mean = 0, variance = 0;
};
MeanProduct mean_product(const ImageF& a_now, const ImageF& a_before, const ImageF& b_now,
                         const ImageF& b_before, const PixelMask& mask = {});

}  // namespace lanthorn::workbench
