#include "game/menu.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "backends/imgui_impl_glfw.h"
#include "backends/imgui_impl_opengl3.h"
#include "game/components.h"
#include "lanthorn/core/settings_schema.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::game {

namespace {

constexpr std::array<ivec2, 7> kSizes = {ivec2{320, 180}, {480, 270},  {640, 360},  {960, 540},
                                         {1280, 720},     {1600, 900}, {1920, 1080}};

std::string name_of_size(ivec2 size) {
    return fmt::format("{} x {}", size.x, size.y);
}

// What there is to be said of all of a kind.
template <class T>
bool any(const ecs::World& world, bool T::*is) {
    bool found = false;
    world.query<ecs::Read<T>>().each([&](const T& each) { found = found || each.*is; });
    return found;
}

void draw_hints(const ecs::World& world) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({12, io.DisplaySize.y - 12}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowBgAlpha(0.35f);
    ImGui::Begin("hints", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(any(world, &Lantern::carried) ? "E door   F light   G put down   Esc menu"
                                                         : "E door   F light   G pick up   Esc menu");
    if (any(world, &Goal::reached)) {
        ImGui::TextUnformatted("The far room is lit.");
    }
    ImGui::End();
}

void draw_menu(Menu::Choices& choices, double frame_ms) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5f * io.DisplaySize.x, 0.5f * io.DisplaySize.y}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSize({360, 0});
    ImGui::Begin("lamplighter", nullptr,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::Button("Resume", {-1, 0})) {
        choices.open = false;
    }
    ImGui::Separator();
    if (ImGui::BeginCombo("Resolution", name_of_size(choices.size).c_str())) {
        for (const ivec2 size : kSizes) {
            if (ImGui::Selectable(name_of_size(size).c_str(), size == choices.size)) {
                choices.size = size;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::BeginCombo("Preset", choices.preset.empty() ? "as started" : choices.preset.c_str())) {
        for (const std::string_view preset : kPresetNames) {
            const std::string name(preset);
            if (ImGui::Selectable(name.c_str(), name == choices.preset)) {
                choices.preset = name;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::Text("%.1f ms a frame", frame_ms);
    ImGui::Separator();
    if (ImGui::Button("Quit", {-1, 0})) {
        choices.quit = true;
    }
    ImGui::End();
}

}  // namespace

Menu::Menu(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableGamepad | ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

Menu::~Menu() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Menu::draw(Choices& choices, const ecs::World& world, double frame_ms) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    draw_hints(world);
    if (choices.open) {
        draw_menu(choices, frame_ms);
    }
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace lanthorn::game
