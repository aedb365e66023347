#include "tools/lanthorn/replay/reduce_steps.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "game/rules/player_input.h"

namespace lanthorn::tools {

namespace {

using game::PlayerInput;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kLeastStretch = 4;  // steps that are taken out together, at least

PlayerInput input_of(const replay::RecordedStep& step) {
    PlayerInput input;
    std::memcpy(&input, step.input.data(), std::min(sizeof input, step.input.size()));
    return input;
}

void set_input(replay::RecordedStep& step, const PlayerInput& input) {
    std::memcpy(step.input.data(), &input, std::min(sizeof input, step.input.size()));
}

// Something that the player does for some steps: holds a button, or moves along or about one axis.
struct Deed {
    std::size_t begin, end;     // steps
    std::uint16_t buttons = 0;  // or
    std::int16_t PlayerInput::*axis = nullptr;
};

void undo(const Deed& deed, std::vector<replay::RecordedStep>& steps) {
    for (std::size_t i = deed.begin; i < deed.end; ++i) {
        PlayerInput input = input_of(steps[i]);
        input.held = static_cast<std::uint16_t>(input.held & ~deed.buttons);
        if (deed.axis != nullptr) {
            input.*deed.axis = 0;
        }
        set_input(steps[i], input);
    }
}

template <class Does>
void add_deeds(const std::vector<replay::RecordedStep>& steps, const Deed& kind, Does does,
               std::vector<Deed>& deeds) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (does(input_of(steps[i])) && (i == 0 || !does(input_of(steps[i - 1])))) {
            deeds.push_back(kind);
            deeds.back().begin = i;
        }
        if (does(input_of(steps[i]))) {
            deeds.back().end = i + 1;
        }
    }
}

std::vector<Deed> pressed(const std::vector<replay::RecordedStep>& steps) {
    std::vector<Deed> deeds;
    for (int bit = 0; bit < 16; ++bit) {
        const auto button = static_cast<std::uint16_t>(1u << bit);
        add_deeds(
            steps, {0, 0, button, nullptr},
            [=](const PlayerInput& input) { return (input.held & button) != 0; }, deeds);
    }
    return deeds;
}

std::vector<Deed> moved(const std::vector<replay::RecordedStep>& steps) {
    std::vector<Deed> deeds;
    for (const auto axis :
         {&PlayerInput::forward, &PlayerInput::right, &PlayerInput::yaw, &PlayerInput::pitch}) {
        add_deeds(
            steps, {0, 0, 0, axis}, [=](const PlayerInput& input) { return input.*axis != 0; }, deeds);
    }
    return deeds;
}

class Reducer {
  public:
    Reducer(std::vector<replay::RecordedStep> steps, const StepsOracle& oracle, double seconds,
            const std::function<void(int, std::size_t)>& progress)
        : oracle_(oracle), progress_(progress), seconds_(seconds), result_{std::move(steps), 0} {}

    ReducedSteps run() {
        for (std::size_t before = 0; before != weight() && !late();) {
            before = weight();
            shorten();
            without(pressed(result_.steps));
            without(moved(result_.steps));
        }
        return std::move(result_);
    }

  private:
    bool late() const { return std::chrono::duration<double>(Clock::now() - start_).count() > seconds_; }
    std::size_t weight() const {
        return result_.steps.size() + pressed(result_.steps).size() + moved(result_.steps).size();
    }

    // Whether these steps show the same; then they are the result.
    bool take(std::vector<replay::RecordedStep> steps) {
        ++result_.trials;
        if (progress_) {
            progress_(result_.trials, result_.steps.size());
        }
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (replay::SensorReading& reading : steps[i].sensors) {
                reading.age = static_cast<std::uint32_t>(std::min<std::size_t>(reading.age, i));
            }
        }
        std::optional<std::vector<replay::RecordedStep>> shown = oracle_(std::move(steps));
        if (shown) {
            result_.steps = std::move(*shown);
        }
        return shown.has_value();
    }

    // Takes stretches of steps out, from halves to a few.
    void shorten() {
        for (std::size_t stretch = result_.steps.size() / 2; stretch >= kLeastStretch; stretch /= 2) {
            for (std::size_t begin = 0; begin < result_.steps.size() && !late();) {
                std::vector<replay::RecordedStep> steps = result_.steps;
                const auto from = steps.begin() + static_cast<std::ptrdiff_t>(begin);
                const std::size_t count = std::min(stretch, steps.size() - begin);
                steps.erase(from, from + static_cast<std::ptrdiff_t>(count));
                if (steps.empty() || !take(std::move(steps))) {
                    begin += stretch;
                }
            }
        }
    }

    // Undoes deeds: all at once, then half of them, and so on. What shortens the result ends the round, since
    // steps have other numbers then.
    void without(const std::vector<Deed>& deeds) {
        std::vector<Deed> left = deeds;
        for (std::size_t group = left.size(); group >= 1; group /= 2) {
            for (std::size_t begin = 0; begin < left.size() && !late();) {
                const std::size_t end = std::min(begin + group, left.size());
                std::vector<replay::RecordedStep> steps = result_.steps;
                for (std::size_t i = begin; i < end; ++i) {
                    Deed deed = left[i];
                    deed.end = std::min(deed.end, steps.size());
                    undo(deed, steps);
                }
                if (take(std::move(steps))) {
                    left.erase(left.begin() + static_cast<std::ptrdiff_t>(begin),
                               left.begin() + static_cast<std::ptrdiff_t>(end));
                } else {
                    begin = end;
                }
            }
        }
    }

    const StepsOracle& oracle_;
    const std::function<void(int, std::size_t)>& progress_;
    const double seconds_;
    Clock::time_point start_ = Clock::now();
    ReducedSteps result_;
};

}  // namespace

ReducedSteps reduce_steps(std::vector<replay::RecordedStep> steps, const StepsOracle& oracle, double seconds,
                          const std::function<void(int, std::size_t)>& progress) {
    return Reducer(std::move(steps), oracle, seconds, progress).run();
}

std::size_t presses(const std::vector<replay::RecordedStep>& steps) {
    return pressed(steps).size();
}

}  // namespace lanthorn::tools
