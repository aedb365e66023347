// The sky as the path tracer draws from it.
#pragma once

#include <memory>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

class SkyLight {
  public:
    struct Sample {
        vec3 direction{0, 1, 0};  // unit, render space, towards the sky
        vec3 radiance{0};         // nits
        float density = 1;        // per steradian, > 0
    };

    SkyLight() = default;  // black
    // O(pixels of the image), once a frame at most: keep it while FrameScene::sky stays equal.
    explicit SkyLight(const FrameScene& scene);

    bool empty() const { return !image_; }
    // Nits that the sky sends to whom it lights, and that the camera sees; 0 if empty.
    vec3 radiance(const vec3& direction) const;
    vec3 shown(const vec3& direction) const;
    // A direction by the image's luminance, an eighth of them evenly over the sphere; u in [0, 1)^2. Not for
    // an empty one. O(log pixels).
    Sample draw(const vec2& u) const;
    // With which draw() finds a direction; 0 if empty.
    float density(const vec3& direction) const;

  private:
    std::size_t cell_of(const vec2& place) const;
    float cell_density(std::size_t cell) const;

    std::shared_ptr<const SkyImage> image_, shown_;
    vec3 scale_{1};
    mat3 to_sky_{1};
    SkyImage coarse_;                 // what is drawn from: constant by pixel
    std::vector<double> cumulative_;  // by pixel of it: probability of that one or one before it
};

}  // namespace lanthorn::reference
