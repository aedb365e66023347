// What mouse, keys and acts do in the viewport. Beside it: viewport_camera.cpp has where one looks from,
// viewport_pick.cpp what lies under the pointer, viewport_drag.cpp the handles, viewport_draw.cpp what is
// drawn.
#include "tools/editor/window/viewport.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "lanthorn/scene/components.h"

namespace lanthorn::edit_window {

void Viewport::picture_drawn() {
    const FrameScene& scene = state_.session.world().resource<FrameScene>();
    look_ = scene.camera;
    origin_ = scene.origin;
}

void Viewport::read_light() {
    if (lux_of_frame_ != state_.picture.frames()) {
        lux_ = lux_of(state_.session.app());
        lux_of_frame_ = state_.picture.frames();
    }
}

void Viewport::cancel() {
    finish_drag(false, glfwGetTime());
    navigating_ = Navigating::none;
    state_.pace.hold(false, glfwGetTime());
    marquee_from_.reset();
    pressed_ = false;
}

void Viewport::press(const Happening& h) {
    last_ = pressed_at_ = h.at;
    moved_ = false;
    const bool alt = (h.modifiers & GLFW_MOD_ALT) != 0, shift = (h.modifiers & GLFW_MOD_SHIFT) != 0;
    if (h.code == GLFW_MOUSE_BUTTON_MIDDLE || (h.code == GLFW_MOUSE_BUTTON_LEFT && alt)) {
        navigating_ = shift ? Navigating::pan : Navigating::orbit;
        state_.pace.hold(true, h.time);
        return;
    }
    if (h.code == GLFW_MOUSE_BUTTON_RIGHT) {
        if (handles_.held()) {
            finish_drag(false, h.time);
            return;
        }
        navigating_ = Navigating::fly;
        state_.pace.hold(true, h.time);
        return;
    }
    if (h.code != GLFW_MOUSE_BUTTON_LEFT) {
        return;
    }
    if (handles_.held()) {  // at once: a click ends it
        finish_drag(true, h.time);
        return;
    }
    if (over_divider(h.at)) {
        divides_ = true;
        return;
    }
    if (!state_.places.empty()) {
        place_light(h.at);
        return;
    }
    if (state_.wishes.placing) {
        begin_wish(h.at);
        return;
    }
    pressed_ = true;
    press_adds_ = (h.modifiers & GLFW_MOD_CONTROL) != 0;
    const Part part = state_.tool == Tool::select ? Part::none : handles_.hit(h.at);
    if (part != Part::none) {
        begin_drag(part, h.at);
        state_.pace.hold(true, h.time);
    }
}

void Viewport::move(const Happening& h) {
    const vec2 way = h.at - last_;
    last_ = h.at;
    if (glm::length(h.at - pressed_at_) > kClick * state_.unit) {
        moved_ = true;
    }
    if (divides_) {
        move_divider(h.at);
        return;
    }
    if (makes_wish_) {
        if (moved_) {
            widen_wish(h.at);
        }
        return;
    }
    if (navigating_ != Navigating::none) {
        look_round(way, h.time);
        return;
    }
    if (handles_.held()) {
        drag_pixel_ = h.at;
        drag_modifiers_ = h.modifiers;
        if (moved_ || at_once_) {
            drag_on(h.time);
        }
        return;
    }
    if (pressed_ && moved_) {
        marquee_from_ = pressed_at_;
        return;
    }
    hovered_ = state_.tool == Tool::select ? Part::none : handles_.hit(h.at);
}

void Viewport::release(const Happening& h) {
    divides_ = false;
    if (makes_wish_) {
        end_wish();
        return;
    }
    if (navigating_ != Navigating::none) {
        navigating_ = Navigating::none;
        state_.pace.hold(false, h.time);
        return;
    }
    if (h.code != GLFW_MOUSE_BUTTON_LEFT || !pressed_) {
        return;
    }
    pressed_ = false;
    if (handles_.held()) {
        if (moved_ || !typed_.empty()) {
            finish_drag(true, h.time);
            return;
        }
        handles_.end();  // a click on a handle is one on what lies below
        state_.pace.hold(false, h.time);
    }
    if (marquee_from_) {
        marquee(press_adds_);
        marquee_from_.reset();
        return;
    }
    click(h.at, press_adds_);
}

bool Viewport::take(const Happening& h, bool over) {
    using Kind = Happening::Kind;
    const bool busy = gesture() || pressed_ || divides_ || makes_wish_;
    switch (h.kind) {
        case Kind::press:
            if (!over && !busy) {
                return false;
            }
            press(h);
            return true;
        case Kind::release:
            release(h);
            return busy;
        case Kind::move:
            if (!over && !busy) {
                last_ = h.at;
                hovered_ = Part::none;
                return false;
            }
            move(h);
            return true;
        case Kind::wheel: {
            if (!over) {
                return false;
            }
            approach(h);
            return true;
        }
        case Kind::key:
            return handles_.held() && take_drag_key(h);
        case Kind::drop:
            return false;
    }
    return false;
}

bool Viewport::act(Act act, double now) {
    switch (act) {
        case Act::tool_select:
            state_.tool = Tool::select;
            return true;
        case Act::tool_move:
            state_.tool = Tool::move;
            return true;
        case Act::tool_rotate:
            state_.tool = Tool::rotate;
            return true;
        case Act::tool_scale:
            state_.tool = Tool::scale;
            return true;
        case Act::axis_y:
        case Act::latch_snap:
            state_.snap_latched = !state_.snap_latched;
            return true;
        case Act::local_axes:
            state_.local_axes = !state_.local_axes;
            return true;
        case Act::move_now:
            begin_at_once(Tool::move, now);
            return true;
        case Act::rotate_now:
            begin_at_once(Tool::rotate, now);
            return true;
        case Act::scale_now:
            begin_at_once(Tool::scale, now);
            return true;
        case Act::drop_to_floor:
            drop_to_surface(now);
            return true;
        default:
            return act_on_camera(act, now);
    }
}

}  // namespace lanthorn::edit_window
