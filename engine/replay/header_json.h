// A recording's header as JSON, which is how the file holds it.
#pragma once

#include <string>
#include <string_view>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

std::string header_text(const RecordingHeader& header);

// Throws InputError naming the member that is missing or not as expected. `version`: of the file; 2 has no
// schemas.
RecordingHeader header_from_text(std::string_view text, const std::string& path, std::uint32_t version);

}  // namespace lanthorn::replay
