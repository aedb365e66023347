// A recorded session: what it started from, and for every step what came in and which state came out.
//
// The file (version 2, little-endian): "LANTHREC", u32 version, then chunks. A chunk is u32 kind, u32 length
// of its body, u32 check of these two (the low half of their XXH3 hash), the body, and the u64 XXH3 hash of
// all of it so far. The first chunk, "HEAD", holds the header as JSON. Each "STEP" chunk holds the u64 number
// of its first step, the u32 count of its steps, and for every step its input (header.input_size bytes), u32
// number of sensor readings, each u32 sensor, u32 age and f32 value, and one u64 hash a part. "DONE" holds
// the u64 number of all steps; only a session that ended has it. Chunks are appended while the session runs:
// a file that is cut off anywhere behind its header holds all steps up to its last whole chunk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace lanthorn::replay {

inline constexpr std::uint32_t kRecordingVersion = 2;

// What a recording is of.
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
    std::uint32_t age = 0;     // steps from the state that was looked at to the step that it enters with
    float value = 0;           // unit of the sensor

    bool operator==(const SensorReading&) const = default;
};

// What a step takes in: plain bytes without padding, so that equal inputs are equal bytes.
template <class T>
concept StepInput = std::is_trivially_copyable_v<T> && std::is_default_constructible_v<T>;

// A simulation step: what went in, and what came of it.
struct RecordedStep {
    std::vector<std::byte> input;
    std::vector<SensorReading> sensors;
    std::vector<std::uint64_t> hashes;  // of the state after the step

    bool operator==(const RecordedStep&) const = default;
};

struct Recording {
    RecordingHeader header;
    std::vector<RecordedStep> steps;
    // Empty for a session that ended. Else one line: where the file is cut off, and how many steps are whole.
    std::string cut_off;

    bool operator==(const Recording&) const = default;
};

// Writes the file whole or not at all. Throws InputError if it cannot be written.
void write_recording(const std::string& path, const Recording& recording);

// Of a file that is cut off, what is whole (Recording::cut_off). Throws InputError on a file that is missing,
// of another version (version 1 too: its sessions must be recorded again), cut off within its header, or
// damaged.
Recording read_recording(const std::string& path);

}  // namespace lanthorn::replay
