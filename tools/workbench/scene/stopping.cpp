#include "tools/workbench/scene/stopping.h"

#include <fmt/format.h>

namespace lanthorn::workbench {

Stopped::Stopped(const std::string& what, const std::string& kept)
    : Error(static_cast<ExitCode>(StopSignal::exit_code()),
            fmt::format("{}: stopped by {}; {}", what, StopSignal::name(), kept)) {}

void stop_if_asked(const std::string& what, const std::string& kept) {
    if (StopSignal::asked()) {
        throw Stopped(what, kept);
    }
}

MeasuredSteps::MeasuredSteps(std::string what, std::string kept, std::uint64_t steps)
    : what_(std::move(what)), kept_(std::move(kept)), progress_("measuring", steps) {}

void MeasuredSteps::step(std::uint64_t count) {
    progress_.update(done_ += count);
    stop_if_asked(what_, kept_);
}

bool MeasuredSteps::part(const std::function<void()>& work) {
    try {
        work();
    } catch (const Stopped& stopped) {
        stopped_ = stopped;
    }
    return !stopped_;
}

void MeasuredSteps::finish() const {
    if (stopped_) {
        throw Stopped(*stopped_);
    }
}

}  // namespace lanthorn::workbench
