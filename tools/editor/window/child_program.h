// A program that runs beside the editor: the game, while it is played, say.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace lanthorn::edit_window {

class ChildProgram {
  public:
    // `ended` is called from another thread when a program has ended; it must not block.
    explicit ChildProgram(std::function<void()> ended);
    // Ends what still runs, and removes its folder.
    ~ChildProgram();
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    // A folder of its own for files of the next program, until there is another or this object goes. `name`:
    // as mkdtemp() takes it. Throws InputError.
    std::filesystem::path make_folder(const std::string& name);
    // Nothing may be running. `niceness`: 0..19, how far it stands back. Throws InputError where there is no
    // such program.
    void start(const std::vector<std::string>& command, int niceness = 0);
    void stop();  // asks it to end
    bool running() const { return running_; }
    // Once, after it has ended: empty where it went well, else why not, one line.
    std::optional<std::string> take_end();

  private:
    void wait();
    void remove_folder();

    std::function<void()> ended_;
    std::filesystem::path folder_;
    pid_t child_ = -1;
    std::atomic<bool> running_ = false;
    std::mutex mutex_;  // of end_
    std::optional<std::string> end_;
    std::jthread thread_;
};

}  // namespace lanthorn::edit_window
