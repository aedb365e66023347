#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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
    std::string time = fmt::format("{:.0f} ms a frame", model.frame_ms);
    if (model.drawn == model.picture && model.drawn_preset == preferences.preset) {
        return time;
    }
    return fmt::format("{}, drawn at {} x {}, {}", time, model.drawn.x, model.drawn.y, model.drawn_preset);
}

// By `grain`, within its range.
void step_number(double& value, int step, double grain, double lowest, double highest) {
    value = std::clamp(grain * std::round(value / grain + step), lowest, highest);
}

std::string percent(double value) {
    return fmt::format("{:.0f} %", 100 * value);
}

void flag(const Model& model, const char* words, bool& value, const char* on = "on",
          const char* off = "off") {
    row(model.page, words, value ? on : off, [&](int) { value = !value; });
}

}  // namespace

std::optional<Event> draw_options(const Model& model, Preferences& preferences) {
    draw_shade(model.page, 0.72f, 0.92f);
    begin_column(model.page, "options", "Options", frame_words(model, preferences));
    section(model.page, "Picture");
    row(
        model.page, "Resolution", fmt::format("{} x {}", model.picture.x, model.picture.y),
        [&](int step) { step_picture(preferences, model.picture, step); }, true);
    flag(model, "Window", preferences.fullscreen, "whole screen", "window");
    row(model.page, "Quality", preferences.preset, [&](int step) { step_preset(preferences, step); });
    row(model.page, "Frame budget",
        preferences.frame_budget > 0 ? fmt::format("{:.0f} ms", *preferences.frame_budget) : "off",
        [&](int step) { step_budget(preferences, step); });
    section(model.page, "Sound");
    row(model.page, "Effects", percent(preferences.effects),
        [&](int step) { step_number(preferences.effects, step, 0.1, 0, 1); });
    row(model.page, "Music", percent(preferences.music),
        [&](int step) { step_number(preferences.music, step, 0.1, 0, 1); });
    section(model.page, "Comfort");
    row(model.page, "Text size", percent(preferences.text_size),
        [&](int step) { step_number(preferences.text_size, step, 0.25, 0.75, 2); });
    flag(model, "Symbols on colours", preferences.symbols);
    flag(model, "Less motion", preferences.less_motion);
    section(model.page, "Controls");
    row(model.page, "Mouse speed", percent(preferences.mouse),
        [&](int step) { step_number(preferences.mouse, step, 0.1, 0.2, 4); });
    flag(model, "Look up and down", preferences.invert_look, "inverted", "as usual");
    std::optional<Event> event;
    row(model.page, "Keys and buttons", "choose", [&](int) { event = {Happening::controls}; });
    if (entry(model.page, "Back") || wants_back(model.page)) {
        event = {Happening::back};
    }
    end_column(model.page);
    return event;
}

}  // namespace lanthorn::game::ui
