// A recorded session: what it started from, and for every step what came in and which state came out.
//
// The file (version 1, little-endian): "LANTHREC", u32 version, u32 length of the header, the header as JSON;
// then for every step its input (header.input_size bytes), u32 number of sensor readings, each u32 sensor and
// f32 value, and one u64 hash a part; then u32 0x444e4521, u64 number of steps, and the u64 XXH3 hash of all
// bytes before it. A step starts with u32 0x50455453, so that the end is told from a step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lanthorn::replay {

inline constexpr std::uint32_t kRecordingVersion = 1;

struct RecordingHeader {
    std::string level;             // name of the level's file, without folders
    std::uint64_t level_hash = 0;  // hash_file of it
    std::uint64_t seed = 0;
    double step_rate = 60;             // steps a second
    std::string build;                 // commit and type of the recording program, for people
    std::string input_format;          // name and version of the input's layout, as in "lamplighter-1"
    std::uint32_t input_size = 0;      // bytes a step
    std::vector<std::string> parts;    // names of the state's parts, one hash each
    std::vector<std::string> sensors;  // names of what readings come from

    bool operator==(const RecordingHeader&) const = default;
};

// A value that came back from the GPU and entered the simulation: on replay the recorded one does.
struct SensorReading {
    std::uint32_t sensor = 0;  // into RecordingHeader::sensors
    float value = 0;           // unit of the sensor

    bool operator==(const SensorReading&) const = default;
};

struct RecordedStep {
    std::vector<std::byte> input;
    std::vector<SensorReading> sensors;
    std::vector<std::uint64_t> hashes;  // of the state after the step

    bool operator==(const RecordedStep&) const = default;
};

struct Recording {
    RecordingHeader header;
    std::vector<RecordedStep> steps;

    bool operator==(const Recording&) const = default;
};

// Writes the file whole or not at all. Throws InputError if it cannot be written.
void write_recording(const std::string& path, const Recording& recording);

// Throws InputError on a file that is missing, of another version, cut short or damaged.
Recording read_recording(const std::string& path);

}  // namespace lanthorn::replay
