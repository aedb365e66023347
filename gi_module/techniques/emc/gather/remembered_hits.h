// What rays from surface points have met in the last frames: not radiance but places, shaded anew whenever
// the light on them changes. Light may move or go out without a ray and without lag. Each ray keeps where it
// was shot from, so that it serves whoever sees that place when the camera moves; when things move, those
// that they may have crossed are traced again.
#pragma once

#include <optional>

#include "gi_module/techniques/emc/gather/kept_rays.h"
#include "gi_module/techniques/emc/gather/mover_programs.h"
#include "gi_module/techniques/emc/gather/remembered_guide.h"
#include "gi_module/techniques/emc/gather/remembered_shading.h"
#include "gi_module/techniques/emc/gather/remembered_trace.h"
#include "gi_module/techniques/emc/gather/stale_share.h"
#include "gi_module/techniques/emc/gather/surface_points.h"

namespace lanthorn::gi {

class RememberedHits {
  public:
    // Frames that are remembered; a power of two. The rays of frame f and of f + kFrames have the same
    // directions: nothing new is to be learnt from more frames of a still scene.
    static constexpr int kFrames = 16;

    // Whose points they are: of the picture's grid, which may see any place in any frame; of the lit maps,
    // where a key is a place; or of a still picture's pixels, other ones in each frame: nothing is kept for
    // the next.
    enum class Of { picture, lit_maps, still_picture };
    explicit RememberedHits(Of of) : of_(of) {}

    // Nothing is remembered. Called by the others if there are more points or rays than before.
    void forget();
    // Of the picture: another view, or other surfaces. Rays now serve the points that see their starts, which
    // movers carry along. Cost: a look at one to four points a ray.
    void follow(const SurfacePoints& points, ivec2 grid, int stride, const RayScene& rays,
                const render::FrameInputs& inputs);
    // Things have moved. Rays across them are stale and traced again by the next shoot(); what the others met
    // is looked up in the texels as they are now. `index`, of the lit maps: by key, the number + 1 of its
    // point. Cost: a look at one texel a ray.
    void verify(const SurfacePoints& points, const RayScene& rays, const gpu::Buffer* index);
    // Cosine-distributed rays from all points, those of the R2 sequence (Roberts 2018): a frame's, or four
    // frames' where little is known, but none where all are remembered or, after follow(), enough; and stale
    // ones, at most two frames'. `pass`, of a still picture: rays of each have directions of their own.
    // `radiosity`, of the picture, as shade() has it: what guides the rays. The first frame's go by rays of
    // one slot that nothing guided, which are shot again then; null: nothing guides any. Cost: a ray each.
    void shoot(const SurfacePoints& points, const RayScene& rays, const gpu::Buffer* radiosity = nullptr,
               int pass = 0);
    // Of the lit maps: the rays of `keys` keys from `first` on. Put back, what they met is looked up by the
    // next verify(), and those that do not start at points are dropped. Nothing is put back where there are
    // other slots or rays than when they were kept.
    KeptRays kept(int first, int keys) const;
    void put_back(int first, int keys, const KeptRays& rays);
    // Irradiance in lux at all points, the mean radiosity (lux, by place; a < 0 where no texel is lit) that
    // their rays have met, and that of its luminance squared; -1 where none found what it met. Cost: two
    // fetches a ray.
    const gpu::Buffer& shade(const SurfacePoints& points, const gpu::Buffer& radiosity);

    // The same, of the picture, and by point half of what separates the rays of even and odd numbers, lux;
    // a: the share of what they met that is known, -1: nothing is. Its square is the variance of the mean,
    // as far as the halves know nothing of each other.
    const gpu::Buffer& halves(const SurfacePoints& points, const gpu::Buffer& radiosity);

    // Of exact rays: which of the close hits of `rays` some ray holds, where it ends now.
    void collect(const RayScene& rays);

    // For other programs: the uniforms of remembered.glsl, and on texture units 7 to 10 `cells` (of the
    // picture: by start, the point it serves first), `remembered`, `starts` and `flights`.
    void bind(const gpu::Program& program);

