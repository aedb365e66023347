#include "game/screens/interface.h"

#include <GLFW/glfw3.h>

#include <cmath>
#include <utility>

#include "backends/imgui_impl_glfw.h"
#include "backends/imgui_impl_opengl3.h"
#include "game/screens/gamepad_navigation.h"
#include "game/screens/pages.h"

namespace lanthorn::game::ui {

Interface::Interface(GLFWwindow* window, shell::Say say) : window_(window), say_(std::move(say)) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

Interface::~Interface() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// Letters are drawn at the size that they are seen at: fonts are made anew when it changes.
void Interface::follow_size(ivec2 size, double text_size) {
    const float unit = std::round(20 * unit_of(size, text_size)) / 20;
    if (unit == unit_) {
        return;
    }
    unit_ = unit;
    std::string missing;
    fonts_ = load_fonts(unit, &missing);
    apply_style(unit);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    if (!missing.empty() && !std::exchange(said_missing_, true)) {
        say_(missing +
             ": font not found (tools/packages.txt names its package); a plain one takes its place");
    }
}

// The backend reads gamepads too, but not by GLFW's mapping: buttons of most would be mixed up. The model has
// the one that plays.
void Interface::feed_devices(const Model& model, const Bindings& bindings) {
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigFlags = ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_NewFrame();
    feed_gamepad(model.pad, io);
    keys_.feed(model.screens.at, model.pressed, bindings,
               [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; });
}

std::optional<Event> Interface::draw(Model& model, Choices& choices, ivec2 size) {
    follow_size(size, choices.preferences.text_size);
    ImGui_ImplOpenGL3_NewFrame();
    feed_devices(model, choices.bindings);
    ImGui::NewFrame();
    model.unit = unit_;
    model.fonts = fonts_;
    page_.update(model);
    const std::optional<Event> event = draw_screen(model, choices);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return event;
}

}  // namespace lanthorn::game::ui
