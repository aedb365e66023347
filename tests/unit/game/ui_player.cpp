#include "tests/unit/game/ui_player.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "game/screens/menu_keys.h"
#include "lanthorn/ui/navigation.h"

namespace lanthorn::game::ui {

Player::Player(ivec2 size, double text_size) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = 0.05f;
    io.ConfigFlags = ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad;
    for (const auto& [key, code] : {std::pair(ImGuiKey_UpArrow, GLFW_KEY_UP),
                                    {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                    {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                    {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                    {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                    {ImGuiKey_Space, GLFW_KEY_SPACE},
                                    {ImGuiKey_Escape, GLFW_KEY_ESCAPE}}) {
        io.KeyMap[key] = code;
    }
    model.page.theme = &theme();
    model.page.unit = lanthorn::ui::unit_of(size, text_size);
    std::string missing;
    model.page.fonts = lanthorn::ui::load_fonts(theme(), model.page.unit, &missing);
    EXPECT_EQ(missing, "");
    lanthorn::ui::apply_style(theme(), model.page.unit);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    model.levels = {{"One"}, {"Two", nullptr, true}, {"Three"}, {"Four"}, {"Five"}, {"Six"}};
    model.screens.levels = 6;
    model.picture = {640, 360};
    model.keys.fill("K");
}

std::optional<Event> Player::frame(const std::vector<int>& keys, const PadState& pad) {
    model.pressed.clear();
    for (const int key : keys) {
        model.pressed.push_back({Trigger::Device::keyboard, key});
    }
    for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
        if (pad.buttons[i] && !(model.pad && model.pad->buttons[i])) {
            model.pressed.push_back({Trigger::Device::pad, static_cast<int>(i)});
        }
    }
    model.pad = pad;
    lanthorn::ui::feed_gamepad(pad.buttons, pad.left_x, pad.left_y, ImGui::GetIO());
    if (held_ && !was_held_) {
        model.pressed.push_back({Trigger::Device::keyboard, *held_});
    }
    was_held_ = held_.has_value();
    keys_.feed(static_cast<int>(model.screens.at), !is_played(model.screens.at),
               menu_keys(model.pressed, choices.bindings), [this](int key) { return held_ == key; });
    ImGui::NewFrame();
    page_.update(static_cast<int>(model.screens.at), model.page);
    const std::optional<Event> event = draw_screen(model, choices);
    ImGui::Render();
    return event;
}

std::optional<Event> Player::button(std::size_t code) {
    PadState pad;
    pad.buttons[code] = true;
    return settled(frame({}, pad));
}

void Player::hold(int code) {
    held_ = code;
    frame();
    held_.reset();
}

void Player::show(Screen screen) {
    model.screens.at = screen;
    for (int i = 0; i < 3; ++i) {
        frame();
    }
}

ImRect Player::chosen() const {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    ImRect rect = g.NavWindow->NavRectRel[0];
    rect.Translate(g.NavWindow->DC.CursorStartPos);
    return rect;
}

std::optional<Event> Player::settled(std::optional<Event> event) {
    for (int i = 0; i < 3; ++i) {
        const std::optional<Event> later = frame();
        event = event ? event : later;
    }
    return event;
}

}  // namespace lanthorn::game::ui
