// A float image in memory: what is read from a file (assets/image_io.h), read back from the GPU, or compared.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace lanthorn {

// Interleaved channels, rows from the top.
struct ImageF {
    int width = 0;
    int height = 0;
    int channels = 0;                             // 1 to 4
    std::vector<float> pixels;                    // width * height * channels
    std::map<std::string, std::string> metadata;  // kept by EXR and PNG files
    bool linear =
        false;  // of an image that was read: its file holds floating-point numbers, not display-encoded ones

    // Column `x` from the left, row `y` from the top, channel `c`; all must be inside, which is not checked.
    float& at(int x, int y, int c) { return pixels[index(x, y, c)]; }
    // The same to read.
    float at(int x, int y, int c) const { return pixels[index(x, y, c)]; }

  private:
    std::size_t index(int x, int y, int c) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(c);
    }
};

}  // namespace lanthorn
