#include "engine/replay/recording_v2.h"

#include "engine/replay/chunk.h"
#include "engine/replay/header_json.h"
#include "engine/replay/steps_chunk.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::replay {

namespace {

struct ChunkV2 {
    ChunkKind kind;
    std::size_t begin;  // of the body, in the file
    std::span<const std::byte> body;
};

ChunkV2 read_chunk_v2(Reader& reader) {
    const std::size_t from = reader.at();
    const auto kind = reader.get<std::uint32_t>();
    const auto length = reader.get<std::uint32_t>();
    const std::uint32_t both[2] = {kind, length};
    if (reader.get<std::uint32_t>() !=
        static_cast<std::uint32_t>(hash_bytes(std::as_bytes(std::span(both))))) {
        reader.fail("damaged: the head of a chunk does not match its checksum");
    }
    const std::size_t begin = reader.at();
    const auto body = reader.take(length);
    const std::uint64_t hash = hash_bytes(reader.taken_since(from));
    if (reader.get<std::uint64_t>() != hash) {
        reader.fail("damaged: a chunk does not match its checksum");
    }
    return {static_cast<ChunkKind>(kind), begin, body};
}

RecordedStep read_step(Reader& reader, const RecordingHeader& header, std::vector<std::uint64_t>& before) {
    RecordedStep step;
    const auto input = reader.take(header.input_size);
    step.input.assign(input.begin(), input.end());
    const auto readings = reader.get<std::uint32_t>();
    if (readings > reader.left() / kReadingBytes) {
        reader.fail(fmt::format("found {} sensor readings, more than the chunk has room for", readings));
    }
    for (std::uint32_t i = 0; i < readings; ++i) {
        const auto sensor = reader.get<std::uint32_t>();
        if (sensor >= header.sensors.size()) {
            reader.fail(fmt::format("found a reading of sensor {}, expected less than {}", sensor,
                                    header.sensors.size()));
        }
        const auto age = reader.get<std::uint32_t>();
        step.sensors.push_back({sensor, age, reader.get<float>()});
    }
    std::vector<std::uint64_t> hashes(header.parts.size());
    for (std::uint64_t& hash : hashes) {
        hash = reader.get<std::uint64_t>();
    }
    mark_state(hashes, before, step);
    return step;
}

void read_steps(const std::string& path, const ChunkV2& chunk, Recording& recording,
                std::vector<std::uint64_t>& before) {
    Reader reader(path, chunk.body, chunk.begin);
    try {
        const auto first = reader.get<std::uint64_t>();
        if (first != recording.steps.size()) {
            reader.fail(fmt::format("found steps from {} on, expected them from {} on", first,
                                    recording.steps.size()));
        }
        auto count = reader.get<std::uint32_t>();
        const std::size_t least = std::size_t{recording.header.input_size} + sizeof(std::uint32_t) +
                                  recording.header.parts.size() * sizeof(std::uint64_t);
        if (count > reader.left() / least) {
            reader.fail(fmt::format("found {} steps, more than the chunk has room for", count));
        }
        for (; count > 0; --count) {
            recording.steps.push_back(read_step(reader, recording.header, before));
        }
    } catch (const EndsHere&) {
        reader.fail("a chunk of steps is shorter than it says");
    }
    if (reader.left() != 0) {
        reader.fail("a chunk of steps is longer than it says");
    }
}

}  // namespace

RecordingHeader read_head_v2(Reader& reader) {
    const ChunkV2 chunk = read_chunk_v2(reader);
    if (chunk.kind != kHead) {
        reader.fail("found a chunk of another kind, expected the header");
    }
    const auto* begin = reinterpret_cast<const char*>(chunk.body.data());
    return header_from_text({begin, chunk.body.size()}, reader.file(), kRecordingVersion2);
}

void read_steps_v2(Reader& reader, Recording& recording) {
    std::vector<std::uint64_t> before;
    for (;;) {
        const ChunkV2 chunk = read_chunk_v2(reader);
        if (chunk.kind == kDone) {
            read_end_body(reader, chunk.body, recording);
            return;
        }
        if (chunk.kind != kSteps) {
            reader.fail("found a chunk of another kind, expected steps or the end");
        }
        read_steps(reader.file(), chunk, recording, before);
    }
}

}  // namespace lanthorn::replay
