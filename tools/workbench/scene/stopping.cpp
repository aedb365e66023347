#include "tools/workbench/scene/stopping.h"

#include <fmt/format.h>

#include "lanthorn/core/stop_signal.h"

namespace lanthorn::workbench {

Stopped::Stopped(const std::string& what, const std::string& kept)
    : Error(static_cast<ExitCode>(StopSignal::exit_code()),
            fmt::format("{}: stopped by {}; {}", what, StopSignal::name(), kept)) {}

void stop_if_asked(const std::string& what, const std::string& kept) {
    if (StopSignal::asked()) {
        throw Stopped(what, kept);
    }
}

}  // namespace lanthorn::workbench
