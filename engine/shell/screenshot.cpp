// What a window shows, as a file.
#include <epoxy/gl.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <chrono>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/shell/kept_file.h"
#include "lanthorn/shell/window.h"

namespace lanthorn::shell {

ImageF Window::read() {
    const ivec2 size = framebuffer_size();
    ImageF image{size.x, size.y, 3, {}, {}};
    const std::size_t row = static_cast<std::size_t>(size.x) * 3;
    std::vector<unsigned char> bytes(row * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    image.pixels.reserve(bytes.size());
    for (int y = size.y - 1; y >= 0; --y) {  // OpenGL's rows come from below
        const unsigned char* from = bytes.data() + row * static_cast<std::size_t>(y);
        for (std::size_t i = 0; i < row; ++i) {
            image.pixels.push_back(static_cast<float>(from[i]) / 255);
        }
    }
    return image;
}

std::filesystem::path Window::keep_screenshot(std::string_view program) {
    const std::filesystem::path folder = data_file(program, "screenshots");
    if (folder.empty()) {
        throw InputError("screenshots", "", "XDG_DATA_HOME and HOME name no folder to keep them in");
    }
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);  // write_image() says what is wrong
    const std::string moment = fmt::format("{:%Y-%m-%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
    std::filesystem::path file = folder / (moment + ".png");
    for (int next = 2; std::filesystem::exists(file, problem); ++next) {
        file = folder / fmt::format("{}-{}.png", moment, next);
    }
    write_image(file, read());
    return file;
}

}  // namespace lanthorn::shell
