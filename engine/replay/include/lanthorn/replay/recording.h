// A recorded session: what it started from, and for every step what came in and which state came out.
// docs/replay-format.md describes the file (version 3; version 2 is read).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace lanthorn::replay {

inline constexpr std::uint32_t kRecordingVersion = 3;
inline constexpr std::size_t kMostParts = 256;  // of a state: their numbers are bytes

// What a recording is of.
struct RecordingHeader {
    std::string level;             // name of the level's file, without folders
    std::uint64_t level_hash = 0;  // hash_file of it
    std::uint64_t seed = 0;
    double step_rate = 60;               // steps a second
    std::string build;                   // commit and type of the recording program, for people
    std::string input_format;            // name and version of the input's layout, as in "lamplighter-1"
    std::uint32_t input_size = 0;        // bytes a step
    std::vector<std::string> parts;      // names of the state's parts, at most kMostParts
    std::vector<std::uint64_t> schemas;  // one a part: what fields it has; 0: not known (version 2)
    std::vector<std::string> sensors;    // names of what readings come from

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

// A part of the state that a step changed.
struct ChangedPart {
    std::uint8_t part = 0;  // into RecordingHeader::parts
    std::uint8_t tag = 0;   // the low byte of its hash after the step

    bool operator==(const ChangedPart&) const = default;
};

// A simulation step: what went in, and what came of it.
struct RecordedStep {
    std::vector<std::byte> input;
    std::vector<SensorReading> sensors;
    std::uint64_t root = 0;                 // root_of the state's hashes after the step; 0: not known
    std::vector<ChangedPart> changed = {};  // by this step, in the order of parts; by the first one all

    // Whether it says which state the step leads to. One that no build has lived to see does not.
    bool is_state_known() const { return root != 0 || !changed.empty(); }
    bool operator==(const RecordedStep&) const = default;
};

// One hash for all parts of a state (XXH3, 64 bits).
std::uint64_t root_of(std::span<const std::uint64_t> hashes);

// Writes into a step what its state's hashes say: the root, and which parts they say have changed since
// `before` (empty: all), which becomes `hashes`.
void mark_state(std::span<const std::uint64_t> hashes, std::vector<std::uint64_t>& before,
                RecordedStep& step);

// A moment that is worth a picture.
struct Mark {
    std::uint64_t step = 0;  // steps before it
    std::string name;
    std::string camera;     // empty: the session's own
    std::string aov;        // empty: the final picture
    std::string tolerance;  // a key for who compares pictures; empty: the usual

    bool operator==(const Mark&) const = default;
};

// The state after `step` steps, as ecs::Snapshot::to_bytes writes it.
struct StoredState {
    std::uint64_t step = 0;
    std::string bytes;

    bool operator==(const StoredState&) const = default;
};

// The roots of an earlier recording of these inputs that was accepted: when and why it was replaced.
struct Ancestor {
    std::string build, reason;
    std::vector<std::uint64_t> roots;

    bool operator==(const Ancestor&) const = default;
};

// A part of the file that this version does not know and may pass over; kept when it is written again.
struct UnknownPart {
    std::uint32_t kind = 0;
    std::string body;

    bool operator==(const UnknownPart&) const = default;
};

// What a recording may hold beside its steps.
struct Annotations {
    std::vector<Mark> marks;
    std::vector<std::string> expectations;  // "solved before 1500"
    std::vector<std::string> notes;         // of people
    std::vector<std::string> log;           // of the recording program: build, settings, machine
    std::vector<StoredState> states;        // by step
    std::vector<Ancestor> line;             // oldest first
    std::vector<UnknownPart> unknown;

    bool operator==(const Annotations&) const = default;
};

struct Recording {
    RecordingHeader header;
    std::vector<RecordedStep> steps;
    // Empty for a session that ended. Else one line: where the file is cut off, and how many steps are whole.
    std::string cut_off;
    Annotations annotations = {};

    bool operator==(const Recording&) const = default;
};

// Writes the file whole or not at all, compressed. Throws InputError if it cannot be written.
void write_recording(const std::string& path, const Recording& recording);

// Of a file that is cut off, what is whole (Recording::cut_off). Throws InputError on a file that is missing,
// of another version (of earlier ones 2 is read), cut off within its header, or damaged. Its memory is bound
// by the file's size: some hundred times that at worst, ten times for what a program records.
Recording read_recording(const std::string& path);

}  // namespace lanthorn::replay
