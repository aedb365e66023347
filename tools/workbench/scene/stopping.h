// Work that ends early when it is asked to (lanthorn/core/stop_signal.h).
#pragma once

#include <string>

#include "lanthorn/core/error.h"

namespace lanthorn::workbench {

// Ends a command that was asked to stop: its exit code is what a shell reports of the signal, 130 for SIGINT,
// 143 for SIGTERM, 129 for SIGHUP.
class Stopped : public Error {
  public:
    // "WHAT: stopped by SIGINT; KEPT"
    Stopped(const std::string& what, const std::string& kept);
};

// Between two pieces of work. Throws Stopped if a StopSignal has noted a signal.
void stop_if_asked(const std::string& what, const std::string& kept);

}  // namespace lanthorn::workbench
