// A GLFW window with an OpenGL 4.5 core context.
#pragma once

#include <memory>
#include <string>

#include "lanthorn/gpu/context.h"

struct GLFWwindow;

namespace lanthorn::gpu {

class WindowContext final : public Context {
  public:
    // Opens a window of `size` pixels. Throws Error(ExitCode::no_gl) if there is no display or no usable GL.
    WindowContext(const std::string& title, ivec2 size, bool vsync);
    ~WindowContext() override;
    WindowContext(const WindowContext&) = delete;
    WindowContext& operator=(const WindowContext&) = delete;

    // Shows what has been drawn into framebuffer 0. With vsync it waits for the screen.
    void swap_buffers();
    bool should_close() const;                      // the person has asked for it
    ivec2 framebuffer_size() const;                 // pixels; 0 by 0: minimised
    GLFWwindow* handle() const { return window_; }  // for input and Dear ImGui

  private:
    void bind() override;

    GLFWwindow* window_ = nullptr;
};

}  // namespace lanthorn::gpu
