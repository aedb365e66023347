// Waiting for another program. Nothing tells this one when the other has opened its window or written its
// file: it looks again and again. Sleeping sets the pace only, what is looked for decides; the end of
// patience fails the test.
#pragma once

#include <chrono>
#include <string>
#include <thread>

namespace lanthorn::game {

class Patience {
  public:
    // Of one test, for all that it waits for. The tests of a program fit into its TIMEOUT together
    // (CMakeLists.txt).
    static constexpr int kLooks = 1800;
    static constexpr std::chrono::milliseconds kPause{100};
    // In front of a command: ends it if it waits for longer.
    static inline const std::string kLimit = "timeout 60 ";

    // False, at once, where patience has ended.
    bool wait() {
        if (looks_ == kLooks) {
            return false;
        }
        ++looks_;
        std::this_thread::sleep_for(kPause);
        return true;
    }

  private:
    int looks_ = 0;
};

}  // namespace lanthorn::game
