// The bytes of a recording (docs/replay-format.md describes them).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/replay/chunk.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

// What a file begins with: magic, version and the chunk of the header.
std::string encoded_beginning(const RecordingHeader& header, Packing packing = Packing::plain);

// A chunk of steps, the first of them number `first`. Their inputs must be as many bytes, their changed parts
// among those, that the header says.
std::string encoded_steps(const RecordingHeader& header, std::uint64_t first,
                          std::span<const RecordedStep> steps, Packing packing = Packing::plain);

// A chunk each, all optional.
std::string encoded_annotations(const Annotations& annotations, Packing packing = Packing::plain);

// The chunk that a session of `count` steps ends with.
std::string encoded_end(std::uint64_t count);

// A whole file, packed, in chunks of ten seconds.
std::string encoded_recording(const Recording& recording);

// The contents of a file of version 3 or 2. Throws InputError, with `path` in it, as read_recording does.
Recording decoded_recording(const std::string& path, std::span<const std::byte> bytes);

}  // namespace lanthorn::replay
