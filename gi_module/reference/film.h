// What samples add up to: a mean and its own noise, from two halves that know nothing of each other.
//
// Samples are summed in blocks of kBlock that follow each other, and block sums in their order. So a block
// can be summed elsewhere, by another process say, and the picture is the same to the bit.
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

    static constexpr std::uint32_t kBlock = 64;  // samples

    // Adds sample number `sample` to a pixel; numbers of a pixel do not fall. A value that is NaN or infinite
    // is left out, not spread: returns false. Different pixels may be added to at the same time.
    bool add(std::size_t pixel, std::uint32_t sample, const vec3& value);
    // Adds what samples of a single block, a later one than any here, have summed up to in another film of
    // this size: to `count` pixels from `first` on.
    void add_block(const Film& other, std::size_t first, std::size_t count);

    // Three channels a pixel, rows from the top; 0 without samples.
    std::vector<float> mean() const;
    // The estimated relRMSE of mean() against the truth: with a and b the means of the halves of n_a and n_b
    // samples, E (a - b)^2 n_a n_b / (n_a + n_b)^2 is the variance of the mean of all. Over all pixels and
    // channels that are not 0 in all channels, divided by their mean. 0 for a black image, infinite with
    // fewer than two samples. O(pixels).
    double noise() const;

    ivec2 size() const { return size_; }
    bool empty() const { return pixels_.empty(); }

    // A pixel's sums: of even and of odd samples. Written to files as it is.
    struct Half {
        dvec3 before{0};  // of whole blocks
        dvec3 last{0};    // of the block `block`
        std::uint32_t count = 0;
        std::uint32_t block = 0;

        dvec3 sum() const { return before + last; }
    };
    using Pixel = std::array<Half, 2>;
    std::vector<Pixel>& pixels() { return pixels_; }
    const std::vector<Pixel>& pixels() const { return pixels_; }

  private:
    ivec2 size_{0};
    std::vector<Pixel> pixels_;
};

}  // namespace lanthorn::reference
