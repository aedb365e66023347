// A window of the editor under a mouse and a keyboard that xdotool moves.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "tests/unit/tools/run_program.h"
#include "tools/editor/window/editor_state.h"
#include "tools/editor/window/editor_window.h"

namespace lanthorn::edit_window {

class WindowTest : public testing::Test {
  protected:
    // Turns of the editor's loop until that holds; false where it never does: neither in so many turns nor in
    // so long a time, for other threads measure while a turn without a picture takes a millisecond.
    bool comes(const std::function<bool()>& holds) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point latest = Clock::now() + std::chrono::seconds(20);
        for (int turns = 0; turns < 1500 || Clock::now() < latest; ++turns) {
            if (holds()) {
                return true;
            }
            window_->wake();
            if (!window_->turn()) {
                return false;
            }
        }
        return false;
    }
    // The picture stands, and nothing is left to be drawn.
    bool rests() {
        return comes(
            [&] { return state().picture.frames() > 0 && !state().pace.due() && window_->asleep(); });
    }
    static void hand(const std::string& commands) {
        ASSERT_EQ(std::system(("timeout 60 xdotool " + commands + " >/dev/null").c_str()), 0) << commands;
    }
    const EditorState& state() const { return window_->state(); }
    std::size_t steps() const { return state().session.steps().position(); }
    // Where the icon of a light is, by its name; (-1, -1): there is none.
    vec2 icon(const std::string& light) const {
        for (const auto& [name, at] : state().light_places) {
            if (name == light) {
                return at;
            }
        }
        return vec2(-1);
    }
    static std::string at(const vec2& p) {
        return std::to_string(static_cast<int>(p.x)) + " " + std::to_string(static_cast<int>(p.y));
    }
    // Takes the arrow that points up from a chosen thing there, and drags it up.
    static void drag_up(const vec2& from) {
        const vec2 arrow = from - vec2(2, 55);
        hand("mousemove " + at(arrow) + " mousedown 1 mousemove " + at(arrow - vec2(0, 12)) + " mousemove " +
             at(arrow - vec2(0, 24)));
    }

    testing_tools::TemporaryFolder folder_;
    std::unique_ptr<EditorWindow> window_;
};

}  // namespace lanthorn::edit_window
