// Draws the panels that differ from those of the frame before. The others stand in the window already, where
// its display can show parts of it (WindowContext::show_part).
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/core/math.h"
#include "tools/editor/window/layout.h"

namespace lanthorn::edit_window {

class PanelPainter {
  public:
    using Ground = std::pair<Box, ImU32>;  // a panel's own colour

    // Nothing of what was drawn stands in the window any more: all of it is drawn next.
    void forget() { size_ = ivec2(0); }
    // `pictures`: another number whenever a texture that is shown holds something else, fonts aside. `draw`
    // draws what it is given, within its clip rectangles; grounds are cleared before. Returns the parts of
    // the window that were drawn, whole pixels that do not overlap.
    std::vector<Box> paint(ImDrawData& made, std::span<const Ground> grounds, ivec2 size,
                           std::uint64_t pictures, const std::function<void(ImDrawData&)>& draw);

  private:
    struct Painted {
        std::string name;  // of ImGui's window
        std::uint64_t hash = 0;
        Box box;
    };
    std::vector<Box> differing(const std::vector<Painted>& now, std::uint64_t grounds, ivec2 size) const;

    std::vector<Painted> painted_;
    std::uint64_t grounds_ = 0;
    ivec2 size_{0};
};

// What both cover; empty where they do not meet.
Box common(const Box& a, const Box& b);
// Boxes that cover all of these, none of which meets another.
std::vector<Box> without_overlaps(std::vector<Box> boxes);

}  // namespace lanthorn::edit_window
