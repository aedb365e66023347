#include "lanthorn/runtime/budget_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lanthorn {

namespace {

constexpr std::size_t kFrames = 31;     // that are looked at
constexpr std::size_t kFewest = 9;      // that can say something
constexpr std::size_t kFewestSlow = 3;  // the same where they take kSlow milliseconds together
constexpr double kSlow = 1500;
constexpr std::size_t kSudden =
    3;  // frames one after the other, late by kSuddenOver, that are of another scene
constexpr double kSuddenOver = 1.15;  // of the budget
constexpr int kDisturbed = 4;         // frames after a change: buffers and histories are made again
constexpr double kJudged = 0.8;       // of the frames stay within the budget: the rest are bursts
constexpr double kAim = 0.96;         // of the budget, when something is lowered
constexpr double kRoom = 0.93;        // of the budget, that what is raised may take
constexpr double kSoonest = 2000, kLatest = 64'000;  // milliseconds
constexpr double kKept = 8000;  // milliseconds: what was raised and holds for so long was right
constexpr double kMostDistrust = 3;
constexpr double kLongest = 1000;  // milliseconds of a frame that count as waited: a machine that stood still
                                   // has learnt nothing meanwhile
constexpr std::size_t kErrors = 4;    // that are looked at
constexpr double kErrorOver = 1.05;   // of the error that is wished for, above which more is drawn
constexpr double kErrorAim = 0.95;    // of it, then
constexpr double kErrorSpare = 0.85;  // of it, that what is cheaper is expected to have at most
constexpr double kErrorGain = 0.98;   // of the error now, below which what is dearer is worth its time
constexpr std::size_t kDecisions = 1000;

bool is_time(double ms) {
    return std::isfinite(ms) && ms >= 0;
}

// Whether the last frames are late by so much that what was before them tells nothing of the next.
bool is_sudden(const std::deque<BudgetControl::Frame>& frames, double budget) {
    return budget > 0 && frames.size() >= kSudden &&
           std::all_of(frames.end() - kSudden, frames.end(), [budget](const BudgetControl::Frame& frame) {
               return frame.busy_ms > kSuddenOver * budget;
           });
}

}  // namespace

void BudgetControl::set(const Wish& wished, BudgetLadder ladder) {
    const Wish wish{wished.ms > 0 ? wished.ms : 0, wished.error > 0 ? wished.error : 0};
    if (ladder.rungs.empty()) {
        throw std::invalid_argument("a ladder has no rungs");
    }
    for (const BudgetRung& rung : ladder.rungs) {
        if (rung.cost.size() != ladder.shares.size()) {
            throw std::invalid_argument("a rung does not have as many costs as its ladder has groups");
        }
    }
    if (wish == wish_ && ladder == ladder_) {
        return;
    }
    wish_ = wish;
    ladder_ = std::move(ladder);
    rung_ = 0;
    since_ = 0;
    wait_ = kSoonest;
    raised_ = false;
    distrust_ = 1;
    last_error_.reset();
    disturb();
}

void BudgetControl::disturb() {
    frames_.clear();
    errors_.clear();
    disturbed_ = kDisturbed;
}

// What `share` of the frames stay below.
double BudgetControl::busy(double share) const {
    std::vector<double> all;
    std::ranges::transform(frames_, std::back_inserter(all), &Frame::busy_ms);
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::ranges::nth_element(all, at);
    return *at;
}

std::optional<double> BudgetControl::error() const {
    if (errors_.empty()) {
        return std::nullopt;
    }
    double sum = 0;
    for (const double error : errors_) {
        sum += error;
    }
    return sum / static_cast<double>(errors_.size());
}

// What the frames take by group, their sum as many of them stay below. Medians: a burst is nobody's share.
std::vector<double> BudgetControl::groups_now() const {
    std::vector<double> groups(ladder_.shares.size());
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<double> values;
        for (const Frame& frame : frames_) {
            if (frame.groups.size() == groups.size()) {
                values.push_back(frame.groups[g]);
            }
        }
        if (!values.empty()) {
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::ranges::nth_element(values, middle);
            groups[g] = *middle;
        }
        sum += groups[g];
    }
    if (!(sum > 0)) {
        for (std::size_t g = 0; g < groups.size(); ++g) {
            groups[g] = ladder_.shares[g] * rung().cost[g];
            sum += groups[g];
        }
    }
    const double all = busy(kJudged);
    for (double& group : groups) {
        group *= all / sum;
    }
    return groups;
}

double BudgetControl::predicted_ms(std::size_t to) const {
    const std::vector<double> now = groups_now();
    double ms = 0;
    for (std::size_t g = 0; g < now.size(); ++g) {
        ms += now[g] * ladder_.rungs[to].cost[g] / rung().cost[g];
    }
    return ms;
}

double BudgetControl::predicted_error(std::size_t to) const {
    return error().value_or(0) * ladder_.rungs[to].error / rung().error;
}

bool BudgetControl::can_tell() const {
    double looked_at = 0;
    for (const Frame& each : frames_) {
        looked_at += each.ms;
    }
    return frames_.size() >= kFewest || (frames_.size() >= kFewestSlow && looked_at > kSlow);
}

