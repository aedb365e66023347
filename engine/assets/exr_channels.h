// Which channels of a file of many make the picture.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lanthorn {

// Places in `names` of at most four, in the picture's order: R, G, B and A where there are R, G and B, else
// those of the first layer by name, A last. Layers are what stands before the last dot.
std::vector<std::size_t> chosen_channels(const std::vector<std::string>& names);

// Whether chosen channels of these names begin with red, green and blue.
bool are_colours(const std::vector<std::string>& names);

}  // namespace lanthorn
