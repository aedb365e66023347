#include "tools/editor/window/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "lanthorn/gi/technique.h"

namespace lanthorn::edit_window {

namespace {

constexpr int kAllPasses = 100'000;  // as many as gi.accumulate knows
// Frames before the error is asked for: rays of all directions come in with sixteen, and of the passes behind
// them every fourth alters the picture.
constexpr int kFirstFrames = 16;

}  // namespace

bool Refinement::possible(const Settings& settings) {
    const gi::TechniqueEntry* technique = gi::find_technique(settings.text("gi.technique"));
    return technique != nullptr && std::ranges::any_of(technique->reads, [](std::string_view name) {
               return name == "gi.target_error";
           });
}

void Refinement::prepare(Settings& settings) {
    if (settings.is_default("gi.accumulate")) {
        settings.set("gi.accumulate", kAllPasses);
    }
    settings.reset("gi.target_error");
}

void Refinement::begin(std::optional<double> error, const Settings& settings) {
    forget();
    Settings prepared = settings;
    prepare(prepared);
    const auto asked = static_cast<double>(settings.get<float>("gi.target_error"));
    target_ = asked > 0 ? asked : kUsualTarget;
    most_frames_ = kFirstFrames + prepared.get<int>("gi.accumulate");
    ask_at_ = kFirstFrames;
    estimated(error);
}

bool Refinement::drew(double ms) {
    ms_ += ms;
    ++frames_;
    if (frames_ < ask_at_ && due()) {
        return false;
    }
    ask_at_ = frames_ + std::max(4, frames_ / 8);
    return true;
}

void Refinement::estimated(std::optional<double> error) {
    known_ = error.has_value();
    error_ = error.value_or(0);
    reached_ = known_ && error_ <= target_;
}

std::string Refinement::words() const {
    if (!known_) {
        return {};
    }
    if (due()) {
        return begun() ? fmt::format("refining: error about {:.2g}", error_) : std::string();
    }
    if (!begun()) {
        return fmt::format("error about {:.2g}", error_);
    }
    return reached_ ? fmt::format("refined: error about {:.2g}", error_)
                    : fmt::format("refined for {:.0f} s: error about {:.2g}", 1e-3 * ms_, error_);
}

}  // namespace lanthorn::edit_window
