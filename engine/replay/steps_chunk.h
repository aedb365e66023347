// Steps as the bytes of a chunk: column by column, because neighbours in a column are alike.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/replay/byte_stream.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

std::string steps_body(const RecordingHeader& header, std::uint64_t first,
                       std::span<const RecordedStep> steps);

// Appends the steps of a chunk's body to the recording. Throws EndsHere where the body is too short,
// InputError where it cannot be one.
void read_steps_body(Reader& reader, Recording& recording);

}  // namespace lanthorn::replay
