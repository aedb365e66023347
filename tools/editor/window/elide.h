// Names for which there is too little room.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace lanthorn::edit_window {

// The text as it is where it is at most `room` wide, by `width_of`; else its beginning and its end with "..."
// between them, as many characters (UTF-8) as fit: numbered names differ at their ends. Where not even two
// characters fit, the dots alone.
std::string elided(std::string_view text, float room, const std::function<float(std::string_view)>& width_of);

}  // namespace lanthorn::edit_window
