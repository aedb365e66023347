#include "tools/editor/window/timeline_shown.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::edit_window {

const editor::ClipRow* TimelineShown::shown() const {
    const auto found = std::ranges::find(clips, clip.value_or(starts_with), &editor::ClipRow::key);
    return found == clips.end() ? nullptr : &*found;
}

double TimelineShown::second() const {
    const editor::ClipRow* row = shown();
    return row == nullptr ? 0 : clip_moment(loop, time, row->seconds).time;
}

void TimelineShown::go_to(double second) {
    const editor::ClipRow* row = shown();
    time = row == nullptr ? 0 : std::clamp(second, 0.0, row->seconds);
    moved = true;
}

void TimelineShown::play(bool on, double now) {
    const editor::ClipRow* row = shown();
    playing = on && row != nullptr && row->seconds > 0;
    played_until = now;
    if (playing && loop == LoopMode::once && (speed < 0 ? time <= 0 : time >= row->seconds)) {
        go_to(speed < 0 ? row->seconds : 0);
    }
}

void TimelineShown::play_on(double now) {
    const editor::ClipRow* row = shown();
    if (!playing || row == nullptr) {
        playing = false;
        return;
    }
    time += speed * std::max(0.0, now - played_until);
    played_until = now;
    moved = true;
    if (loop == LoopMode::once && (speed < 0 ? time <= 0 : time >= row->seconds)) {
        time = std::clamp(time, 0.0, row->seconds);
        playing = false;
    }
}

}  // namespace lanthorn::edit_window
