// The picture of a FrameScene in an App: G-buffer, shadows, direct light, composite.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// A view in a frame.
struct DrawnView {
    ViewId id = ViewId::first;
    std::string name;  // as errors and times of passes call it
    std::shared_ptr<render::FrameRenderer> frame;
    // Of this frame, with the view's camera, and with what changed since the view's last frame.
    const FrameScene* scene = nullptr;
    // The view was drawn before, but not in the last frame: what was kept for it does not hold.
    bool restarted = false;
    // What indirect light gives; of the first view it is in the resources of these types.
    render::TracedLobes traced;
    render::IndirectLight indirect;

    // For the plugin.
    std::shared_ptr<FrameScene> own;  // what `scene` is, unless that is the App's
    bool finished = false;            // composed in the frame that drew it last
    bool at_work = false;             // a pass is drawn for it now: as ViewPass says
};

// The renderer of an App: a resource. What is drawn is in the resource render::RenderSettings, or in
// View::settings; what indirect light adds to the first view in render::IndirectLight. The resource
// render::Lines and View::lines are drawn over the pictures.
struct Renderer {
    // Of the first view; null before the first frame, which makes them.
    std::shared_ptr<render::FrameRenderer> frame;
    std::unique_ptr<gpu::PassTimer> timer;
    bool timed = false;
    std::uint64_t frames = 0;  // drawn so far

    std::shared_ptr<render::SceneRenderer> shared;    // what all views have in common
    std::vector<std::unique_ptr<DrawnView>> views;    // drawn in the last frame, the first view first
    std::vector<std::unique_ptr<DrawnView>> resting;  // View::rests

    // A view, and its picture. Throw Error if it was not drawn in the last frame.
    const DrawnView& drawn(ViewId id) const;
    // Its renderer. Throws as drawn().
    const render::FrameRenderer& of(ViewId id) const { return *drawn(id).frame; }
};

// As long as it lives, what is drawn is drawn for that view: DrawnView::at_work says so to what is called
// in the middle of a frame. Passes of views beside the first are timed under the view's name as well.
class ViewPass {
  public:
    ViewPass(const Renderer& renderer, DrawnView& view);
    ~ViewPass();
    ViewPass(const ViewPass&) = delete;
    ViewPass& operator=(const ViewPass&) = delete;

  private:
    DrawnView& view_;
    std::optional<gpu::PassTimer::Scope> whole_;
};

// Runs a pass for every view that is drawn.
template <class Pass>
void for_each_view(const Renderer& renderer, const Pass& pass) {
    for (const std::unique_ptr<DrawnView>& view : renderer.views) {
        const ViewPass at_work(renderer, *view);
        pass(*view);
    }
}

// Needs a resource FrameScene (ScenePlugin extracts one, tests insert their own), and from the first frame on
// a current OpenGL context, which outlives the App: declare it first.
//
//   frame:  (transforms) -> detail -> (skinning ... extract) -> views -> upload -> light_maps -> (gi.update)
//           -> gbuffer -> direct -> (gi.indirect) -> composite -> lines -> upscale
//
// `views` finds who looks, and gives each view its FrameScene: the App's for the first, a copy with another
// camera for others (O(instances) a view). upload and light_maps run once, what follows once a view. A camera
// that has been destroyed is an Error that names the view, before anything is drawn.
class RenderPlugin final : public Plugin {
  public:
    // `timed`: measure passes, which costs a wait for the GPU a pass on a software rasteriser.
    explicit RenderPlugin(bool timed = false) : timed_(timed) {}
    std::string_view name() const override { return "render"; }
    void build(App& app) override;

  private:
    bool timed_;
};

}  // namespace lanthorn
