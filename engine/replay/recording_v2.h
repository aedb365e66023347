// Recordings of version 2 of the format, which had a whole hash of every part in every step and nothing
// beside steps (docs/replay-format.md).
#pragma once

#include "engine/replay/byte_stream.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

inline constexpr std::uint32_t kRecordingVersion2 = 2;

// What follows magic and version. Throws EndsHere and InputError as the functions of version 3.
RecordingHeader read_head_v2(Reader& reader);
void read_steps_v2(Reader& reader, Recording& recording);

}  // namespace lanthorn::replay
