#include "engine/replay/steps_chunk.h"

#include <cassert>

namespace lanthorn::replay {

namespace {

std::size_t mask_bytes(const RecordingHeader& header) {
    return (header.parts.size() + 7) / 8;
}

void read_readings(Reader& reader, const RecordingHeader& header, std::span<RecordedStep> steps,
                   std::span<const std::uint32_t> counts) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (counts[i] > reader.left() / kReadingBytes) {
            reader.fail(fmt::format("found {} sensor readings, more than the chunk has room for", counts[i]));
        }
        steps[i].sensors.reserve(counts[i]);
        for (std::uint32_t k = 0; k < counts[i]; ++k) {
            const auto sensor = reader.get<std::uint32_t>();
            if (sensor >= header.sensors.size()) {
                reader.fail(fmt::format("found a reading of sensor {}, expected less than {}", sensor,
                                        header.sensors.size()));
            }
            const auto age = reader.get<std::uint32_t>();
            steps[i].sensors.push_back({sensor, age, reader.get<float>()});
        }
    }
}

void read_changed(Reader& reader, const RecordingHeader& header, std::span<RecordedStep> steps) {
    const auto masks = reader.take(mask_bytes(header) * steps.size());
    for (std::size_t part = 0; part < 8 * mask_bytes(header); ++part) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto mask = std::to_integer<unsigned>(masks[part / 8 * steps.size() + i]);
            if ((mask >> part % 8 & 1u) != 0) {
                if (part >= header.parts.size()) {
                    reader.fail(fmt::format("found a change of part {}, expected less than {}", part,
                                            header.parts.size()));
                }
                steps[i].changed.push_back({static_cast<std::uint8_t>(part), 0});
            }
        }
    }
    for (RecordedStep& step : steps) {
        for (ChangedPart& changed : step.changed) {
            changed.tag = reader.get<std::uint8_t>();
        }
    }
}

}  // namespace

std::string steps_body(const RecordingHeader& header, std::uint64_t first,
                       std::span<const RecordedStep> steps) {
    Writer writer;
    writer.put(first);
    writer.put(static_cast<std::uint32_t>(steps.size()));
    for (std::size_t k = 0; k < header.input_size; ++k) {
        for (const RecordedStep& step : steps) {
            assert(step.input.size() == header.input_size);
            writer.put(step.input[k]);
        }
    }
    for (const RecordedStep& step : steps) {
        writer.put(static_cast<std::uint32_t>(step.sensors.size()));
    }
    for (const RecordedStep& step : steps) {
        for (const SensorReading& reading : step.sensors) {
            writer.put(reading.sensor);
            writer.put(reading.age);
            writer.put(reading.value);
        }
    }
    std::string masks(mask_bytes(header) * steps.size(), '\0');
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const ChangedPart& changed : steps[i].changed) {
            assert(changed.part < header.parts.size());
            char& mask = masks[changed.part / 8u * steps.size() + i];
            mask = static_cast<char>(static_cast<unsigned char>(mask) | 1u << changed.part % 8);
        }
    }
    writer.put_bytes(masks);
    for (const RecordedStep& step : steps) {
        for (const ChangedPart& changed : step.changed) {
            writer.put(changed.tag);
        }
    }
    for (const RecordedStep& step : steps) {
        writer.put(step.root);
    }
    return writer.text();
}

void read_steps_body(Reader& reader, Recording& recording) {
    const RecordingHeader& header = recording.header;
    const auto first = reader.get<std::uint64_t>();
    if (first != recording.steps.size()) {
        reader.fail(
            fmt::format("found steps from {} on, expected them from {} on", first, recording.steps.size()));
    }
    const auto count = reader.get<std::uint32_t>();
    const std::size_t least =
        std::size_t{header.input_size} + sizeof(std::uint32_t) + mask_bytes(header) + sizeof(std::uint64_t);
    if (count > reader.left() / least) {
        reader.fail(fmt::format("found {} steps, more than the chunk has room for", count));
    }
    const std::size_t begin = recording.steps.size();
    recording.steps.resize(begin + count);
    const auto steps = std::span(recording.steps).subspan(begin);
    for (RecordedStep& step : steps) {
        step.input.resize(header.input_size);
    }
    for (std::size_t k = 0; k < header.input_size; ++k) {
        for (RecordedStep& step : steps) {
            step.input[k] = reader.get<std::byte>();
        }
    }
    std::vector<std::uint32_t> readings(count);
    for (std::uint32_t& number : readings) {
        number = reader.get<std::uint32_t>();
    }
    read_readings(reader, header, steps, readings);
    read_changed(reader, header, steps);
    for (RecordedStep& step : steps) {
        step.root = reader.get<std::uint64_t>();
    }
}

void read_end_body(const Reader& file, std::span<const std::byte> body, const Recording& recording) {
    std::uint64_t count = 0;
    if (body.size() == sizeof count) {
        std::memcpy(&count, body.data(), sizeof count);
    }
    if (body.size() != sizeof count || count != recording.steps.size()) {
        file.fail(fmt::format("found {} steps, expected {}", recording.steps.size(), count));
    }
    if (file.left() != 0) {
        file.fail(fmt::format("found {} bytes behind the end", file.left()));
    }
}

}  // namespace lanthorn::replay