    const gpu::Buffer& irradiance() const { return shading_.irradiance(); }  // of the last shade()
    const gpu::Buffer& known() const {
        return shading_.known();
    }  // float by point: rays behind its irradiance
    // Rays of the last shoot(); waits for the GPU.
    std::uint64_t shot() const;
    std::size_t bytes() const;

  private:
    void allocate(const SurfacePoints& points);
    void build_programs(Search search);
    struct Round {
        bool guided = false;
        bool again = false;       // also the rays that the frame has shot already
        std::uint32_t slots = 1;  // of a point that knows little
        int pass = 0;             // of a still picture
    };
    void shoot_round(const SurfacePoints& points, const RayScene& rays, Round round);
    void list(const SurfacePoints& points, const RayScene& rays, Round round);
    RememberedGuide::Hits guided_hits(const SurfacePoints& points);
    RememberedShading::Hits shaded_hits();
    void dispatch_listed(const EntryList& list);
    void use(const gpu::Program& program);
    const char* span(const char* of_picture, const char* of_maps) const {
        return of_ == Of::lit_maps ? of_maps : of_picture;
    }
    void forget_other_guides(const FrameScene& scene, float local_length);
    void set_carries(const SweptBoxes& movers, float margin);
    int slots() const { return of_ == Of::still_picture ? 1 : kFrames; }
    // Fewer slots while rays live shortly: as of the last verify(), if the frame before ran it; of rays
    // through the maps, which nothing waits for, as of the one before, and where enough are left.
    void fit_memory(const RayScene& rays);
    void use_slots(int slots);
    std::size_t starts() const {
        return static_cast<std::size_t>(capacity_) * static_cast<std::size_t>(slots());
    }
    std::size_t entries() const { return starts() * static_cast<std::size_t>(rays_); }

    Of of_;
    int frame_ = 0;     // of shoot(), counted modulo kFrames
    int capacity_ = 0;  // keys
    int rays_ = 0;
    std::uint64_t maps_version_ = 0;  // EnvironmentMaps::version() of the last verify()
    int slots_in_use_ = kFrames;      // of the picture: fewer where rays do not live as long
    int long_lived_ = 0;              // frames in which rays have lived long enough for more of them
    int frames_since_motion_ = 0;     // that have shot rays
    bool followed_ = false;           // since the last shoot()
    int more_first_ = 0;              // of remembered_shade.comp
    RememberedTrace trace_;
    RememberedGuide guide_;
    RememberedShading shading_;
    vec3 looked_{0, 0, -1};  // of the last follow(): the way the camera looked, and its place in the world
    dvec3 stood_{0};
    gpu::Buffer shot_before_;  // one uint32: in the last shoot(), before its last round
    StaleShare stale_share_;   // of each verify() of the picture
    std::optional<MoverPrograms> verify_, limbs_;
    gpu::Program follow_, carry_, again_, retrace_, list_, there_program_;
    // By entry: slot, ray and key.
    gpu::Buffer flights_;  // uvec2: packed direction, bits of the distance (0: nothing met)
    gpu::Buffer texels_;   // uint32: what was met (lit_hits.glsl)
    // By start: slot and key.
    gpu::Buffer starts_;  // vec4: a packed point
    gpu::Buffer cells_;   // uvec2, of the picture: the point it serves, and its place among those that do
    gpu::Buffer counts_, counts_before_;  // by point of the picture: how many starts serve it
    gpu::Buffer parts_;                   // what carries starts along (remembered_carry.comp)
    EntryList there_;                     // starts that hold rays, of the last verify()
    EntryList stale_;                     // of the last verify()
    EntryList near_;    // stale, if movers were as large as the boxes around them; items to look up
    EntryList listed_;  // to be traced, or looked up again
    gpu::BufferTexture texels_view_, starts_view_, flights_view_, points_view_, keys_view_, cells_view_,
        counts_view_, changed_view_, index_view_, lit_points_view_, parts_view_;
};

}  // namespace lanthorn::gi
