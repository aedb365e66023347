// What a hand drags in the viewport to move, turn and scale: arrows, planes, rings, and a light's reach and
// cone. They keep their size on the screen, and are computed relative to the camera.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tools/editor/window/projector.h"

namespace lanthorn::edit_window {

enum class Tool { select, move, rotate, scale };

// A part that can be taken. x, y, z: along or about an axis; yz, zx, xy: in the plane of two; view: in the
// plane of the picture, or all axes at once.
enum class Part { none, x, y, z, yz, zx, xy, view, range, cone };

// Where handles stand: the pivot, and axes (unit columns) of the world or of what is selected.
struct HandlePlace {
    dvec3 pivot{0};
    glm::dmat3 axes{1};
    // Of a selected light; nothing where it has none.
    std::optional<double> range = {};  // metres
    std::optional<double> cone = {};   // outer angle from its axis, radians; the axis is -Z of `light_axes`
    glm::dmat3 light_axes{1};
};

// How far the hand has gone since it took a part.
struct HandleChange {
    dvec3 move{0};  // metres, world
    glm::dquat turn{1, 0, 0, 0};
    dvec3 stretch{1};   // along the axes
    double range = 0;   // metres; the new one
    double cone = 0;    // radians; the new one
    std::string words;  // "x +1.20 m", for the screen
};

// Steps that snapping goes by.
struct SnapSteps {
    double metres = 0.1, degrees = 15, share = 0.1;
};

class Handles {
  public:
    // For this frame. `unit`: pixels of the text's scale; handles are 88 units long.
    void place(const HandlePlace& at, Tool tool, const Projector& eye, float unit);
    void clear() { lines_.clear(); }

    // The part under a pixel, within 7 units; the nearest to the eye first. none where there is nothing.
    Part hit(const vec2& pixel) const;

    // A hand takes the part. While it is held the place is the one at the start.
    void begin(Part part, const vec2& pixel);
    bool held() const { return part_ != Part::none; }
    Part part() const { return part_; }
    const HandlePlace& taken() const { return taken_; }  // where they stood when the hand began
    // Another axis or plane while dragging (keys X, Y, Z).
    void constrain(Part part) { part_ = part; }
    void end() { part_ = Part::none; }
    // `typed`: a number instead of the hand's way (metres, degrees, factor), along the part's first axis.
    HandleChange change(const vec2& pixel, bool snap, const SnapSteps& steps,
                        std::optional<double> typed) const;

    // A stroke of a part, for drawing: pixels of the window.
    struct Stroke {
        Part part;
        std::vector<vec2> points;
        bool filled = false;  // a closed area: arrow head, plane, box
    };
    std::span<const Stroke> strokes() const { return lines_; }

  private:
    void add_line(Part part, const dvec3& from, const dvec3& to);
    void add_ring(Part part, const dvec3& centre, const dvec3& a, const dvec3& b, bool front_only);
    void add_patch(Part part, std::span<const dvec3> corners);
    void add_knob(Part part, const dvec3& at, float half);
    dvec3 axis(Part part) const;
    dvec3 normal(Part part) const;

    HandlePlace at_, taken_;
    Tool tool_ = Tool::move;
    Projector eye_, taken_eye_;
    float unit_ = 1;
    std::vector<Stroke> lines_;
    Part part_ = Part::none;
    vec2 taken_pixel_{0};
};

// The place along a line (metres from `point` along `axis`, unit) that is nearest to a ray; nothing where
// they run side by side.
std::optional<double> along(const PickRay& ray, const dvec3& point, const dvec3& axis);
// Where a ray meets a plane before it; nothing where it never does.
std::optional<dvec3> on_plane(const PickRay& ray, const dvec3& point, const dvec3& normal);

}  // namespace lanthorn::edit_window
