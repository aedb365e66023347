#include "lanthorn/ui/overlay.h"

#include <imgui.h>

#include "backends/imgui_impl_glfw.h"
#include "backends/imgui_impl_opengl3.h"

namespace lanthorn::ui {

Overlay::Overlay(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// The backend reads gamepads too, but not by GLFW's mapping: buttons of most would be mixed up.
void Overlay::begin(const std::function<void()>& feed) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::GetIO().ConfigFlags = ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_NewFrame();
    if (feed) {
        feed();
    }
    ImGui::NewFrame();
}

void Overlay::end() {
    draw(made());
}

ImDrawData& Overlay::made() {
    ImGui::Render();
    return *ImGui::GetDrawData();
}

void Overlay::draw(ImDrawData& some) {
    ImGui_ImplOpenGL3_RenderDrawData(&some);
}

void Overlay::renew_fonts() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

}  // namespace lanthorn::ui
