#include "engine/replay/recording_format.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::replay {

static_assert(std::endian::native == std::endian::little, "recordings are little-endian");

namespace {

constexpr char kMagic[8] = {'L', 'A', 'N', 'T', 'H', 'R', 'E', 'C'};
constexpr std::size_t kReadingBytes = sizeof(std::uint32_t) + sizeof(std::uint32_t) + sizeof(float);

class Writer {
  public:
    template <class T>
    void put(T value) {
        text_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_bytes(std::span<const std::byte> from) {
        text_.append(reinterpret_cast<const char*>(from.data()), from.size());
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// Thrown where the bytes end too early.
struct EndsHere {};

class Reader {
  public:
    // `begin`: where in the file `bytes` are.
    Reader(const std::string& file, std::span<const std::byte> bytes, std::size_t begin = 0)
        : file_(file), bytes_(bytes), begin_(begin) {}

    template <class T>
    T get() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    // Throws EndsHere where there are not as many.
    std::span<const std::byte> take(std::size_t count) {
        if (count > left()) {
            throw EndsHere{};
        }
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    std::span<const std::byte> taken_since(std::size_t from) const {
        return bytes_.subspan(from, at_ - from);
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t at() const { return begin_ + at_; }  // in the file
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(file_, fmt::format("byte {}", at()), problem);
    }

  private:
    const std::string& file_;
    std::span<const std::byte> bytes_;
    std::size_t begin_;
    std::size_t at_ = 0;
};

struct Chunk {
    ChunkKind kind;
    std::size_t begin;  // of the body, in the file
    std::span<const std::byte> body;
};

std::uint32_t check_of(std::uint32_t kind, std::uint32_t length) {
    const std::uint32_t both[2] = {kind, length};
    return static_cast<std::uint32_t>(hash_bytes(std::as_bytes(std::span(both))));
}

std::string encoded_chunk(ChunkKind kind, const std::string& body) {
    Writer writer;
    const auto number = static_cast<std::uint32_t>(kind);
    const auto length = static_cast<std::uint32_t>(body.size());
    writer.put(number);
    writer.put(length);
    writer.put(check_of(number, length));
    writer.put_bytes(std::as_bytes(std::span(body)));
    writer.put(hash_bytes(std::as_bytes(std::span(writer.text()))));
    return writer.text();
}

// Throws EndsHere where the chunk is not whole.
Chunk read_chunk(Reader& reader) {
    const std::size_t from = reader.at();
    const auto kind = reader.get<std::uint32_t>();
    const auto length = reader.get<std::uint32_t>();
    if (reader.get<std::uint32_t>() != check_of(kind, length)) {
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

nlohmann::json to_json(const RecordingHeader& h) {
    return {{"level", h.level},           {"level_hash", h.level_hash}, {"seed", h.seed},
            {"step_rate", h.step_rate},   {"build", h.build},           {"input_format", h.input_format},
            {"input_size", h.input_size}, {"parts", h.parts},           {"sensors", h.sensors}};
}

template <class T>
const char* expectation() {
    return std::is_same_v<T, std::string> ? "a string"
           : std::is_arithmetic_v<T>      ? "a number"
                                          : "a list of strings";
}

template <class T>
void read_member(const nlohmann::json& j, const char* name, T& to, const std::string& path) {
    const std::string place = std::string("header: ") + name;
    const auto found = j.is_object() ? j.find(name) : j.end();
    if (found == j.end()) {
        throw InputError(path, place, fmt::format("is missing, expected {}", expectation<T>()));
    }
    try {
        found->get_to(to);
    } catch (const nlohmann::json::exception&) {
        throw InputError(path, place,
                         fmt::format("found {:.60}, expected {}",
                                     found->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace),
                                     expectation<T>()));
    }
}

RecordingHeader header_from_json(const nlohmann::json& j, const std::string& path) {
    RecordingHeader h;
    read_member(j, "level", h.level, path);
    read_member(j, "level_hash", h.level_hash, path);
    read_member(j, "seed", h.seed, path);
    read_member(j, "step_rate", h.step_rate, path);
    read_member(j, "build", h.build, path);
    read_member(j, "input_format", h.input_format, path);
    read_member(j, "input_size", h.input_size, path);
    read_member(j, "parts", h.parts, path);
    read_member(j, "sensors", h.sensors, path);
    return h;
}

RecordingHeader read_beginning(Reader& reader, const std::string& path) {
    const auto magic = reader.take(sizeof kMagic);
    if (std::memcmp(magic.data(), kMagic, sizeof kMagic) != 0) {
        throw InputError(path, "", "not a recording: expected it to begin with LANTHREC");
    }
    const auto version = reader.get<std::uint32_t>();
    if (version != kRecordingVersion) {
        throw InputError(path, "",
                         fmt::format("found version {} of the format, expected {}; record the session anew",
                                     version, kRecordingVersion));
    }
    const Chunk chunk = read_chunk(reader);
    if (chunk.kind != ChunkKind::head) {
        reader.fail("found a chunk of another kind, expected the header");
    }
    const auto* begin = reinterpret_cast<const char*>(chunk.body.data());
    return header_from_json(parse_json({begin, chunk.body.size()}, path + ": header"), path);
}

RecordedStep read_step(Reader& reader, const RecordingHeader& header) {
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
    for (std::size_t i = 0; i < header.parts.size(); ++i) {
        step.hashes.push_back(reader.get<std::uint64_t>());
    }
    return step;
}

void read_steps(const std::string& path, const Chunk& chunk, Recording& recording) {
    Reader reader(path, chunk.body, chunk.begin);
    try {
        const auto first = reader.get<std::uint64_t>();
        if (first != recording.steps.size()) {
            reader.fail(fmt::format("found steps from {} on, expected them from {} on", first,
                                    recording.steps.size()));
        }
        for (auto count = reader.get<std::uint32_t>(); count > 0; --count) {
            recording.steps.push_back(read_step(reader, recording.header));
        }
    } catch (const EndsHere&) {
        reader.fail("a chunk of steps is shorter than it says");
    }
    if (reader.left() != 0) {
        reader.fail("a chunk of steps is longer than it says");
    }
}

void read_end(Reader& file, const Chunk& chunk, const Recording& recording) {
    std::uint64_t count = 0;
    if (chunk.body.size() == sizeof count) {
        std::memcpy(&count, chunk.body.data(), sizeof count);
    }
    if (chunk.body.size() != sizeof count || count != recording.steps.size()) {
        file.fail(fmt::format("found {} steps, expected {}", recording.steps.size(), count));
    }
    if (file.left() != 0) {
        file.fail(fmt::format("found {} bytes behind the end", file.left()));
    }
}

}  // namespace

std::string encoded_beginning(const RecordingHeader& header) {
    Writer writer;
    writer.put_bytes(std::as_bytes(std::span(kMagic)));
    writer.put(kRecordingVersion);
    return writer.text() + encoded_chunk(ChunkKind::head, to_json(header).dump());
}

std::string encoded_steps([[maybe_unused]] const RecordingHeader& header, std::uint64_t first,
                          std::span<const RecordedStep> steps) {
    Writer writer;
    writer.put(first);
    writer.put(static_cast<std::uint32_t>(steps.size()));
    for (const RecordedStep& step : steps) {
        assert(step.input.size() == header.input_size);
        assert(step.hashes.size() == header.parts.size());
        writer.put_bytes(step.input);
        writer.put(static_cast<std::uint32_t>(step.sensors.size()));
        for (const SensorReading& reading : step.sensors) {
            writer.put(reading.sensor);
            writer.put(reading.age);
            writer.put(reading.value);
        }
        writer.put_bytes(std::as_bytes(std::span(step.hashes)));
    }
    return encoded_chunk(ChunkKind::steps, writer.text());
}

std::string encoded_end(std::uint64_t count) {
    Writer writer;
    writer.put(count);
    return encoded_chunk(ChunkKind::done, writer.text());
}

Recording decoded_recording(const std::string& path, std::span<const std::byte> bytes) {
    Reader reader(path, bytes);
    Recording recording;
    try {
        recording.header = read_beginning(reader, path);
    } catch (const EndsHere&) {
        throw InputError(
            path, "",
            fmt::format("ends after {} bytes, within its header: expected a recording", bytes.size()));
    }
    try {
        for (;;) {
            const Chunk chunk = read_chunk(reader);
            if (chunk.kind == ChunkKind::done) {
                read_end(reader, chunk, recording);
                return recording;
            }
            if (chunk.kind != ChunkKind::steps) {
                reader.fail("found a chunk of another kind, expected steps or the end");
            }
            read_steps(path, chunk, recording);
        }
    } catch (const EndsHere&) {
        recording.cut_off =
            fmt::format("cut off at byte {}: the session did not end; its first {} steps are whole",
                        bytes.size(), recording.steps.size());
    }
    return recording;
}

}  // namespace lanthorn::replay
