// The 3D picture of an App as a texture that Dear ImGui shows: drawn apart from the panels, and kept while
// the next one is made.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/runtime/app.h"
#include "tools/editor/window/pace.h"

namespace lanthorn::edit_window {

// What the picture that is shown was drawn as: the badge says it.
struct PictureFacts {
    Quality quality = Quality::rest;
    std::string technique, preset, view;  // view: "final", "indirect", ... or a debug view's name
    ivec2 size{0};                        // true pixels
    double ms = 0;                        // of the whole frame
    double changed = 1;                   // share of pixels that differ from the frame before
    double longest_ms = 0;                // between two passes: how long nothing could be answered
};

class Picture {
  public:
    static constexpr int kSame = 2;

    // One frame of the App as it stands, of `size` pixels, from which render.upscale makes a picture of
    // `whole`, if it is on. `breathe` is called between passes, while the
    // picture before is still what texture() shows. Returns the share of pixels that differ from the
    // frame before by more than kSame of 255; 1 where that had another size. Throws what the frame throws;
    // the picture before stays then.
    double draw(App& app, ivec2 size, ivec2 whole, const std::function<void()>& breathe);
    // Which picture is shown of the frames that follow: "final", "indirect", "direct", "albedo", "normals",
    // "depth", "lux", or a debug view of the technique at work. A view that a frame has not is black.
    void set_view(const std::string& view) { view_ = view; }
    const std::string& view() const { return view_; }

    // 0 before the first frame. Rows upwards, as OpenGL has them.
    GLuint texture() const { return shown_.texture.id(); }
    ivec2 size() const { return shown_.texture ? ivec2(shown_.texture.size()) : ivec2(0); }
    const PictureFacts& facts() const { return facts_; }
    PictureFacts& facts() { return facts_; }
    gpu::Texture copy() const;              // of what texture() is now
    int frames() const { return frames_; }  // drawn so far
    // Of a view that has a scale (lux): what its brightest colour means; 0: it has none.
    double scale() const { return scale_; }

  private:
    struct Target {
        gpu::Texture texture;
        gpu::Framebuffer framebuffer;
    };
    static void fit(Target& target, ivec2 size);
    void show_other(App& app, Target& target);

    Target shown_, next_;
    PictureFacts facts_;
    std::string view_ = "final";
    double scale_ = 0;
    int frames_ = 0;
    std::vector<std::uint32_t> pixels_;  // of the frame before
};

// Light that arrives at each visible surface, lux, as far as the frame's pictures tell: indirect light as it
// is, direct light from what surfaces reflect of it. One channel, rows from the top; 0: background. Reads
// three pictures back.
ImageF lux_of(App& app);

// The colour of a share 0..1 in a map of amounts, display-encoded; its luminance grows evenly.
vec3 heat_colour(float share);

}  // namespace lanthorn::edit_window
