#include "lanthorn/gpu/window_context.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include "lanthorn/core/error.h"

namespace lanthorn::gpu {

namespace {
std::string glfw_problem() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}
}  // namespace

WindowContext::WindowContext(const std::string& title, ivec2 size, bool vsync) {
    if (!glfwInit()) {
        throw Error(ExitCode::no_gl, "window: GLFW cannot start: " + glfw_problem());
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string problem = glfw_problem();
        glfwTerminate();
        throw Error(ExitCode::no_gl, "window: no window with OpenGL 4.5 core: " + problem);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(vsync ? 1 : 0);
    try {
        adopt_current();
        find_parts();
    } catch (...) {
        glfwDestroyWindow(window_);
        glfwTerminate();
        throw;
    }
}

WindowContext::~WindowContext() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void WindowContext::bind() {
    glfwMakeContextCurrent(window_);
}

// By names alone: GLX is not there on every system.
void WindowContext::find_parts() {
    if (glfwExtensionSupported("GLX_MESA_copy_sub_buffer") == GLFW_FALSE) {
        return;
    }
    const auto display = reinterpret_cast<void* (*)()>(glfwGetProcAddress("glXGetCurrentDisplay"));
    const auto drawable = reinterpret_cast<unsigned long (*)()>(glfwGetProcAddress("glXGetCurrentDrawable"));
    display_ = display != nullptr ? display() : nullptr;
    drawable_ = drawable != nullptr ? drawable() : 0;
    if (display_ != nullptr && drawable_ != 0) {
        show_part_ = reinterpret_cast<ShowPart>(glfwGetProcAddress("glXCopySubBufferMESA"));
    }
}

void WindowContext::show_part(ivec2 corner, ivec2 size) {
    parts_.emplace_back(corner, size);
}

void WindowContext::show_parts_alone() {
    parts_alone_ = can_show_parts();
}

void WindowContext::swap_buffers() {
    if (!std::exchange(parts_alone_, false)) {
        parts_.clear();
        glfwSwapBuffers(window_);
        return;
    }
    for (const auto& [corner, size] : std::exchange(parts_, {})) {
        show_part_(display_, drawable_, corner.x, corner.y, size.x, size.y);
    }
}
bool WindowContext::should_close() const {
    return glfwWindowShouldClose(window_) != 0;
}

ivec2 WindowContext::framebuffer_size() const {
    ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

}  // namespace lanthorn::gpu
