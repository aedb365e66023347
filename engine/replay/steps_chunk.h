// Steps as the bytes of a chunk: column by column, because neighbours in a column are alike.
#pragma once

#include <cstddef>
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

// Throws InputError unless the body of the last chunk counts the recording's steps, and the file ends there.
void read_end_body(const Reader& file, std::span<const std::byte> body, const Recording& recording);

}  // namespace lanthorn::replay
