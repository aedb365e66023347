// The selected environment maps C: chosen from candidates, kept up to date, faded when one is exchanged.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "lanthorn/deformation/detail.h"
#include "lanthorn/gi/emc/centre_pool.h"
#include "lanthorn/gi/emc/coverage.h"
#include "lanthorn/gi/emc/emc_statistics.h"
#include "lanthorn/gi/emc/kept_maps.h"
#include "lanthorn/gi/emc/layered_maps.h"
#include "lanthorn/gi/emc/selection.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

inline constexpr int kMaxMaps = 40;  // MAX_MAPS of intersection.glsl: k up to 32, one to fade, some to spare

class EnvironmentMaps {
  public:
    // Initial selection: candidates in the open, greedy choice of at most k, refinement until stable; then
    // draws them. Where k maps cannot show all there is (many rooms), candidates are those of a pool over the
    // whole level that are nearest to the camera on ways through free space, and near ones count more.
    // `elsewhere`: the level is the one of before, the camera is where its maps see nothing.
    void select(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                bool elsewhere = false);

    // Of many rooms; nothing happens in others. What the camera reaches, once a frame, before its other work.
    struct Reach {
        bool changed = false;  // candidates or what they count are others: a round of updates is due
        bool lost = false;     // no map is in the camera's sight any more: all are to be chosen anew
    };
    Reach follow(const FrameScene& scene, const GiSettings& settings);
    bool many_rooms() const { return pool_.filled(); }
    // Asked for what rays from a slot's lit texels have met when its map is about to leave.
    void keep_rays(std::function<KeptRays(int slot)> rays) { rays_of_ = std::move(rays); }
    // Slots whose maps have come back since the last call, and the rays that were kept with them.
    using Returned = std::vector<std::pair<int, std::shared_ptr<const KeptRays>>>;
    Returned take_returned() { return std::exchange(returned_, {}); }

    // The work of a progressive update (progressive_update.h): share 0, 1, .. of the candidates is seen anew,
    // and when all `shares` have been, at most one map is exchanged (it is drawn and starts to fade in).
    //
    // The GPU's answers are read a frame later: take_answers() comes first in a frame, then a share may be
    // looked at and asked which map the best candidate of the round before should replace, which the exchange
    // in the next frame then knows.
    //
    // What moves does so between the shares: a candidate is judged by the frame it was seen in, and by
    // members of C as they were when they were seen last, up to `shares` frames ago. The choice may differ
    // from that of one look at a moment; which frame looks at what depends on the count of frames alone.
    void look(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
              int share, int shares);
    void take_answers();
    void ask();
    void exchange(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings);

    // Tries centres near places that the picture's rays have met and no map shows; the best ones get maps of
    // their own (drawn), if they are worth it, beside those of the selection. They stay until others are
    // worth more. Whether there is another map now. Cost: ten candidates drawn; for a map more, all maps.
    bool reserve(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                 const UnseenSurvey& survey);

    // Brings every map in use up to date: geometry has changed.
    void redraw(const FrameScene& scene, const render::GpuScene& gpu_scene);

    // One frame further in a fade, if one is under way.
    void advance_fade(const GiSettings& settings);
    bool fading() const { return fade_in_ >= 0; }

    // Binds the maps to two texture units and sets the uniforms of intersection.glsl.
    void bind(const gpu::Program& program, GLuint planes_unit, GLuint albedo_unit, const GiSettings& settings,
              const FrameScene& scene) const;

    void add_eyes(DetailHints& hints, const dvec3& origin) const;

    int count() const { return static_cast<int>(selected_.size()); }
    int faces_drawn() const { return maps_->faces_touched(); }  // when maps were drawn last
    std::uint64_t version() const { return version_; }          // grows when maps take the place of others
    int slots() const { return static_cast<int>(centres_.size()); }  // one more: of a fade
    EmcStatistics statistics() const;
    ivec2 reserved_slots() const;  // -1: none
    const std::vector<vec3>& candidates() const { return candidates_; }
    // Indices into candidates(); from its size on, of reserved centres.
    const std::vector<int>& selected() const { return selected_; }
    vec3 centre(int index) const;  // of selected()

