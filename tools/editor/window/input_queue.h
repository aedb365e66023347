// What a person does, in order and with its place and time: so that a click or key that begins and ends while
// a long frame is drawn is still one, where it was.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lanthorn/core/math.h"

struct GLFWwindow;

namespace lanthorn::edit_window {

struct Happening {
    enum class Kind { key, press, release, move, wheel, drop };
    Kind kind = Kind::move;
    int code = 0;                                   // GLFW's key or mouse button
    int modifiers = 0;                              // GLFW's, of the moment
    vec2 at{0};                                     // pixels of the window
    float notches = 0;                              // of the wheel, up
    double time = 0;                                // GLFW's
    std::vector<std::filesystem::path> files = {};  // dropped
};

// Listens before Dear ImGui and hands on to it. The release of a key that went down since the last UI frame
// reaches ImGui after that frame: its 1.86 has no queue and would not see the key at all.
class InputQueue {
  public:
    // After ImGui's backend has set its callbacks.
    explicit InputQueue(GLFWwindow* window);
    ~InputQueue();
    InputQueue(const InputQueue&) = delete;
    InputQueue& operator=(const InputQueue&) = delete;

    std::optional<Happening> next();  // the oldest, once
    // Something happened since the last UI frame; `urgent`: more than a pointer that moved.
    bool dirty() const { return dirty_; }
    bool urgent() const { return urgent_; }
    double oldest() const {
        return oldest_;
    }  // GLFW's time of the first urgent happening since the last UI frame
    bool uncovered() const { return uncovered_; }  // since then what the window shows has been lost
    void drawn();                                  // a UI frame has been
    vec2 pointer() const { return pointer_; }
    int modifiers() const;
    bool is_down(int key) const;  // now

  private:
    static InputQueue*& of();
    void add(Happening happening);
    static void on_key(GLFWwindow* window, int code, int scancode, int what, int modifiers);
    static void on_button(GLFWwindow* window, int code, int what, int modifiers);
    static void on_move(GLFWwindow* window, double x, double y);
    static void on_wheel(GLFWwindow* window, double x, double y);
    static void on_char(GLFWwindow* window, unsigned letter);
    static void on_drop(GLFWwindow* window, int count, const char** names);
    static void on_refresh(GLFWwindow* window);
    static void on_focus(GLFWwindow* window, int focused);

    struct Before;
    GLFWwindow* window_;
    std::unique_ptr<Before> before_;
    std::deque<Happening> waiting_;
    std::vector<int> pressed_;                   // keys since the last UI frame
    std::vector<std::pair<int, int>> released_;  // of these: key, modifiers
    bool dirty_ = true, urgent_ = false, uncovered_ = false;
    double oldest_ = 0;
    vec2 pointer_{0};
};

}  // namespace lanthorn::edit_window
