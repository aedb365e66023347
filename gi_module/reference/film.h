// What samples add up to: a mean and its own noise, from two halves that know nothing of each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::reference {

class Film {
  public:
    Film() = default;
    explicit Film(ivec2 size);

    // Adds sample number `sample` to a pixel. A value that is NaN or infinite is left out, not spread:
    // returns false. Different pixels may be added to at the same time.
    bool add(std::size_t pixel, std::uint32_t sample, const vec3& value);

    // Three channels a pixel, rows from the top; 0 without samples.
    std::vector<float> mean() const;
    // The estimated relRMSE of mean() against the truth: with a and b the means of the halves of n_a and n_b
    // samples, E (a - b)^2 n_a n_b / (n_a + n_b)^2 is the variance of the mean of all. Over all pixels and
    // channels that are not 0 in all channels, divided by their mean. 0 for a black image, infinite with
    // fewer than two samples. O(pixels).
    double noise() const;

    ivec2 size() const { return size_; }
    bool empty() const { return pixels_.empty(); }

    // A pixel's sums: of even and of odd samples.
    struct Half {
        dvec3 sum{0};
        std::uint32_t count = 0;
        std::uint32_t reserved = 0;  // no padding: written to files as it is
    };
    using Pixel = std::array<Half, 2>;
    std::vector<Pixel>& pixels() { return pixels_; }
    const std::vector<Pixel>& pixels() const { return pixels_; }

  private:
    ivec2 size_{0};
    std::vector<Pixel> pixels_;
};

}  // namespace lanthorn::reference
