// Hits that a lit texel is too wide for, each lit for itself by the light maps: beside lamps, and where a
// short ray meets a surface that a near lamp lights; or all. To who shades they are places as those of lit
// texels are (remembered_hits.h). A light's irradiance at a point needs no coarser cache than the light's own
// map (Dachsbacher and Stamminger 2005, "Reflective Shadow Maps").
#pragma once

#include <functional>
#include <vector>

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class CloseHits {
  public:
    // Hits at a time of the picture's points, of its pixels beside lamps, and of a still picture's pass, in
    // the order of their places; where there are more some go by lit texels, the same ones in every run.
    static constexpr int kSlots = 65536, kPixelSlots = 16384, kStillSlots = 65536;
    static constexpr int kAllSlots = kSlots + kPixelSlots + kStillSlots;
    // Which hits have a slot: those that a texel is too wide for; or every one, for a frame (a still
    // picture's).
    enum class Of { wide_texels, every_hit };
    explicit CloseHits(int slots, Of of = Of::wide_texels) : count_(slots), of_(of) {}

    // Of this frame, before rays are traced: the lamps; `first`: place of the first slot.
    void begin(const render::LightInputs& inputs, int first);
    // After begin(): all slots are free, since whose they were has forgotten its rays. Cost: a copy of them.
    void release();
    // close_hits.glsl: storage bindings 10 to 12, texture units `unit` and the next. `nearness`: vec4 by
    // place.
    void bind(const gpu::Program& program, const gpu::Buffer& nearness, GLuint unit);
    // Around rays that are looked up, in lists of so many: before, and after the second of them, whether
    // slots were too few. Then both are to be looked up once more, `first` by dispatch_again(), with fewer
    // rays that may take one; `left` is empty. Without waiting: else there is nothing to dispatch.
    void open();
    void settle(const EntryList& first, const EntryList& left);
    void dispatch_again() const;
    // After rays have been traced: lists the slots that some of `entries` entries point at, and frees the
    // rest. `use`: gives a program the uniforms of remembered.glsl. Cost: a look at each slot.
    void collect(const std::function<void(const gpu::Program&)>& use, std::size_t entries,
                 float origin_offset);

    const EntryList& listed() const { return listed_; }
    // By slot: vec4, a packed point; uvec2, entry and lit texel.
    const gpu::Buffer& points() const { return points_; }
    const gpu::Buffer& owners() const { return owners_; }
    int first() const { return first_; }
    Of of() const { return of_; }
    // vec4: lamps that have a place and a map.
    const std::vector<vec4>& lamps() const { return lamps_; }
    const gpu::Buffer& lamp_places() const { return lamp_places_; }
    std::size_t bytes() const;

  private:
    int count_;
    Of of_;
    int first_ = 0;
    std::vector<vec4> lamps_;
    gpu::Buffer points_, owners_, free_, all_free_, lamp_places_;
    EntryList listed_;
    gpu::Program slots_, lots_;
    gpu::BufferTexture nearness_view_, lamps_view_, owners_view_;
};

}  // namespace lanthorn::gi
