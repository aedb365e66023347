// Showing the pictures of an App in a window.
#pragma once

#include <epoxy/gl.h>

#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/runtime/view.h"

namespace lanthorn {

// Where in a window a view's picture goes; it is scaled to `size`.
struct Pane {
    ViewId view = ViewId::first;
    ivec2 corner{0};  // pixels: the lower left
    ivec2 size{0};
};

// Where pictures go: a resource, to be set before a frame.
struct PresentTarget {
    GLuint framebuffer = 0;  // 0: the window whose context is current
    ivec2 size{0};           // pixels. 0: nowhere, as for a minimised window
    // One over the other, on black; views that the frame has not drawn are left out. Empty: the first view
    // fills it all.
    std::vector<Pane> panes = {};
};

// Needs RenderPlugin.
//
//   frame:  composite -> present
//
// After a frame the framebuffer is bound as a whole, for a menu to be drawn over it; swapping the window's
// buffers is left to the program.
class PresentPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "present"; }
    void build(App& app) override;
};

}  // namespace lanthorn
