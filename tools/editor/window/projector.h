// From the world to the viewport's pixels and back, in double precision relative to the camera.
#pragma once

#include <optional>

#include "lanthorn/core/math.h"
#include "lanthorn/runtime/picking.h"
#include "lanthorn/scene/frame_scene.h"
#include "tools/editor/window/layout.h"

namespace lanthorn::edit_window {

class Projector {
  public:
    Projector() = default;
    // `origin`: FrameScene::origin. `box`: of the picture in the window.
    Projector(const CameraView& look, const dvec3& origin, const Box& box);

    // Pixels of the window; nothing behind the camera or nearer than its near plane.
    std::optional<vec2> at(const dvec3& world) const;
    // The line's two ends, cut off where it goes behind the camera; nothing where all of it does.
    std::optional<std::pair<vec2, vec2>> line(const dvec3& from, const dvec3& to) const;
    // How many pixels one metre across the view is, there.
    double pixels_a_metre(const dvec3& world) const;
    // Through a pixel of the window.
    PickRay ray(const vec2& pixel) const;

    const dvec3& eye() const { return eye_; }  // world
    dvec3 ahead() const { return -dvec3(axes_[2]); }
    dvec3 right() const { return axes_[0]; }
    dvec3 up() const { return axes_[1]; }
    const Box& box() const { return box_; }

  private:
    dvec3 in_view(const dvec3& world) const { return glm::transpose(axes_) * (world - eye_); }
    vec2 on_screen(const dvec3& view) const;

    CameraView look_;
    dvec3 origin_{0}, eye_{0};
    glm::dmat3 axes_{1};  // the camera's, as columns in the world
    Box box_;
    double focal_ = 1;  // pixels
};

}  // namespace lanthorn::edit_window