void BudgetControl::frame(const Frame& frame) {
    ++count_;
    if ((wish_.ms == 0 && wish_.error == 0) || !is_time(frame.ms) || !is_time(frame.busy_ms)) {
        return;
    }
    since_ += std::min(frame.ms, kLongest);
    if (disturbed_ > 0) {
        --disturbed_;
        return;
    }
    frames_.push_back(frame);
    if (frames_.size() > kFrames) {
        frames_.pop_front();
    }
    if (frame.error && std::isfinite(*frame.error)) {
        errors_.push_back(*frame.error);
        last_error_ = frame.error;
        if (errors_.size() > kErrors) {
            errors_.pop_front();
        }
    }
    const bool sudden = rung_ + 1 < ladder_.rungs.size() && is_sudden(frames_, wish_.ms);
    if (sudden) {
        frames_.erase(frames_.begin(), frames_.end() - kSudden);
    }
    if ((!sudden && !can_tell()) || decide_time()) {
        return;
    }
    if (wish_.error > 0) {
        if (!frame.refines) {
            decide_error();
        }
    } else {
        raise();
    }
}

// Whether the time is so short that nothing else is asked.
bool BudgetControl::decide_time() {
    // Few frames can tell that most of them are late, not that a fifth is.
    const double now = busy(frames_.size() < kFrames ? 0.5 : kJudged);
    if (wish_.ms == 0 || now <= kTolerance * wish_.ms) {
        return false;
    }
    if (rung_ + 1 == ladder_.rungs.size()) {
        return true;
    }
    if (raised_) {
        const bool kept = since_ >= kKept;
        wait_ = kept ? kSoonest : std::min(2 * wait_, kLatest);
        distrust_ = kept ? 1 : std::clamp(distrust_ * now / foretold_, 1.0, kMostDistrust);
    }
    std::size_t to = rung_ + 1;
    while (to + 1 < ladder_.rungs.size() && predicted_ms(to) > kAim * wish_.ms) {
        ++to;
    }
    raised_ = false;
    const double expected = predicted_ms(to);
    go_to(to, fmt::format("{:.3g} ms of {:.3g}: {:.3g} expected", now, wish_.ms, expected));
    return true;
}

// Nobody has named an error: as little as there is time for.
void BudgetControl::raise() {
    if (rung_ == 0 || since_ <= wait_ || frames_.size() < kFrames) {
        return;
    }
    std::size_t to = rung_;
    while (to > 0 && distrust_ * predicted_ms(to - 1) <= kRoom * wish_.ms) {
        --to;
    }
    if (to != rung_) {
        raised_ = true;
        const double now = busy(kJudged), expected = predicted_ms(to);
        foretold_ = expected;
        go_to(to, fmt::format("{:.3g} ms of {:.3g}: room for {:.3g}", now, wish_.ms, expected));
    }
}

void BudgetControl::decide_error() {
    const std::optional<double> now = error();
    if (!now || since_ <= wait_) {
        return;
    }
    const auto fits = [&](std::size_t rung) {
        return wish_.ms == 0 || predicted_ms(rung) <= kRoom * wish_.ms;
    };
    if (*now > kErrorOver * wish_.error) {
        std::size_t to = rung_;
        while (to > 0 && fits(to - 1) && predicted_error(to) > kErrorAim * wish_.error) {
            --to;
        }
        const double expected = predicted_error(to);
        if (to != rung_ && (wish_.ms == 0 || expected < kErrorGain * *now)) {
            raised_ = true;
            foretold_ = predicted_ms(to);
            go_to(to, fmt::format("error {:.3g} of {:.3g}: {:.3g} expected", *now, wish_.error, expected));
        } else if (wish_.ms > 0) {
            raise();  // what is left to gain are pixels
        }
        return;
    }
    std::size_t to = rung_;
    while (to + 1 < ladder_.rungs.size() && predicted_error(to + 1) <= kErrorSpare * wish_.error) {
        ++to;
    }
    if (to != rung_) {
        raised_ = false;
        const double expected = predicted_error(to);
        go_to(to, fmt::format("error {:.3g} of {:.3g}: {:.3g} suffices", *now, wish_.error, expected));
    }
}

void BudgetControl::go_to(std::size_t rung, std::string why) {
    decisions_.push_back({count_ - 1, rung_, rung, std::move(why)});
    if (decisions_.size() > kDecisions) {
        decisions_.pop_front();
    }
    rung_ = rung;
    since_ = 0;
    ++changes_;
    disturb();
}

bool BudgetControl::holds() const {
    const bool late = wish_.ms > 0 && !frames_.empty() && busy(kJudged) > kTolerance * wish_.ms;
    const bool wrong = wish_.error > 0 && error() && *error() > kErrorOver * wish_.error;
    return !late && !wrong;
}

std::string BudgetControl::verdict() const {
    if (wish_.ms == 0 && wish_.error == 0) {
        return "nothing is wished for";
    }
    std::string text;
    if (wish_.ms > 0) {
        text =
            frames_.empty() ? fmt::format("{:.4g} ms wished for, too few frames to tell", wish_.ms)
            : busy(kJudged) > kTolerance * wish_.ms
                ? fmt::format("{:.4g} ms wished for, {:.4g} taken{}", wish_.ms, busy(kJudged),
                              rung_ + 1 == ladder_.rungs.size() ? " though nothing more can be spared" : "")
                : fmt::format("{:.4g} ms wished for, {:.4g} taken", wish_.ms, busy(kJudged));
    }
    if (wish_.error > 0) {
        const std::optional<double> reached = error();
        text += (text.empty() ? "" : "; ") + fmt::format("error {:.3g} wished for, ", wish_.error) +
                (!reached && last_error_ ? fmt::format("{:.3g} before the last change", *last_error_)
                 : !reached              ? "none is known"
                 : *reached <= kErrorOver * wish_.error ? fmt::format("{:.3g} reached", *reached)
                 : wish_.ms > 0 && rung_ > 0
                     ? fmt::format("{:.3g} reached: time comes first", *reached)
                     : fmt::format("{:.3g} reached with all that can be spent", *reached));
    }
    return text;
}

}  // namespace lanthorn
