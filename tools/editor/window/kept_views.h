// Where one has looked from: nine views of each file that are kept by number, and the ones that one came
// from. All of it is the editor's: nothing of it is in the file that is edited.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lanthorn/workbench/load_scene.h"
#include "tools/editor/window/other_side.h"

namespace lanthorn::edit_window {

// Views by number, 1 to 9, of each file by its whole path; "" is a scene that is in no file yet.
class KeptViews {
  public:
    static constexpr int kCount = 9;
    static constexpr std::size_t kFiles = 100;  // the ones used longest ago are dropped

    // A line for each view, "NUMBER POSE FILE", as text() has them. Throws InputError with `source` and the
    // line for what is none.
    static KeptViews parse(std::string_view text, std::string_view source);
    std::string text() const;  // without those of ""

    void keep(const std::string& file, int number, const workbench::CameraPose& pose);
    const workbench::CameraPose* find(const std::string& file, int number) const;  // null: none is kept
    // Another name for the same scene: takes over what the old one has.
    void copy(const std::string& from, const std::string& to);
    void forget(const std::string& file);

  private:
    using Views = std::array<std::optional<workbench::CameraPose>, kCount>;
    Views& of(const std::string& file);
    std::vector<std::pair<std::string, Views>> files_;  // the newest first
};

// Views that were left, to go back to and forth again.
class ViewHistory {
  public:
    static constexpr double kRested = 0.5;     // seconds that a view must have stood to be one
    static constexpr std::size_t kMost = 100;  // views

    // The camera goes elsewhere from a view, or another thing stands beside it. `now`: seconds; `jump`: at
    // once, and not by a hand that has moved it a moment ago and goes on.
    void leave(const LookedAt& from, double now, bool jump);
    // The view before and the one after; `here` is the one of now. Nothing where there is none.
    std::optional<LookedAt> back(const LookedAt& here, double now);
    std::optional<LookedAt> forth(const LookedAt& here, double now);
    void clear() { *this = {}; }

  private:
    std::vector<LookedAt> before_, after_;
    double moved_at_ = -1e9;
};

}  // namespace lanthorn::edit_window
