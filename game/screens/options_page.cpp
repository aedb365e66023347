#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "game/screens/pages.h"
#include "lanthorn/core/settings_schema.h"
#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::game::ui {

namespace {

constexpr std::array<ivec2, 9> kPictures = {ivec2{320, 180}, {480, 270},   {640, 360},
                                            {960, 540},      {1280, 720},  {1600, 900},
                                            {1920, 1080},    {2560, 1440}, {3840, 2160}};

// The place in a list that goes round, `step` from `at`; from nowhere (-1) to its ends.
std::size_t round_to(std::size_t count, std::ptrdiff_t at, int step) {
    if (at < 0) {
        return step > 0 ? 0 : count - 1;
    }
    const auto size = static_cast<std::ptrdiff_t>(count);
    return static_cast<std::size_t>((at + step + size) % size);
}

// The next larger or smaller one; the largest goes on to the smallest, which stays: a slow machine that came
// upon the largest from there would take seconds a frame to get back.
void step_picture(Preferences& preferences, ivec2 now, int step) {
    const auto pixels = [](const ivec2& size) { return std::int64_t{size.x} * size.y; };
    ivec2 chosen = kPictures.front();
    for (const ivec2& size : kPictures) {
        if (step > 0 && pixels(size) > pixels(now)) {
            chosen = size;
            break;
        }
        if (step < 0 && pixels(size) < pixels(now)) {
            chosen = size;
        }
    }
    preferences.picture = chosen;
}

void step_preset(Preferences& preferences, int step) {
    const auto found = std::ranges::find(kPresetNames, preferences.preset);
    const auto at = found == kPresetNames.end() ? -1 : found - kPresetNames.begin();
    preferences.preset = kPresetNames[round_to(kPresetNames.size(), at, step)];
}

// The times of 60, 30, 20, 12 and 8 frames a second; 0: none.
constexpr std::array kBudgets = {0.0, 16.7, 33.3, 50.0, 83.3, shell::kFrameMsOnCpu};

void step_budget(Preferences& preferences, int step) {
    const auto found = std::ranges::find(kBudgets, preferences.frame_budget.value_or(0));
    const auto at = found == kBudgets.end() ? -1 : found - kBudgets.begin();
    preferences.frame_budget = kBudgets[round_to(kBudgets.size(), at, step)];
}

// What the frames cost, and what is spared for that.
std::string frame_words(const Model& model, const Preferences& preferences) {
    const auto number = [](double value) { return fmt::format("{:.0f}", value); };
    std::string time =
        fill_in(model.say("{ms} ms a frame"), [&](std::string_view) { return number(model.frame_ms); });
    if (model.drawn == model.picture && model.drawn_preset == preferences.preset) {
        return time;
    }
    return time + fill_in(model.say(", drawn at {width} x {height}, {quality}"), [&](std::string_view name) {
               return name == "width"    ? number(model.drawn.x)
                      : name == "height" ? number(model.drawn.y)
                                         : model.say(model.drawn_preset);
           });
}

// By `grain`, within its range.
void step_number(double& value, int step, double grain, double lowest, double highest) {
    value = std::clamp(grain * std::round(value / grain + step), lowest, highest);
}

std::string percent(double value) {
    return fmt::format("{:.0f} %", 100 * value);
}

// Rows in the player's language.
class Rows {
  public:
    explicit Rows(const Model& model) : model_(model) {}

    void section(const char* words) const { lanthorn::ui::section(model_.page, model_.say(words).c_str()); }
    void row(const char* words, const std::string& value, const std::function<void(int)>& step,
             bool first = false) const {
        lanthorn::ui::row(model_.page, model_.say(words).c_str(), value, step, first);
    }
    void flag(const char* words, bool& value, const char* on = "on", const char* off = "off") const {
        row(words, model_.say(value ? on : off), [&](int) { value = !value; });
    }
    void share(const char* words, double& value, double grain, double lowest, double highest) const {
        row(words, percent(value), [&](int step) { step_number(value, step, grain, lowest, highest); });
    }

  private:
    const Model& model_;
};

void draw_picture(const Model& model, const Rows& rows, Preferences& preferences) {
    rows.section("Picture");
    rows.row(
        "Resolution", fmt::format("{} x {}", model.picture.x, model.picture.y),
        [&](int step) { step_picture(preferences, model.picture, step); }, true);
    rows.flag("Window", preferences.fullscreen, "whole screen", "window");
    rows.row("Quality", model.say(preferences.preset), [&](int step) { step_preset(preferences, step); });
    rows.row(
        "Frame budget",
        preferences.frame_budget > 0 ? fmt::format("{:.0f} ms", *preferences.frame_budget) : model.say("off"),
        [&](int step) { step_budget(preferences, step); });
    rows.row("Field of view", fmt::format("{:.0f}\u00b0", preferences.field_of_view),
             [&](int step) { step_number(preferences.field_of_view, step, 2, 50, 90); });
    rows.row("Brightness", fmt::format("{:+.2g}", preferences.brightness),
             [&](int step) { step_number(preferences.brightness, step, 0.25, -1, 1); });
}

void step_language(const Model& model, Preferences& preferences, int step) {
    const auto found = std::ranges::find(model.languages, model.language);
    const auto at = found == model.languages.end() ? -1 : found - model.languages.begin();
    if (!model.languages.empty()) {
        preferences.language = model.languages[round_to(model.languages.size(), at, step)];
    }
}

void draw_comfort(const Model& model, const Rows& rows, Preferences& preferences) {
    rows.section("Comfort");
    const std::string language =
        model.words != nullptr && !model.words->language().empty() ? model.words->language() : "English";
    rows.row("Language", language, [&](int step) { step_language(model, preferences, step); });
    rows.share("Text size", preferences.text_size, 0.25, 0.75, 2);
    rows.flag("Captions of sounds", preferences.captions);
    rows.flag("Symbols on colours", preferences.symbols);
    rows.flag("Less motion", preferences.less_motion);
    rows.flag("Flickering flames", preferences.flicker);
    rows.flag("Outlines of figures", preferences.rim, "shine", "plain");
}

}  // namespace

std::optional<Event> draw_options(const Model& model, Preferences& preferences) {
    const Rows rows(model);
    draw_shade(model.page, 0.72f, 0.92f, lanthorn::ui::kColumnUnits);
    begin_column(model.page, "options", model.say("Options"), frame_words(model, preferences));
    draw_picture(model, rows, preferences);
    rows.section("Sound");
    rows.share("Effects", preferences.effects, 0.1, 0, 1);
    rows.share("Music", preferences.music, 0.1, 0, 1);
    draw_comfort(model, rows, preferences);
    rows.section("Controls");
    rows.share("Mouse speed", preferences.mouse, 0.1, 0.2, 4);
    rows.share("Stick speed", preferences.stick, 0.1, 0.2, 4);
    rows.share("Stick at rest", preferences.dead_zone, 0.02, 0, 0.5);
    rows.flag("Look up and down", preferences.invert_look, "inverted", "as usual");
    rows.flag("Turning", preferences.hold_by_press, "a press begins it", "while the key is held");
    std::optional<Event> event;
    rows.row("Keys and buttons", model.say("choose"), [&](int) { event = {Happening::controls}; });
    if (entry(model.page, model.say("Back").c_str()) || wants_back(model.page)) {
        event = {Happening::back};
    }
    end_column(model.page);
    return event;
}

}  // namespace lanthorn::game::ui
