// A picture of which a file holds a part.
#pragma once

#include <functional>
#include <vector>

namespace lanthorn {

struct WindowedPicture {
    int x = 0, y = 0, width = 0, height = 0;  // what the file holds, from the corner of the whole
    int full_width = 0, full_height = 0;      // the whole, which may also be smaller
    int channels = 0;
    std::vector<float> pixels;  // of what the file holds
};

// The whole: 0 outside of what the file holds. Takes the pixels.
std::vector<float> whole_of(WindowedPicture picture);

}  // namespace lanthorn
