// The picture of a FrameScene in an App: G-buffer, shadows, direct light, composite.
#pragma once

#include <cstdint>
#include <memory>

#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// The renderer of an App: a resource. What is drawn is in the resource render::RenderSettings; what indirect
// light adds in render::IndirectLight.
struct Renderer {
    // Null before the first frame, which makes them.
    std::unique_ptr<render::FrameRenderer> frame;
    std::unique_ptr<gpu::PassTimer> timer;
    bool timed = false;
    std::uint64_t frames = 0;  // drawn so far
};

// Needs a resource FrameScene (ScenePlugin extracts one, tests insert their own), and from the first frame on
// a current OpenGL context, which outlives the App: declare it first.
//
//   frame:  (transforms) -> detail -> (skinning ... extract) -> upload -> light_maps -> (gi.update)
//           -> gbuffer -> direct -> (gi.indirect) -> composite
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
