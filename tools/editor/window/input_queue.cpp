#include "tools/editor/window/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace lanthorn::edit_window {

// Who listened before.
struct InputQueue::Before {
    GLFWkeyfun key;
    GLFWmousebuttonfun button;
    GLFWcursorposfun move;
    GLFWscrollfun wheel;
    GLFWcharfun letter;
    GLFWdropfun drop;
    GLFWwindowrefreshfun refresh;
    GLFWwindowfocusfun focus;
};

// GLFW calls plain functions; a program has one editor window, as it has one context of ImGui.
InputQueue*& InputQueue::of() {
    static InputQueue* only = nullptr;
    return only;
}

InputQueue::InputQueue(GLFWwindow* window) : window_(window), before_(std::make_unique<Before>()) {
    of() = this;
    before_->key = glfwSetKeyCallback(window, on_key);
    before_->button = glfwSetMouseButtonCallback(window, on_button);
    before_->move = glfwSetCursorPosCallback(window, on_move);
    before_->wheel = glfwSetScrollCallback(window, on_wheel);
    before_->letter = glfwSetCharCallback(window, on_char);
    before_->drop = glfwSetDropCallback(window, on_drop);
    before_->refresh = glfwSetWindowRefreshCallback(window, on_refresh);
    before_->focus = glfwSetWindowFocusCallback(window, on_focus);
    double x = 0, y = 0;
    glfwGetCursorPos(window, &x, &y);
    pointer_ = {static_cast<float>(x), static_cast<float>(y)};
}

InputQueue::~InputQueue() {
    glfwSetKeyCallback(window_, before_->key);
    glfwSetMouseButtonCallback(window_, before_->button);
    glfwSetCursorPosCallback(window_, before_->move);
    glfwSetScrollCallback(window_, before_->wheel);
    glfwSetCharCallback(window_, before_->letter);
    glfwSetDropCallback(window_, before_->drop);
    glfwSetWindowRefreshCallback(window_, before_->refresh);
    glfwSetWindowFocusCallback(window_, before_->focus);
    of() = nullptr;
}

void InputQueue::add(Happening happening) {
    happening.time = glfwGetTime();
    happening.at = pointer_;
    if (happening.kind != Happening::Kind::move && !urgent_) {
        urgent_ = true;
        oldest_ = happening.time;
    }
    dirty_ = true;
    // Of a pointer that moves the newest place counts.
    if (happening.kind == Happening::Kind::move && !waiting_.empty() &&
        waiting_.back().kind == Happening::Kind::move) {
        waiting_.back() = std::move(happening);
        return;
    }
    waiting_.push_back(std::move(happening));
}

std::optional<Happening> InputQueue::next() {
    if (waiting_.empty()) {
        return std::nullopt;
    }
    Happening first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
}

void InputQueue::drawn() {
    dirty_ = urgent_ = uncovered_ = false;
    pressed_.clear();
    for (const auto& [code, modifiers] : std::exchange(released_, {})) {
        if (before_->key != nullptr) {
            before_->key(window_, code, 0, GLFW_RELEASE, modifiers);
        }
        dirty_ = true;  // another frame, in which the key is up
    }
}

int InputQueue::modifiers() const {
    const auto down = [&](int left, int right) {
        return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
    };
    return (down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) ? GLFW_MOD_SHIFT : 0) |
           (down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) ? GLFW_MOD_CONTROL : 0) |
           (down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) ? GLFW_MOD_ALT : 0);
}

bool InputQueue::is_down(int key) const {
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

void InputQueue::on_key(GLFWwindow* window, int code, int scancode, int what, int modifiers) {
    InputQueue& q = *of();
    if (what == GLFW_RELEASE && std::ranges::find(q.pressed_, code) != q.pressed_.end()) {
        q.released_.emplace_back(code, modifiers);
        q.dirty_ = true;
        return;
    }
    if (what == GLFW_PRESS) {
        q.pressed_.push_back(code);
    }
    if (what != GLFW_RELEASE) {
        q.add({Happening::Kind::key, code, modifiers});
    }
    q.dirty_ = true;
    if (q.before_->key != nullptr) {
        q.before_->key(window, code, scancode, what, modifiers);
    }
}

void InputQueue::on_button(GLFWwindow* window, int code, int what, int modifiers) {
    InputQueue& q = *of();
    q.add({what == GLFW_PRESS ? Happening::Kind::press : Happening::Kind::release, code, modifiers});
    if (q.before_->button != nullptr) {
        q.before_->button(window, code, what, modifiers);
    }
}

void InputQueue::on_move(GLFWwindow* window, double x, double y) {
    InputQueue& q = *of();
    q.pointer_ = {static_cast<float>(x), static_cast<float>(y)};
    q.add({Happening::Kind::move, 0, q.modifiers()});
    if (q.before_->move != nullptr) {
        q.before_->move(window, x, y);
    }
}

void InputQueue::on_wheel(GLFWwindow* window, double x, double y) {
    InputQueue& q = *of();
    Happening turn{Happening::Kind::wheel, 0, q.modifiers()};
    turn.notches = static_cast<float>(std::clamp(y, -100.0, 100.0));
    q.add(std::move(turn));
    if (q.before_->wheel != nullptr) {
        q.before_->wheel(window, x, y);
    }
}

void InputQueue::on_char(GLFWwindow* window, unsigned letter) {
    InputQueue& q = *of();
    q.dirty_ = true;
    if (q.before_->letter != nullptr) {
        q.before_->letter(window, letter);
    }
}

void InputQueue::on_drop(GLFWwindow* window, int count, const char** names) {
    InputQueue& q = *of();
    Happening drop{Happening::Kind::drop};
    drop.files.assign(names, names + count);
    q.add(std::move(drop));
    if (q.before_->drop != nullptr) {
        q.before_->drop(window, count, names);
    }
}

void InputQueue::on_refresh(GLFWwindow* window) {
    InputQueue& q = *of();
    q.dirty_ = q.uncovered_ = true;
    if (q.before_->refresh != nullptr) {
        q.before_->refresh(window);
    }
}

void InputQueue::on_focus(GLFWwindow* window, int focused) {
    InputQueue& q = *of();
    q.dirty_ = true;
    if (q.before_->focus != nullptr) {
        q.before_->focus(window, focused);
    }
}

}  // namespace lanthorn::edit_window
