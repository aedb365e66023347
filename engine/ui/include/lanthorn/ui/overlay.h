// Dear ImGui over a window: its context, with its backends for GLFW and OpenGL.
#pragma once

#include <functional>

struct GLFWwindow;
struct ImDrawData;

namespace lanthorn::ui {

// ImGui's context is the process's: one at a time.
class Overlay {
  public:
    // The window's OpenGL context must be current, here and in every call. Callbacks that the window has are
    // called on; those that are set later must call on what they find.
    explicit Overlay(GLFWwindow* window);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    // Begins a frame: ImGui's calls may follow. `feed`: called when the backend has said what is pressed, to
    // say it otherwise (KeyQueue, feed_gamepad). Keys choose; gamepads do where they are fed.
    void begin(const std::function<void()>& feed = {});
    // Draws it over what the window shows.
    void end();
    // The same in two steps. What is to be drawn: ImGui's until the next begin().
    ImDrawData& made();
    // Draws `some` of it over what the window shows.
    void draw(ImDrawData& some);

    // Call when fonts of ImGui's atlas are others: letters are drawn at the size that they are seen at.
    void renew_fonts();
};

}  // namespace lanthorn::ui
