#include "engine/replay/recording_format.h"

#include <algorithm>

#include "engine/replay/annotations.h"
#include "engine/replay/header_json.h"
#include "engine/replay/recording_v2.h"
#include "engine/replay/steps_chunk.h"

namespace lanthorn::replay {

namespace {

constexpr std::string_view kMagic = "LANTHREC";
constexpr double kPackedSeconds = 10;  // of a chunk of steps

void read_steps(const Reader& file, const Chunk& chunk, Recording& recording) {
    Reader reader(file.file(), std::as_bytes(std::span(chunk.body)), chunk.begin);
    try {
        read_steps_body(reader, recording);
    } catch (const EndsHere&) {
        reader.fail("a chunk of steps is shorter than it says");
    }
    if (reader.left() != 0) {
        reader.fail("a chunk of steps is longer than it says");
    }
}

// False at the end.
bool read_next(Reader& reader, Recording& recording) {
    const Chunk chunk = read_chunk(reader);
    if (chunk.kind == kDone) {
        read_end_body(reader, std::as_bytes(std::span(chunk.body)), recording);
        return false;
    }
    if (chunk.kind == kSteps) {
        read_steps(reader, chunk, recording);
        return true;
    }
    try {
        read_annotation(reader, chunk, recording.annotations);
    } catch (const EndsHere&) {
        reader.fail(fmt::format("a {} chunk is shorter than it says", letters_of(chunk.kind)));
    }
    return true;
}

RecordingHeader read_head(Reader& reader) {
    const Chunk chunk = read_chunk(reader);
    if (chunk.kind != kHead) {
        reader.fail("found a chunk of another kind, expected the header");
    }
    return header_from_text(chunk.body, reader.file(), kRecordingVersion);
}

}  // namespace

std::string encoded_beginning(const RecordingHeader& header, Packing packing) {
    Writer writer;
    writer.put_bytes(kMagic);
    writer.put(kRecordingVersion);
    return writer.text() + encoded_chunk(kHead, header_text(header), packing);
}

std::string encoded_steps(const RecordingHeader& header, std::uint64_t first,
                          std::span<const RecordedStep> steps, Packing packing) {
    return encoded_chunk(kSteps, steps_body(header, first, steps), packing);
}

std::string encoded_end(std::uint64_t count) {
    Writer writer;
    writer.put(count);
    return encoded_chunk(kDone, writer.text(), Packing::plain);
}

std::string encoded_recording(const Recording& recording) {
    const RecordingHeader& header = recording.header;
    std::string file =
        encoded_beginning(header, Packing::zstd) + encoded_annotations(recording.annotations, Packing::zstd);
    // Ten seconds, and no more than a chunk may hold, readings not counted.
    const std::size_t most = kMostBody / 4 / (header.input_size + 16 + 2 * header.parts.size());
    const std::size_t chunk = std::clamp<std::size_t>(
        static_cast<std::size_t>(kPackedSeconds * header.step_rate), 1, std::max<std::size_t>(most, 1));
    const std::span steps(recording.steps);
    for (std::size_t first = 0; first < steps.size(); first += chunk) {
        file += encoded_steps(header, first, steps.subspan(first, std::min(chunk, steps.size() - first)),
                              Packing::zstd);
    }
    return file + (recording.cut_off.empty() ? encoded_end(steps.size()) : "");
}

Recording decoded_recording(const std::string& path, std::span<const std::byte> bytes) {
    Reader reader(path, bytes);
    Recording recording;
    std::uint32_t version = 0;
    try {
        const auto magic = reader.take(kMagic.size());
        if (std::memcmp(magic.data(), kMagic.data(), kMagic.size()) != 0) {
            throw InputError(path, "", "not a recording: expected it to begin with LANTHREC");
        }
        version = reader.get<std::uint32_t>();
        if (version != kRecordingVersion && version != kRecordingVersion2) {
            throw InputError(path, "",
                             fmt::format("found version {} of the format, expected {} or {}; {}", version,
                                         kRecordingVersion2, kRecordingVersion,
                                         version > kRecordingVersion ? "a later program recorded it"
                                                                     : "record the session again"));
        }
        recording.header = version == kRecordingVersion ? read_head(reader) : read_head_v2(reader);
    } catch (const EndsHere&) {
        throw InputError(
            path, "",
            fmt::format("ends after {} bytes, within its header: expected a recording", bytes.size()));
    }
    try {
        if (version == kRecordingVersion2) {
            read_steps_v2(reader, recording);
            return recording;
        }
        while (read_next(reader, recording)) {
        }
    } catch (const EndsHere&) {
        recording.cut_off =
            fmt::format("cut off at byte {}: the session did not end; its first {} steps are whole",
                        bytes.size(), recording.steps.size());
    }
    return recording;
}

}  // namespace lanthorn::replay
