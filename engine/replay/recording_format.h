// The bytes of a recording (recording.h describes them).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

enum class ChunkKind : std::uint32_t { head = 0x44414548, steps = 0x50455453, done = 0x454e4f44 };

// What a file begins with: magic, version and the chunk of the header.
std::string encoded_beginning(const RecordingHeader& header);

// A chunk of steps, the first of them number `first`. Their inputs and hashes must be as many as the header
// says.
std::string encoded_steps(const RecordingHeader& header, std::uint64_t first,
                          std::span<const RecordedStep> steps);

// The chunk that a session of `count` steps ends with.
std::string encoded_end(std::uint64_t count);

// The contents of a file. Throws InputError, with `path` in it, as read_recording does.
Recording decoded_recording(const std::string& path, std::span<const std::byte> bytes);

}  // namespace lanthorn::replay
