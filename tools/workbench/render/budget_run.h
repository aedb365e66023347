// An App whose frames keep a time or an error, or do what was decided in a run before.
#pragma once

#include <span>

#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/budget_control.h"
#include "lanthorn/workbench/render_job.h"

namespace lanthorn::workbench {

class BudgetRun {
  public:
    // `settings`: the best that is drawn, which the App has. `pixels`: the picture may lose some. Throws
    // InputError for played decisions that the ladder does not have. Both references must outlive it.
    BudgetRun(App& app, const Settings& settings, ivec2 size, const BudgetWish& wish, bool pixels);

    // Before a frame.
    void begin_frame();
    // The error of the frame that was shown, where it is time to ask; a part of the frame.
    void estimate();
    // After it: its time by the clock and of the processor, and what its passes took.
    void end_frame(double ms, double cpu_ms, std::span<const gpu::PassTimer::Span> passes);

    const BudgetControl& control() const { return control_; }
    std::optional<double> error() const { return error_; }  // of the last frame that was asked
    std::size_t rung() const { return drawn_; }             // that the last frame was drawn by
    BudgetOutcome outcome() const;

  private:
    void apply(std::size_t rung);
    // While nothing moves spare time goes into passes, until the error is what is wished for.
    void spend_spare_time(Settings& settings) const;

    App& app_;
    const Settings& settings_;
    BudgetWish wish_;
    BudgetControl control_;
    std::size_t drawn_ = 0;
    std::int64_t frame_ = 0;
    std::optional<double> error_;
    bool asked_ = false;  // of this frame
    std::vector<BudgetStep> steps_;
};

}  // namespace lanthorn::workbench
