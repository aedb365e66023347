// The picture with what is done in it: looking round, choosing, and dragging handles.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/runtime/picking.h"
#include "tools/editor/window/editor_state.h"
#include "tools/editor/window/input_queue.h"

namespace lanthorn::edit_window {

class Viewport {
  public:
    explicit Viewport(EditorState& state) : state_(state) {}

    // What happens to mouse and keys; `over`: the pointer is over the picture and nothing lies above it.
    // Returns whether it was taken.
    bool take(const Happening& happening, bool over);
    // An act of the keymap that is the viewport's. Returns whether it was.
    bool act(Act act, double now);
    // Moves on what goes on by itself: flying. Returns whether it does.
    bool move_on(double now, double seconds, const InputQueue& input);
    // The picture, and over it badge, icons, handles. Inside an ImGui window of the picture's box.
    void draw(double now);

    // A frame has been drawn from where the session's pose is.
    void picture_drawn();
    // The picture stands still: reads how much light arrives where, for the pointer. Reads it back.
    void read_light();
    // What draw() tints the picture by, while EditorState::error_shown.
    void show_error(const editor::ErrorMap& map);
    // The picture as it is, to stand beside those that follow. Empty where there is none.
    std::shared_ptr<const OtherSide> kept_side() const;
    // With a divider between them, that; null: no more. A step of the history of views.
    void compare(std::shared_ptr<const OtherSide> with, double now);
    // The scene is another: looks from where the session does.
    void look_from_session();
    // All of these nodes, or everything, in the picture.
    void frame(const std::vector<std::uint32_t>& nodes, double now);
    bool gesture() const { return handles_.held() || navigating_ != Navigating::none; }
    void cancel();
    // A wish that a hand is making goes, too.
    void drop_wish();
    const Projector& eye() const { return eye_; }
    // Where the pointer is in the picture, 0..1 from the upper left; nothing where it is elsewhere.
    std::optional<vec2> pointed_place() const;

  private:
    enum class Navigating { none, orbit, pan, fly };
    struct Marked {
        std::uint32_t node;
        Transform local;
        dmat4 parent;  // to the world
    };

    static constexpr float kClick = 4;  // units that the hand may shake within a click

    void press(const Happening& happening);
    void move(const Happening& happening);
    void release(const Happening& happening);
    void click(const vec2& pixel, bool add);
    void marquee(bool add);
    // `jump`: not by a hand that goes on.
    void set_pose(const workbench::CameraPose& pose, double now, bool jump = false);
    // The camera is there; nothing of it is a view that was left.
    void put_pose(const workbench::CameraPose& pose, double now);
    LookedAt looked() const { return {pose_, state_.other_side}; }
    void find_distance();
    bool act_on_camera(Act act, double now);
    // Takes what is chosen without a button that is held.
    void begin_at_once(Tool tool, double now);
    // A hand that looks round has gone so many pixels.
    void look_round(const vec2& way, double now);
    // The wheel: nearer to the point under the pointer, or another speed of flying.
    void approach(const Happening& happening);
    std::vector<std::uint32_t> under(const vec2& pixel);
    // What is chosen goes down to the surface below it.
    void drop_to_surface(double now);
    // A node above it is chosen too, and takes it along.
    bool moves_with_another(std::uint32_t node) const;
    void place_handles();
    // Of what is drawn of a node and of all under it, relative to FrameScene::origin.
    Aabb bounds_of(std::uint32_t node) const;
    void begin_drag(Part part, const vec2& pixel);
    void drag_on(double now);
    void finish_drag(bool keep, double now);
    // A key while a handle is held: digits, an axis, the end. Returns whether it was one.
    bool take_drag_key(const Happening& happening);
    float draw_badge();              // returns where its lines end: pixels from the top
    float draw_progress(float top);  // likewise
    void draw_icons();
    void draw_selection();
    void draw_handles();
    void draw_scale_bar();
    void draw_lux();
    void draw_why_ways();
    void draw_beside_ghosts();  // beside_panel.cpp
    // viewport_wishes.cpp
    std::optional<Picked> surface_at(const vec2& pixel);
    // viewport_pick.cpp: what EditorState::places asks for.
    void place_light(const vec2& pixel);
    void begin_wish(const vec2& pixel);
    void widen_wish(const vec2& pixel);
    void end_wish();
    void draw_wishes_places();
    void draw_error();
    void draw_compared();
    void draw_divider();
    void draw_compare_popup();
    std::string other_words(bool sized) const;  // A's badge
    bool over_divider(const vec2& pixel) const;
    void move_divider(const vec2& pixel);

    EditorState& state_;
    Projector eye_;  // of the picture that is shown
    CameraView look_;
    dvec3 origin_{0};
    Handles handles_;
    Part hovered_ = Part::none;
    Navigating navigating_ = Navigating::none;
    workbench::CameraPose pose_;
    ViewHistory history_;
    double distance_ = 5;  // metres to what is orbited round
    double fly_speed_ = 3;
    vec2 pressed_at_{0}, last_{0};
    bool pressed_ = false, moved_ = false, press_adds_ = false;
    bool divides_ = false;     // holds the divider of two pictures
    bool makes_wish_ = false;  // drags the rim of the newest wish
    bool at_once_ = false;     // a drag without a button
    std::optional<vec2> marquee_from_;
    std::vector<std::uint32_t> last_under_;
    std::size_t cycle_ = 0;
    vec2 clicked_at_{-1e6f};
    // Of a handle's drag.
    std::vector<Marked> marked_;
    vec2 drag_pixel_{0};
    dvec3 dragged_{0};  // metres, so far
    int drag_modifiers_ = 0;
    std::string typed_, change_words_;
    gpu::Texture error_tint_;  // a texel a cell
    ImageF lux_;
    int lux_of_frame_ = -1;
};

}  // namespace lanthorn::edit_window
