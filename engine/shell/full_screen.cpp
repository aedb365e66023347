#include "engine/shell/full_screen.h"

#include <GLFW/glfw3.h>

namespace lanthorn::shell {

void fill_screen(GLFWwindow* window, bool whole, ivec2 size) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) {
        return;
    }
    if (whole) {
        glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        const ivec2 fits = glm::min(size, ivec2(mode->width, mode->height));
        glfwSetWindowMonitor(window, nullptr, (mode->width - fits.x) / 2, (mode->height - fits.y) / 2, fits.x,
                             fits.y, GLFW_DONT_CARE);
    }
}

}  // namespace lanthorn::shell
