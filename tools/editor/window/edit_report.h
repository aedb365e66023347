// Lines of JSON about what the editor draws, for tests and measurements.
#pragma once

#include <filesystem>
#include <string>

#include "tools/editor/window/editor_state.h"

namespace lanthorn::edit_window {

class EditReport {
  public:
    // Appends to `file`; empty: nothing is written. Throws InputError where it cannot be opened.
    explicit EditReport(const std::filesystem::path& file);
    ~EditReport();
    EditReport(const EditReport&) = delete;
    EditReport& operator=(const EditReport&) = delete;

    // After every turn of the loop: one line where something differs from the line before.
    void line(const EditorState& state);
    // A click or key has been answered by a UI frame, `ms` after it was taken in; `in_frame`: in the middle
    // of a 3D frame. Seconds are of the monotonic clock, when the answer stood on the screen.
    void answer(double ms, bool in_frame);
    // A picture shows what a hand did `ms` ago.
    void followed(double ms);
    bool on() const { return out_ >= 0; }

  private:
    void write(const std::string& line);
    int out_ = -1;
    std::string before_;
};

}  // namespace lanthorn::edit_window
