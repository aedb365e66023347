// Recording a session while it runs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

// Appends a session to a file while it runs: a program that is killed loses less than a second of it, and
// what is in the file can be replayed. Twice a second a write to the file, which is left to the system to
// bring to the disk: about 50 bytes a step beside the input, until finish() packs them.
class Recorder {
  public:
    // Begins the file; a file of that name is replaced once the new one has its header. Throws InputError if
    // it cannot be written; then a file of that name stays as it was. header.input_size must be that of the
    // inputs to come, header.parts at most kMostParts.
    Recorder(std::string path, RecordingHeader header, const Annotations& annotations = {});
    // Writes what is left, without the end that finish() writes.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // One step: what came in, and the hashes of the state after it, one a part.
    template <StepInput Input>
    void add(const Input& input, std::span<const SensorReading> sensors,
             std::span<const std::uint64_t> hashes) {
        const auto bytes = std::as_bytes(std::span(&input, 1));
        RecordedStep step{{bytes.begin(), bytes.end()}, {sensors.begin(), sensors.end()}};
        mark_state(hashes, before_, step);
        add(std::move(step));
    }
    // The same with an input that is bytes already, of the header's size.
    void add(std::vector<std::byte> input, std::vector<SensorReading> sensors,
             std::span<const std::uint64_t> hashes) {
        RecordedStep step{std::move(input), std::move(sensors)};
        mark_state(hashes, before_, step);
        add(std::move(step));
    }

    // The session has ended: what is in the file is packed. Nothing may be added after it. O(steps).
    void finish();

    // Why the recording broke off, in one line: a full disk, say. From then on steps are dropped; the file
    // holds those before. Empty while all is well.
    const std::string& failure() const { return failure_; }

    const std::string& path() const { return path_; }  // of the file
    // So far, those included that are not written yet.
    std::uint64_t steps() const { return written_ + waiting_.size(); }
    const RecordingHeader& header() const { return header_; }  // as it stands in the file

  private:
    // Writes to the file once a chunk is full.
    void add(RecordedStep step);
    void write_waiting();
    void pack() const;
    void append(const std::string& bytes);

    std::string path_;
    RecordingHeader header_;
    std::size_t chunk_;                  // steps
    std::vector<RecordedStep> waiting_;  // not yet in the file
    std::vector<std::uint64_t> before_;  // hashes after the last step
    std::uint64_t written_ = 0;          // steps
    std::uint64_t size_ = 0;             // of the file up to its last whole chunk, bytes
    int file_ = -1;
    std::string failure_;
};

}  // namespace lanthorn::replay
