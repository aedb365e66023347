// Marks of recordings looked at by several processes at a time, a process a mark: a software rasteriser keeps
// one processor busy for much of a picture, whatever its threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tools/lanthorn/replay/pictures/picture_check.h"

namespace lanthorn::tools {

class MarkProcesses {
  public:
    // Begins at once with the marks of `files` that are chosen, `jobs` at a time. `options`: further ones of
    // `replay verify` (--level). Throws std::system_error where no thread can be made.
    MarkProcesses(int jobs, const std::vector<std::string>& files, const PictureChoice& choice,
                  const std::vector<std::string>& options);
    // Waits for what has begun; the rest is not begun.
    ~MarkProcesses();
    MarkProcesses(const MarkProcesses&) = delete;
    MarkProcesses& operator=(const MarkProcesses&) = delete;

    // What check_pictures() finds of a file; waits for it. Throws as it does. A mark whose process ended by a
    // signal has failed.
    PictureResults of(const std::string& file);

  private:
    using Job = std::packaged_task<PictureVerdict()>;

    PictureChoice choice_;
    std::map<std::string, std::vector<std::shared_future<PictureVerdict>>>
        found_;                                   // by file, in the marks' order
    std::map<std::string, std::string> refused_;  // by file: why its marks cannot be looked at
    std::vector<Job> jobs_;
    std::atomic<std::size_t> next_{0};
    std::vector<std::jthread> threads_;
};

}  // namespace lanthorn::tools
