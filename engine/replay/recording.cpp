#include "lanthorn/replay/recording.h"

#include <bit>
#include <cassert>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/state_hash.h"

namespace lanthorn::replay {

static_assert(std::endian::native == std::endian::little, "recordings are little-endian");

namespace {

constexpr char kMagic[8] = {'L', 'A', 'N', 'T', 'H', 'R', 'E', 'C'};
constexpr std::uint32_t kStepMark = 0x50455453;
constexpr std::uint32_t kEndMark = 0x444e4521;

class Writer {
  public:
    template <class T>
    void put(T value) {
        text_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_bytes(std::span<const std::byte> from) {
        text_.append(reinterpret_cast<const char*>(from.data()), from.size());
    }
    std::span<const std::byte> bytes() const { return std::as_bytes(std::span(text_)); }

  private:
    std::string text_;
};

class Reader {
  public:
    Reader(const std::string& file, std::span<const std::byte> bytes) : file_(file), bytes_(bytes) {}

    template <class T>
    T get() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    std::span<const std::byte> take(std::size_t count) {
        if (count > bytes_.size() - at_) {
            fail("file ends here, expected " + std::to_string(count) + " more bytes");
        }
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t at() const { return at_; }
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(file_, "byte " + std::to_string(at_), problem);
    }

  private:
    const std::string& file_;
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

nlohmann::json to_json(const RecordingHeader& h) {
    return {{"level", h.level},           {"level_hash", h.level_hash}, {"seed", h.seed},
            {"step_rate", h.step_rate},   {"build", h.build},           {"input_format", h.input_format},
            {"input_size", h.input_size}, {"parts", h.parts},           {"sensors", h.sensors}};
}

RecordingHeader header_from_json(const nlohmann::json& j) {
    RecordingHeader h;
    j.at("level").get_to(h.level);
    j.at("level_hash").get_to(h.level_hash);
    j.at("seed").get_to(h.seed);
    j.at("step_rate").get_to(h.step_rate);
    j.at("build").get_to(h.build);
    j.at("input_format").get_to(h.input_format);
    j.at("input_size").get_to(h.input_size);
    j.at("parts").get_to(h.parts);
    j.at("sensors").get_to(h.sensors);
    return h;
}

RecordingHeader read_header(Reader& reader, const std::string& path) {
    const auto magic = reader.take(sizeof kMagic);
    if (std::memcmp(magic.data(), kMagic, sizeof kMagic) != 0) {
        throw InputError(path, "", "not a recording: expected it to begin with LANTHREC");
    }
    const auto version = reader.get<std::uint32_t>();
    if (version != kRecordingVersion) {
        throw InputError(path, "",
                         "found version " + std::to_string(version) + " of the format, expected " +
                             std::to_string(kRecordingVersion) + "; record the session anew");
    }
    const auto length = reader.get<std::uint32_t>();
    const auto text = reader.take(length);
    try {
        const auto* begin = reinterpret_cast<const char*>(text.data());
        return header_from_json(nlohmann::json::parse(begin, begin + text.size()));
    } catch (const nlohmann::json::exception& e) {
        throw InputError(path, "header", std::string("not as expected: ") + e.what());
    }
}

void check_whole(const std::string& path, std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof kMagic + sizeof(std::uint64_t)) {
        throw InputError(path, "", "found " + std::to_string(bytes.size()) + " bytes, expected a recording");
    }
    std::uint64_t stored = 0;
    std::memcpy(&stored, bytes.data() + bytes.size() - sizeof stored, sizeof stored);
    if (hash_bytes(bytes.first(bytes.size() - sizeof stored)) != stored) {
        throw InputError(path, "", "cut short or damaged: its checksum does not match its contents");
    }
}

}  // namespace

void write_recording(const std::string& path, const Recording& recording) {
    Writer writer;
    writer.put_bytes(std::as_bytes(std::span(kMagic)));
    writer.put(kRecordingVersion);
    const std::string header = to_json(recording.header).dump();
    writer.put(static_cast<std::uint32_t>(header.size()));
    writer.put_bytes(std::as_bytes(std::span(header)));
    for (const RecordedStep& step : recording.steps) {
        assert(step.input.size() == recording.header.input_size);
        assert(step.hashes.size() == recording.header.parts.size());
        writer.put(kStepMark);
        writer.put_bytes(step.input);
        writer.put(static_cast<std::uint32_t>(step.sensors.size()));
        for (const SensorReading& reading : step.sensors) {
            writer.put(reading.sensor);
            writer.put(reading.value);
        }
        writer.put_bytes(std::as_bytes(std::span(step.hashes)));
    }
    writer.put(kEndMark);
    writer.put(std::uint64_t{recording.steps.size()});
    writer.put(hash_bytes(writer.bytes()));
    const std::span<const std::byte> whole = writer.bytes();
    write_file(path, {reinterpret_cast<const char*>(whole.data()), whole.size()});
}

Recording read_recording(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "cannot be opened");
    }
    const std::vector<char> file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const auto bytes = std::as_bytes(std::span(file));
    Reader reader(path, bytes);
    Recording recording;
    recording.header = read_header(reader, path);
    check_whole(path, bytes);
    const std::size_t parts = recording.header.parts.size();
    for (;;) {
        const auto mark = reader.get<std::uint32_t>();
        if (mark == kEndMark) {
            break;
        }
        if (mark != kStepMark) {
            reader.fail("expected a step or the end");
        }
        RecordedStep step;
        const auto input = reader.take(recording.header.input_size);
        step.input.assign(input.begin(), input.end());
        const auto readings = reader.get<std::uint32_t>();
        if (readings > reader.left() / 8) {
            reader.fail("found " + std::to_string(readings) +
                        " sensor readings, more than the file has room for");
        }
        for (std::uint32_t i = 0; i < readings; ++i) {
            const auto sensor = reader.get<std::uint32_t>();
            if (sensor >= recording.header.sensors.size()) {
                reader.fail("found a reading of sensor " + std::to_string(sensor) + ", expected less than " +
                            std::to_string(recording.header.sensors.size()));
            }
            step.sensors.push_back({sensor, reader.get<float>()});
        }
        for (std::size_t i = 0; i < parts; ++i) {
            step.hashes.push_back(reader.get<std::uint64_t>());
        }
        recording.steps.push_back(std::move(step));
    }
    const auto count = reader.get<std::uint64_t>();
    if (count != recording.steps.size() || reader.left() != sizeof(std::uint64_t)) {
        reader.fail("found " + std::to_string(recording.steps.size()) + " steps, expected " +
                    std::to_string(count));
    }
    return recording;
}

}  // namespace lanthorn::replay