  private:
    void choose_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                           const GiSettings& settings);
    // The slot gets the map about `centre`: a kept one, or at the next redraw() another. What it showed is
    // kept.
    void replace(int slot, const vec3& centre, const GiSettings& settings);
    void replace_left_behind(const Exchange& exchange, const GiSettings& settings);
    void forget_outdated(const FrameScene& scene, const GiSettings& settings);
    void find_rooms(const FrameScene& scene, const GiSettings& settings);
    void choose_maps(const GiSettings& settings);
    // Candidates are those that the camera reaches: the same centres stay in their places, as do those of C.
    void take_reached(const FrameScene& scene);
    std::vector<double> weights_of_reached(const FrameScene& scene) const;
    bool sees_a_map(const vec3& eye) const;
    void draw_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const GiSettings& settings);
    bool open(const Coverage& coverage) const;
    MeasureCoverage open_area();
    // What has come to lie in a solid is neither chosen nor kept.
    double usable_area(const Coverage& coverage, int candidate) const;
    std::vector<double> usable_areas(const std::vector<Coverage>& seen,
                                     const std::vector<int>& viewers) const;
    // The member of C at `place` gets another map, drawn; the one before fades out.
    void fade_to(std::size_t place, int member, const FrameScene& scene, const render::GpuScene& gpu_scene,
                 const GiSettings& settings);
    // So many maps more, drawn at once.
    void add(const std::vector<int>& members, const FrameScene& scene, const render::GpuScene& gpu_scene,
             const GiSettings& settings);
    std::vector<int> share_of(int share, int shares, const GiSettings& settings) const;
    struct Areas {
        double total = 0;   // all that candidates see
        double missed = 0;  // of it, what no member of C sees
        double coverage() const { return total > 0 ? 1.0 - missed / total : 0.0; }
    };
    std::vector<int> unselected(const std::vector<int>& candidates) const;

    CoverageMeter meter_;
    std::optional<LayeredMaps> maps_;           // one slot more than maps: the one that fades
    Aabb bulk_;                                 // that candidates fill
    std::vector<vec3> candidates_;              // U, render space
    std::vector<vec3> reserved_;                // centres
    CentrePool pool_;                           // of many rooms
    std::vector<CentrePool::Reached> reached_;  // of it, from the camera
    std::vector<int> pooled_;                   // by candidate: which of the pool
    std::vector<double> weight_;                // by candidate: what its area counts; empty: 1
    KeptMaps kept_;
    std::function<KeptRays(int)> rays_of_;
    Returned returned_;
    vec3 eye_{0};  // that reached_ is from
    dvec3 origin_{0};
    bool unsettled_ = false;     // the last round has exchanged a map
    bool in_sight_ = false;      // the camera saw a map when it was looked for last
    std::vector<int> selected_;  // C
    std::vector<double> gain_;   // of the look under way: A(v | C) by candidate, less than 0 where unknown
    Areas seen_;                 // of the look under way
    // A share whose answers have not come: what all of its candidates see, then A(v | C) of these.
    struct Asked {
        bool first = false;  // of a look
        std::vector<int> candidates, unselected;
    };
    std::optional<Asked> share_;
    std::vector<int> larger_;    // C and the best candidate: asked, not answered
    std::vector<int> judged_;    // the same of the answer, own_: what each of them alone sees
    std::vector<double> own_;    // none if nothing was asked in the frame before
    std::vector<int> slot_of_;   // slot of selected_[i]
    std::vector<vec3> centres_;  // by slot
    int spare_slot_ = 0;         // the slot not in use, or fading out
    int fade_in_ = -1;           // slot fading in, or -1
    float fade_ = 1;             // share of photons that use the new map
    std::uint64_t version_ = 0;
    EmcStatistics statistics_;
};

}  // namespace lanthorn::gi
