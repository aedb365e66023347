// Where photons are kept: in memory up to a limit, beyond it in a temporary file that is read front to back
// (Lavignotte and Paulin 2003, sec. 6: "disk caching").
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gi_module/techniques/splat/photon_record.h"

namespace lanthorn::gi {

class SplatStore {
  public:
    SplatStore() = default;
    ~SplatStore();
    SplatStore(const SplatStore&) = delete;
    SplatStore& operator=(const SplatStore&) = delete;

    // `bytes`: of photons and what finds them in memory, the run that is being read included; at least one
    // run fits. `folder`: for the temporary file, which nobody else sees and which is gone with this, or with
    // the program; empty: the system's.
    void limit(std::size_t bytes, std::filesystem::path folder = {});
    void clear();

    // All of them or, where the disk takes them no more, none; then what was kept stays as it is and error()
    // says why in a line. The records of a run are at most kMostRecords.
    static constexpr std::size_t kMostRecords = 1u << 18;  // 4 MiB
    bool add(std::vector<RecordRun> runs);
    // Calls `take` with each run in the order they were added; it holds until `take` returns. False where the
    // file could not be read: error() says why.
    bool each(const std::function<void(const RecordRun& run)>& take);

    std::uint64_t records() const { return records_; }
    std::size_t memory() const { return memory_; }            // bytes now
    std::size_t most_memory() const { return most_memory_; }  // bytes, ever since clear()
    std::uint64_t on_disk() const { return file_bytes_; }
    std::size_t runs() const { return kept_.size(); }
    const std::string& error() const { return error_; }

  private:
    struct Kept {
        RecordRun run;  // its records empty where they are in the file
        std::uint64_t offset = 0;
        std::size_t count = 0;  // records
        bool in_file = false;
    };
    static std::size_t bytes_of(const RecordRun& run);
    bool open_file();
    bool write(Kept& kept);
    void fail(const std::string& doing, int error);
    void count_memory();

    std::size_t limit_ = 64u << 20;
    std::filesystem::path folder_;
    std::vector<Kept> kept_;
    std::uint64_t records_ = 0;
    std::size_t memory_ = 0, most_memory_ = 0;
    int file_ = -1;
    std::uint64_t file_bytes_ = 0;
    RecordRun read_;
    std::string error_;
};

}  // namespace lanthorn::gi
