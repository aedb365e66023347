// The session in play is always being recorded, so that what led to a crash can be played again. Files of
// this process are session-PID.rec and, after a crash, session-PID.crash; the next process makes crash-N.rec
// and crash-N.crash of those that crashed, and previous.rec of the last one that did not.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lanthorn::shell {

// The recordings that a program keeps of its sessions, in one folder.
class KeptSession {
  public:
    static constexpr int kMostCrashes = 8;  // that are kept; of more the oldest go

    // `folder`: made when it is needed; empty: nothing is kept. `say` is told one line for each session of
    // this program that crashed since it was last asked.
    KeptSession(std::filesystem::path folder, std::function<void(const std::string& line)> say);

    // Where to record the session that begins; what was there goes. From now on a signal that ends this
    // process (SIGSEGV, SIGABRT and the like) is told beside it, with step and stack. Empty where no file can
    // be written.
    std::filesystem::path begin();
    // What is recorded cannot be played: it did not begin as its level does.
    void drop();

  private:
    void sort_out();

    std::filesystem::path folder_;
    std::function<void(const std::string&)> say_;
};

}  // namespace lanthorn::shell
