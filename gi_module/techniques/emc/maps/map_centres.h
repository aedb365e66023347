// Where environment maps stand: the centres C, chosen from candidates and kept up to date as things and the
// camera move (Yao et al. 2010, sec. 4). Nothing of the maps themselves is known here (environment_maps.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gi_module/techniques/emc/maps/bulk_motion.h"
#include "gi_module/techniques/emc/maps/candidate_look.h"
#include "gi_module/techniques/emc/maps/coverage.h"
#include "gi_module/techniques/emc/maps/near_centres.h"
#include "gi_module/techniques/emc/maps/selection.h"
#include "gi_module/techniques/emc/maps/unseen_survey.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

class MapCentres {
  public:
    // As CoverageMeter has it.
    void see_by(TriangleSight* sight) { meter_.see_by(sight); }

    // Initial selection: candidates in the open, greedy choice of at most k, refinement until stable. Where k
    // maps cannot show all there is (many rooms), candidates are those of a pool over the whole level that
    // are nearest to the camera on ways through free space, and near ones count more. `elsewhere`: the level
    // is the one of before, the camera is where its maps see nothing.
    void select(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                bool elsewhere);

    // Once a frame, before its other work: where most of what the maps were chosen for moves by about the
    // same vector (BulkMotion), all centres, chosen or not, move along. In levels of many rooms and in
    // surroundings it also finds what the camera reaches.
    struct Reach {
        bool changed = false;  // candidates or their weights have changed: a round of updates is due
        bool lost = false;     // the camera sees no map any more: all are to be chosen again
        bool apart = false;    // much of what they were chosen for has left (BulkMotion): the same
        vec3 carried{0};       // how far all centres have come, render space
    };
    Reach follow(const FrameScene& scene, const GiSettings& settings);
    bool many_rooms() const { return near_.found(); }
    const CentrePool& pool() const { return near_.pool(); }  // of many rooms
    // The part around camera and lamps, where centres are placed, of a scene that is much larger
    // (surroundings.h); else empty.
    const Aabb& surroundings() const { return surroundings_; }

    // The work of a progressive update (progressive_update.h): share 0, 1, .. of the candidates is looked at
    // again, and when all `shares` have been, at most one member is exchanged; or one joins, while there are
    // fewer than k members and each of them, the new one too, sees what the others do not. Candidates that a
    // solid now contains are replaced when a round begins.
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
    // Places in selected() that hold another member now.
    struct Changes {
        std::vector<int> replaced;  // nobody sees what those before them showed
        int faded = -1;             // the one of an update; -1: none
        bool added = false;         // one more, at the end
        bool none() const { return faded < 0 && !added; }
    };
    Changes exchange(const GiSettings& settings);

    // Tries centres near places that the picture's rays have met and no map shows; the best ones are
    // reserved, if they are worth it, beside those of the selection. They stay until others are worth more.
    // Cost: ten candidates drawn.
    struct Reserved {
        int replaced = -1;  // the place in selected() of one that stands elsewhere now
        int added = 0;      // or so many more at its end
    };
    Reserved reserve(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                     const UnseenSurvey& survey);

    const std::vector<vec3>& candidates() const { return candidates_; }
    // Indices into candidates(); from its size on, of reserved centres.
    const std::vector<int>& selected() const { return selected_; }
    vec3 centre(int index) const;      // of selected()
    EmcStatistics statistics() const;  // of centres alone

  private:
    static std::vector<int> range(int count);  // 0, 1, ..
    void carry(const vec3& by);
    bool left_surroundings(const vec3& eye) const;
    void find_surroundings(const FrameScene& scene, const render::GpuScene& gpu_scene);
    std::vector<bool> candidates_in_use() const;
    void replace_closed(const GiSettings& settings);
    void choose_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                           const GiSettings& settings);
    // Members of C that nobody reaches any more make room; at which places.
    std::vector<int> replace_left_behind(const Exchange& exchange);
    void choose_maps(const GiSettings& settings);
    void take_reached(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings);
    std::vector<vec3> selected_centres() const;
    void draw_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const GiSettings& settings);
    bool open(const Coverage& coverage) const;
    MeasureCoverage open_area();
    // What has come to lie in a solid is neither chosen nor kept.
    double usable_area(const Coverage& coverage, int candidate) const;
    std::vector<double> usable_areas(const std::vector<Coverage>& seen,
                                     const std::vector<int>& viewers) const;
    std::vector<int> share_of(int share, int shares, const GiSettings& settings) const;
    std::vector<int> unselected(const std::vector<int>& candidates) const;

    // After the candidates the meter has reserved centres in use, then those that are tried.
    static constexpr int kMostReserved = 2;
    static constexpr int kTrials = 8;
    // Of the first map's area: a map that adds less is not drawn.
    static double negligible_area(const GiSettings& settings);

    CoverageMeter meter_;
    Aabb bulk_;  // that candidates fill
    BulkMotion motion_;
    Aabb surroundings_;
    std::vector<vec3> candidates_;  // U, render space
    std::vector<vec3> reserved_;    // centres
    NearCentres near_;              // of many rooms
    std::vector<int> selected_;     // C
    CandidateLook look_;            // under way
    int looked_at_ = 0;             // candidates of it so far
    bool ask_again_ = false;        // they were asked of other members
    int next_point_ = 0;            // of the sequence that candidates are drawn from
    double largest_ = 0;  // m^2 that count, of the candidate that saw most when all had been seen last
    // A share whose answers have not come: what all of its candidates see, then A(v | C) of these.
    struct Asked {
        bool first = false;                       // of a look
        std::vector<int> candidates, unselected;  // of the latter some may be of earlier shares
    };
    std::optional<Asked> share_;
    std::vector<int> larger_;  // C and the best candidate: asked, not answered
    std::vector<int> judged_;  // the same of the answer, own_: what each of them alone sees
    std::vector<double> own_;  // none if nothing was asked in the frame before
    EmcStatistics statistics_;
};

}  // namespace lanthorn::gi
