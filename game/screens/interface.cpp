#include "game/screens/interface.h"

#include <GLFW/glfw3.h>

#include <cmath>
#include <utility>

#include "game/screens/menu_keys.h"
#include "game/screens/pages.h"
#include "lanthorn/ui/navigation.h"

namespace lanthorn::game::ui {

Interface::Interface(GLFWwindow* window, shell::Say say)
    : window_(window), overlay_(window), say_(std::move(say)) {
    // A held arrow goes on after 0.4 s, every 0.1 s. ImGui's navigation takes 0.72 and 0.8 of what is set
    // here.
    ImGui::GetIO().KeyRepeatDelay = 0.4f / 0.72f;
    ImGui::GetIO().KeyRepeatRate = 0.1f / 0.8f;
}

// Letters are drawn at the size that they are seen at: fonts are made anew when it changes.
void Interface::follow_size(ivec2 size, double text_size) {
    const float unit = std::round(20 * lanthorn::ui::unit_of(size, text_size)) / 20;
    if (unit == unit_) {
        return;
    }
    unit_ = unit;
    std::string missing;
    fonts_ = lanthorn::ui::load_fonts(theme(), unit, &missing);
    lanthorn::ui::apply_style(theme(), unit);
    overlay_.renew_fonts();
    if (!missing.empty() && !std::exchange(said_missing_, true)) {
        say_(missing +
             ": font not found (tools/packages.txt names its package); a plain one takes its place");
    }
}

void Interface::feed_devices(const Model& model, const input::Bindings& bindings) {
    if (model.pad) {
        lanthorn::ui::feed_gamepad(model.pad->buttons, model.pad->left_x, model.pad->left_y, ImGui::GetIO());
    }
    const Screen screen = model.screens.at;
    keys_.feed(static_cast<int>(screen), !is_played(screen), menu_keys(model.pressed, bindings),
               [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; });
}

std::optional<Event> Interface::draw(Model& model, Choices& choices, ivec2 size) {
    follow_size(size, choices.preferences.text_size);
    overlay_.begin([&] { feed_devices(model, choices.bindings); });
    model.page = {.theme = &theme(), .fonts = fonts_, .unit = unit_};
    page_.update(static_cast<int>(model.screens.at), model.page);
    const std::optional<Event> event = draw_screen(model, choices);
    overlay_.end();
    return event;
}

}  // namespace lanthorn::game::ui
