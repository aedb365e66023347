// The menu over the game and the few words on its screen.
#pragma once

#include <string>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

struct GLFWwindow;

namespace lanthorn::game {

class Menu {
  public:
    explicit Menu(GLFWwindow* window);
    ~Menu();
    Menu(const Menu&) = delete;
    Menu& operator=(const Menu&) = delete;

    struct Choices {
        ivec2 size{0};       // of the picture; the window shows it at its own size
        std::string preset;  // empty: as started
        bool open = false;
        bool quit = false;
    };

    // Draws over the window's framebuffer. `world`: the game's, which the words are about; `frame_ms`: a
    // frame's time, shown in the menu. Changes `choices` as the player does.
    void draw(Choices& choices, const ecs::World& world, double frame_ms);
};

}  // namespace lanthorn::game
