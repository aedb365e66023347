// Work that ends early when it is asked to (lanthorn/core/stop_signal.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"

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

// A command's work in steps, with a progress bar. What was done until somebody wanted no more can still be
// told:
//
//   MeasuredSteps work("measure", "what was measured until then is printed", scenes.size());
//   for (const std::string& scene : scenes) {
//       const bool whole = work.part([&] { figures.push_back(measure(scene)); work.step(); });
//       ...print...
//       if (!whole) break;
//   }
//   work.finish();
//
// One at a time, as StopSignal.
class MeasuredSteps {
  public:
    // `what` and `kept` as Stopped has them; `steps` in all.
    MeasuredSteps(std::string what, std::string kept, std::uint64_t steps);

    // So many more are done. Throws Stopped.
    void step(std::uint64_t count = 1);
    // Does a part of the work. False: it was stopped there, and nothing but telling of it is left to do.
    bool part(const std::function<void()>& work);
    // When all is told. Throws Stopped where part() was false.
    void finish() const;

  private:
    std::string what_, kept_;
    Progress progress_;
    std::uint64_t done_ = 0;
    StopSignal signal_;
    std::optional<Stopped> stopped_;
};

}  // namespace lanthorn::workbench
