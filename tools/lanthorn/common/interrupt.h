#pragma once

#include <csignal>

namespace lanthorn::tools {

// Notes the first interrupt from the keyboard, or request to end, while it lives, so that what is finished
// can be written; the second ends the program as ever. One at a time.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    bool interrupted() const;

  private:
    struct sigaction interrupt_before_ {};
    struct sigaction end_before_ {};
};

}  // namespace lanthorn::tools
