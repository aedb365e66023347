// A player of the screens without a window: Dear ImGui draws into memory, keys and a gamepad are pressed by
// hand.
#pragma once

#include <imgui_internal.h>

#include <optional>
#include <vector>

#include "game/screens/pages.h"
#include "lanthorn/ui/navigation.h"

namespace lanthorn::game::ui {

// Of windows: smaller than any, usual ones and a large one.
constexpr ivec2 kSizes[] = {{200, 100}, {640, 360}, {1280, 720}, {3840, 2160}};

class Player {
  public:
    explicit Player(ivec2 size, double text_size = 1);
    ~Player() { ImGui::DestroyContext(); }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    std::optional<Event> frame(const std::vector<int>& keys = {}, const PadState& pad = {});
    // A tap shorter than a frame, and frames for what comes of it.
    std::optional<Event> key(int code) { return settled(frame({code})); }
    std::optional<Event> button(std::size_t code);
    // A frame of a key that stays down.
    void hold(int code);
    void show(Screen screen);
    // Of what would be chosen now, in the window's pixels.
    ImRect chosen() const;

    Model model;
    Choices choices;

  private:
    std::optional<Event> settled(std::optional<Event> event);

    lanthorn::ui::PageState page_;
    lanthorn::ui::KeyQueue keys_;
    std::optional<int> held_;
    bool was_held_ = false;
};

}  // namespace lanthorn::game::ui
