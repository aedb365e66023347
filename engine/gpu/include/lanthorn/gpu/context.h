// One OpenGL 4.5 core context, over a window or without any display, behind one interface.
#pragma once

#include <memory>
#include <string>

#include "lanthorn/core/installation.h"
#include "lanthorn/core/math.h"

namespace lanthorn::gpu {

// An installation's package file defines LANTHORN_SHARE, so that who makes a context has its shaders.
#ifdef LANTHORN_SHARE
inline const bool installation_named = name_installation(LANTHORN_SHARE);
#endif

// Who draws, as OpenGL tells it.
struct GlInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
    bool software = false;  // llvmpipe or another rasteriser on the CPU: GL timer queries mean nothing there
};

class Context {
  public:
    virtual ~Context() = default;
    // GL calls of this thread go to it from now on.
    virtual void make_current() = 0;
    const GlInfo& info() const { return info_; }  // of the driver; empty before adopt_current()

  protected:
    // Call with the context current: loads functions, checks version and extensions, sets up debug output.
    // Throws Error(ExitCode::no_gl) naming what is missing.
    void adopt_current();

  private:
    GlInfo info_;
};

// Whether the current context draws on the CPU (llvmpipe, say): GlInfo::software.
bool draws_in_software();

// A context without a display: the first usable EGL device that is no program (unless LIBGL_ALWAYS_SOFTWARE
// is set), else EGL surfaceless, else a software device. Rendering goes to framebuffer objects. Throws
// Error(ExitCode::no_gl) if no context can be made.
std::unique_ptr<Context> create_headless_context();

}  // namespace lanthorn::gpu
