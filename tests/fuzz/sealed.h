// Files with checksums: damage would never get past them. These put the right sums onto damaged bytes.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn::fuzz {

// A recording (engine/replay/include/lanthorn/replay/recording.h): lengths are shortened to what is there,
// checks and hashes made right.
std::string sealed_recording(std::string_view bytes);

// A checkpoint of the path tracer: mark, contents, and the hash of the contents.
std::string sealed_checkpoint(std::string_view bytes);

}  // namespace lanthorn::fuzz
