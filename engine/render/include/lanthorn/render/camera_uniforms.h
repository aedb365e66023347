// The camera as camera.glsl reads it.
#pragma once

#include "lanthorn/core/frustum.h"
#include "lanthorn/core/math.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

struct CameraUniforms {
    vec3 position{0};  // render space
    vec3 right{1, 0,
               0};     // perspective: half the image's width at distance 1; orthographic: half width, metres
    vec3 up{0, 1, 0};  // likewise, half height
    vec3 forward{0, 0, -1};  // unit
    bool orthographic = false;
    mat4 clip_from_relative{1};  // (point - position) in render space to clip space, reversed depth
    // Pixels: how far off its middle each pixel's ray passes (shifted()).
    vec2 shift{0};

    // Of a picture of `aspect` = width / height.
    static CameraUniforms from(const CameraView& view, float aspect);
    // The same, looking through each pixel of a picture of `size` at `pixels` from its middle: `forward` of a
    // perspective camera, no longer quite unit, and the position of an orthographic one say so, too.
    CameraUniforms shifted(vec2 pixels, ivec2 size) const;
    // What the camera sees, in render space.
    Frustum frustum() const { return Frustum::of_clip(clip_from_relative, position); }
    // Sets camera_position, camera_right, camera_up, camera_forward, camera_orthographic and
    // camera_clip_from_relative of a program that includes camera.glsl.
    template <class AnyProgram>  // gpu::Program or SceneProgram
    void set(const AnyProgram& program) const {
        program.set("camera_position", position);
        program.set("camera_right", right);
        program.set("camera_up", up);
        program.set("camera_forward", forward);
        program.set("camera_orthographic", orthographic ? 1 : 0);
        program.set("camera_clip_from_relative", clip_from_relative);
    }
};

}  // namespace lanthorn::render
