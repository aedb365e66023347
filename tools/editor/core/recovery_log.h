// What was edited and not yet saved, on disk: it outlives the program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/editor/core/edit_history.h"

namespace lanthorn::editor {

// $XDG_STATE_HOME/lanthorn/recovery or ~/.local/state/lanthorn/recovery (XDG Base Directory Specification
// 0.8); empty if the environment names neither.
std::filesystem::path recovery_folder();

// A log that is being written: lines of text, a block a step, each synced to the disk before append()
// returns. The file appears with the first block.
class RecoveryLog {
  public:
    RecoveryLog() = default;  // keeps nothing
    // `edited` is the file, empty for a room that has not been saved; `hash` that of its bytes. `base`, where
    // there is one, is a file of the log's own that the steps begin with instead: it goes with the log.
    RecoveryLog(const std::filesystem::path& folder, const std::filesystem::path& edited, std::uint64_t hash,
                const std::filesystem::path& base = {});
    ~RecoveryLog();
    RecoveryLog(RecoveryLog&& other) noexcept;
    RecoveryLog& operator=(RecoveryLog&& other) noexcept;

    // One write and one fsync. Where that fails the log says so once in problem() and goes on without.
    void append(std::string_view block);
    // Removes the file: what it held is saved or no longer wanted.
    void discard();
    const std::filesystem::path& path() const { return path_; }  // empty: nothing is kept
    const std::string& problem() const { return problem_; }

  private:
    void open();
    void close();

    std::filesystem::path path_;
    std::filesystem::path base_;
    std::string head_, problem_;
    int file_ = -1;
};

// A log that another run has left behind.
struct LeftLog {
    std::filesystem::path log, edited;  // `edited` empty: a new room
    std::filesystem::path base;         // what the steps begin with, if it is not `edited`
    std::uint64_t hash = 0;             // of the edited file's bytes then
    double seconds = 0;                 // since the epoch, when it was last written
    std::vector<std::string> lines;     // of whole steps; a last one that was cut off is left out
    std::size_t steps = 0;
};

// The newest first. Logs that a living process writes are left out, and files that are no logs.
std::vector<LeftLog> left_logs(const std::filesystem::path& folder);
// One of them. Throws InputError for a file that is no log.
LeftLog read_log(const std::filesystem::path& log);
// Removes it, and its base.
void discard_log(const LeftLog& log);

// A file in the folder that no other has, for a log's base.
std::filesystem::path new_base(const std::filesystem::path& folder);

// A step as a log has it, and the steps that are done after all lines of a log: what was undone is left out.
std::string log_block(const EditStep& step);
std::vector<EditStep> steps_of(const LeftLog& log);

}  // namespace lanthorn::editor
