// Lines over a picture: gizmos, bounds, ranges of lights. They are drawn onto the picture as it is shown:
// neither exposed nor tone mapped, and no light falls on them.
#pragma once

#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::render {

// A straight line in the world.
struct Line {
    dvec3 from{0}, to{0};  // world space, metres; a line to itself is a dot
    vec4 colour{1};        // as shown (sRGB-encoded), 0..1; a: how much it covers
    float width = 1.5f;    // pixels, of the whole line; ends are round
    bool on_top = false;   // else opaque surfaces that are nearer to the camera hide it
};

// How lines look that several have in common.
struct LineStyle {
    vec4 colour{1};
    float width = 1.5f;
    bool on_top = false;
};

// A list of lines. `Lines` as a resource of an App is drawn in every view, View::lines in one. They stay
// until the program alters them.
struct Lines {
    std::vector<Line> lines;

    void clear() { lines.clear(); }  // they are not drawn from the next frame on
    // From one point of the world to another, in metres.
    void add(const dvec3& from, const dvec3& to, const LineStyle& style = {}) {
        lines.push_back({from, to, style.colour, style.width, style.on_top});
    }
    // The edges of a box at the place that `to_world` gives it: 12 lines.
    void add_box(const dmat4& to_world, const dvec3& lower, const dvec3& upper, const LineStyle& style = {});
    // Around a unit `axis`, in so many lines.
    void add_circle(const dvec3& centre, const dvec3& axis, double radius, const LineStyle& style = {},
                    int lines_around = 48);
    // Three circles about the world's axes.
    void add_sphere(const dvec3& centre, double radius, const LineStyle& style = {}, int lines_around = 48);
};

}  // namespace lanthorn::render
