// A GLFW window with an OpenGL 4.5 core context.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

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

    // Shows what has been drawn into framebuffer 0. With vsync it waits for the screen. After it framebuffer
    // 0 holds nothing that counts.
    void swap_buffers();
    // Whether show_part() can be used: by X11's GLX with GLX_MESA_copy_sub_buffer, as Mesa has it.
    bool can_show_parts() const { return show_part_ != nullptr; }
    // The next swap_buffers() shows this part and others that were named so; the rest of the window stays as
    // it is, and framebuffer 0 holds what was drawn into it. Pixels, from the lower left.
    void show_part(ivec2 corner, ivec2 size);
    // The next swap_buffers() shows nothing more than parts that are named.
    void show_parts_alone();
    bool should_close() const;                      // the person has asked for it
    ivec2 framebuffer_size() const;                 // pixels; 0 by 0: minimised
    GLFWwindow* handle() const { return window_; }  // for input and Dear ImGui

  private:
    void bind() override;
    void find_parts();

    using ShowPart = void (*)(void* display, unsigned long drawable, int x, int y, int width, int height);

    GLFWwindow* window_ = nullptr;
    ShowPart show_part_ = nullptr;  // null: the display cannot
    void* display_ = nullptr;       // X11's, and what GLX draws into
    unsigned long drawable_ = 0;
    bool parts_alone_ = false;
    std::vector<std::pair<ivec2, ivec2>> parts_;  // corner and size
};

}  // namespace lanthorn::gpu
