#include "lanthorn/shell/frame_budget.h"

#include "engine/runtime/budget_ladders.h"

namespace lanthorn::shell {

static_assert(FrameBudget::kTolerance == BudgetControl::kTolerance);

std::string usual_preset(bool software) {
    return software ? "low" : "medium";
}

double usual_frame_ms(bool software) {
    return software ? kFrameMsOnCpu : 0;
}

ivec2 usual_picture_size(bool software) {
    return software ? ivec2(640, 360) : ivec2(1280, 720);
}

FrameBudget::FrameBudget() : control_(std::make_unique<BudgetControl>()) {}

FrameBudget::~FrameBudget() = default;

void FrameBudget::set(double ms, const std::string& best) {
    set(ms, ladder_of_presets(best));
}

void FrameBudget::set(double ms, BudgetLadder ladder) {
    control_->set({.ms = ms, .error = 0}, std::move(ladder));
    follow();
}

void FrameBudget::frame(double ms, double busy_ms) {
    control_->frame({.ms = ms, .busy_ms = busy_ms, .groups = {}, .error = std::nullopt});
    follow();
}

void FrameBudget::disturb() {
    control_->disturb();
}

int FrameBudget::changes() const {
    return static_cast<int>(control_->changes());
}

void FrameBudget::follow() {
    const BudgetRung& rung = control_->rung();
    if (rung.scale != spending_.scale || rung.preset != spending_.preset || rung.set != spending_.set) {
        spending_ = {rung.preset, rung.scale, rung.set};
    }
}

}  // namespace lanthorn::shell
