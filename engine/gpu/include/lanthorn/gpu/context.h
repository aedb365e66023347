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

class IdlePrograms;

class Context {
  public:
    virtual ~Context();
    // GL calls of this thread go to it from now on.
    void make_current();
    const GlInfo& info() const { return info_; }  // of the driver; empty before adopt_current()

  protected:
    Context();
    // Makes it the thread's current one by the window system's call.
    virtual void bind() = 0;
    // Call with the context current: loads functions, checks version and extensions, sets up debug output.
    // Throws Error(ExitCode::no_gl) naming what is missing.
    void adopt_current();

  private:
    GlInfo info_;
    std::shared_ptr<IdlePrograms> idle_programs_;  // linked once a context, for all that draws in it by turns
};

// Whether the current context draws on the CPU (llvmpipe, say): GlInfo::software.
bool draws_in_software();
// Whether compute shaders of the current context can add up over a subgroup: invocations that run side by
// side (GL_KHR_shader_subgroup_arithmetic and _ballot).
bool has_subgroup_sums();

// A context without a display: the first usable EGL device that is no program (unless LIBGL_ALWAYS_SOFTWARE
// is set), else EGL surfaceless, else a software device. Rendering goes to framebuffer objects. Throws
// Error(ExitCode::no_gl) if no context can be made.
std::unique_ptr<Context> create_headless_context();

}  // namespace lanthorn::gpu
