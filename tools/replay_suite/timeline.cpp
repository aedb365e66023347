#include "tools/replay_suite/timeline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "lanthorn/core/printable.h"
#include "lanthorn/core/time_step.h"
#include "tools/replay_suite/summary.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

constexpr double kLeft = 78, kWidth = 1000, kLane = 22, kGap = 6, kTop = 6;  // units of the picture

// Lanes one below the other.
class Lanes {
  public:
    explicit Lanes(double steps) : steps_(steps) {}

    double x(double step) const { return kLeft + kWidth * std::clamp(step / steps_, 0.0, 1.0); }
    double begin(const char* name) {
        const double y = kTop + lanes_++ * (kLane + kGap);
        marks_ += fmt::format(
            "<text x=\"{}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text><rect class=\"lane\" x=\"{}\" "
            "y=\"{:.0f}\" "
            "width=\"{}\" height=\"{}\"/>\n",
            kLeft - 8, y + 15, name, kLeft, y, kWidth, kLane);
        return y;
    }
    // A bar from step to step, of a height from 0 to 1.
    void bar(double y, const char* kind, double from, double to, double height, const std::string& title) {
        const double w = std::max(x(to) - x(from), 1.0), h = std::max(height * kLane, 1.0);
        marks_ += fmt::format(
            "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
            "height=\"{:.1f}\"><title>{}</title></rect>\n",
            kind, x(from), y + kLane - h, w, h, markup_text(title));
    }
    void line(double y, const char* kind, double step, const std::string& title) {
        marks_ += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}v{}\"><title>{}</title></path>\n", kind,
                              x(step), y - 2, kLane + 4, markup_text(title));
    }
    std::string svg() const {
        const double bottom = kTop + lanes_ * (kLane + kGap);
        std::string axis;
        const double seconds = steps_ * kStepSeconds;
        const double every = seconds > 60 ? 10 : seconds > 20 ? 5 : 1;
        for (double t = 0; t <= seconds; t += every) {
            axis += fmt::format("<text x=\"{:.1f}\" y=\"{:.0f}\" text-anchor=\"middle\">{} s</text>\n",
                                x(t / kStepSeconds), bottom + 12, t);
        }
        return fmt::format(
            "<svg class=\"lanes\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"timeline\">\n{}{}</svg>\n",
            kLeft + kWidth + 20, bottom + 18, marks_, axis);
    }

  private:
    double steps_;
    double lanes_ = 0;
    std::string marks_;
};

std::string moment(double step) {
    return fmt::format("step {}, {:.2f} s", step, step * kStepSeconds);
}

void bins(Lanes& lanes, const json& timeline, const char* key, const char* name, const char* kind,
          const char* words) {
    const json counts = timeline.value(key, json::array());
    const double bin = timeline.value("bin_steps", 30.0);
    double most = 1;
    for (const json& n : counts) {
        most = std::max(most, n.is_number() ? n.get<double>() : 0);
    }
    if (counts.empty()) {
        return;
    }
    const double y = lanes.begin(name);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (const double n = counts[i].is_number() ? counts[i].get<double>() : 0; n > 0) {
            const double from = bin * static_cast<double>(i);
            lanes.bar(y, kind, from, from + bin, n / most, fmt::format("{}: {} {}", moment(from), n, words));
        }
    }
}

}  // namespace

std::string timeline_svg(const Result& result) {
    const json& verify = result.verify;
    const auto steps = static_cast<double>(result.count("steps"));
    if (steps <= 0) {
        return "";
    }
    Lanes lanes(steps);
    try {
        const json timeline = verify.value("timeline", json::object());
        bins(lanes, timeline, "inputs", "input", "in", "changes of the input");
        bins(lanes, timeline, "parts", "parts", "pt", "parts of the state changed");
        const double y = lanes.begin("state");
        lanes.bar(y, "eq", 0, steps, 0.5, "equal to what was recorded");
        for (const json& range : timeline.value("unequal", json::array())) {
            lanes.bar(y, "ne", range.at(0), range.at(1).get<double>() + 1, 1,
                      fmt::format("{}: differs from there on", moment(range.at(0))));
        }
        for (const json& d : verify.value("divergences", json::array())) {
            std::vector<std::string> parts;
            for (const json& part : d.value("parts", json::array())) {
                parts.push_back(part);
            }
            lanes.line(y, "dv", d.at("step"),
                       fmt::format("{}: {} differs", moment(d.at("step")), fmt::join(parts, ", ")));
        }
        for (const json& mark : timeline.value("marks", json::array())) {
            lanes.line(y, "mk", mark.at(0), mark.at(1));
        }
        if (result.crash) {
            lanes.line(y, "cr", static_cast<double>(result.crash->step), "here it ended");
        }
    } catch (const json::exception&) {
        return "";  // written by another version: the words say the same
    }
    return lanes.svg();
}

}  // namespace lanthorn::suite
