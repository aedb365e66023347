// A picture that moves: an animated WebP file, which every browser shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "lanthorn/core/image.h"
#include "lanthorn/core/math.h"

namespace lanthorn::game {

class AnimatedPicture {
  public:
    static constexpr int kLargestSide = 16383;  // pixels, of what the format can say

    // How pictures are coded.
    enum class Coding {
        changes,  // what hardly differs from the picture before stays as it was: small files
        whole,    // each by itself, where much moves in every one
    };

    // Of `size` pixels, at most kLargestSide a side; repeated for ever. `quality`: of the lossy coding,
    // 0..100.
    AnimatedPicture(ivec2 size, float quality, Coding coding = Coding::changes);
    ~AnimatedPicture();
    AnimatedPicture(const AnimatedPicture&) = delete;
    AnimatedPicture& operator=(const AnimatedPicture&) = delete;

    // `picture`: display-encoded, 0..1, 3 or 4 channels of which alpha does not count; of another size it is
    // scaled, the shares of pixels weighed. Shown for `milliseconds`. Throws Error if it cannot be coded.
    // Cost: 20 to 30 ms at 480x270.
    void add(const ImageF& picture, int milliseconds);
    int frames() const { return frames_; }

    // Whole or not at all; at least one picture must be there. Throws InputError if it cannot be written.
    void write(const std::filesystem::path& file);

  private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
    ivec2 size_;
    int frames_ = 0;
    int end_ms_ = 0;
};

}  // namespace lanthorn::game
