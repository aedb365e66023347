// Programs of a level are compiled beside the title: by this program once more (--prepare), because a driver
// compiles in the thread that draws, and keeps what it has compiled for all processes.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace lanthorn::game {

class Preparation {
  public:
    Preparation() = default;
    // Ends what still runs.
    ~Preparation() { stop(); }
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    // The arguments of the program after its name. Where it cannot be run nothing is prepared, and running()
    // is false.
    void start(std::vector<std::string> arguments);
    // Until it has ended by itself, for whatever reason, or stop() was called.
    bool running();
    void stop();

  private:
    pid_t child_ = 0;  // 0: none
};

}  // namespace lanthorn::game
