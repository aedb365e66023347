// The 3D picture of an App as a texture that Dear ImGui shows: drawn apart from the panels, and kept while
// the next one is made. Beside it, where that is asked for, the picture of another view of the App.
#pragma once

#include <functional>
#include <optional>
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
    double ms = 0;                        // of the whole frame, as if no other view were drawn in it
    double changed = 1;                   // share of pixels that differ from the frame before
    double longest_ms = 0;                // between two passes: how long nothing could be answered
};

// "rest - emc medium - 416x288 - 96 ms"; `more` is said of the quality, and there is room for the pixels or
// there is not.
std::string picture_words(const PictureFacts& facts, const std::string& more, bool sized = true);

class Picture {
  public:
    static constexpr int kSame = 2;

    // One frame of the App as it stands, of `size` pixels, from which render.upscale makes a picture of
    // `whole`, if it is on. `breathe` is called between passes, while the
    // picture before is still what texture() shows. Returns the share of pixels that differ from the
    // frame before by more than kSame of 255; 1 where that had another size. Throws what the frame throws;
    // the picture before stays then.
    // `other`: a view of the App that is drawn in the same frame, from where the first one looks; the share
    // is the larger of both then. Views that are neither rest (View::rests). Their times are told apart by
    // waiting for each.
    double draw(App& app, ivec2 size, ivec2 whole, std::optional<ViewId> other,
                const std::function<void()>& breathe);
    // Which picture is shown of the frames that follow: "final", "indirect", "direct", "albedo", "normals",
    // "depth", "lux", or a debug view of the technique at work. A view that a frame has not is black.
    void set_view(const std::string& view) { view_ = view; }
    const std::string& view() const { return view_; }

    // 0 before the first frame. Rows upwards, as OpenGL has them.
    GLuint texture() const { return first_.shown.texture.id(); }
    ivec2 size() const { return first_.shown.texture ? ivec2(first_.shown.texture.size()) : ivec2(0); }
    const PictureFacts& facts() const { return first_.facts; }
    PictureFacts& facts() { return first_.facts; }
    // The same of the other view, as the newest frame that drew it has left it; 0: none has since it was
    // forgotten.
    GLuint other_texture() const { return other_.shown.texture.id(); }
    const PictureFacts& other_facts() const { return other_.facts; }
    PictureFacts& other_facts() { return other_.facts; }
    bool other_is_new() const { return other_is_new_; }  // the last frame drew it
    void forget_other();
    gpu::Texture copy() const;              // of what texture() is now
    int frames() const { return frames_; }  // drawn so far
    // Of a view that has a scale (lux): what its brightest colour means; 0: it has none.
    double scale() const { return scale_; }

  private:
    struct Target {
        gpu::Texture texture;
        gpu::Framebuffer framebuffer;
    };
    // One view's.
    struct Side {
        Target shown, next;
        PictureFacts facts;
        std::vector<std::uint32_t> pixels;  // of the frame before
    };
    static void fit(Target& target, ivec2 size);
    // Of the frame that has just been drawn, what view() asks for. The first view's comes first: its scale is
    // the other's, too.
    void show_view(App& app, ViewId view, Target& target);
    // The side's next picture is the one that is shown. Waits for it; returns the share that differs.
    double take(Side& side);

    Side first_, other_;
    bool other_is_new_ = false;
    std::string view_ = "final";
    double scale_ = 0;
    int frames_ = 0;
};

// Light that arrives at each visible surface, lux, as far as the frame's pictures tell: indirect light as it
// is, direct light from what surfaces reflect of it. One channel, rows from the top; 0: background. Reads
// three pictures back.
ImageF lux_of(App& app, ViewId view = ViewId::first);

// The colour of a share 0..1 in a map of amounts, display-encoded; its luminance grows evenly.
vec3 heat_colour(float share);

}  // namespace lanthorn::edit_window
