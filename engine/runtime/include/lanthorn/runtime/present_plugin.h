// Showing the picture of an App in a window.
#pragma once

#include <epoxy/gl.h>

#include "lanthorn/core/math.h"
#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// Where the picture goes: a resource, to be set before a frame.
struct PresentTarget {
    GLuint framebuffer = 0;  // 0: the window whose context is current
    ivec2 size{0};           // pixels; the picture is scaled to it. 0: nowhere, as for a minimised window
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
