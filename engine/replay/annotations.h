// What a recording holds beside its steps, as chunks.
#pragma once

#include <string>

#include "engine/replay/chunk.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

inline constexpr ChunkKind kMarkChunk = chunk_kind("MARK"), kExpectationChunk = chunk_kind("XPCT"),
                           kNoteChunk = chunk_kind("NOTE"), kLogChunk = chunk_kind("LOG_"),
                           kStateChunk = chunk_kind("SNAP"), kLineChunk = chunk_kind("LINE");

// Takes a chunk that is none of the steps' in. Throws InputError, also for one of an unknown kind that may
// not be passed over; EndsHere for one that is too short.
void read_annotation(const Reader& reader, const Chunk& chunk, Annotations& annotations);

}  // namespace lanthorn::replay
