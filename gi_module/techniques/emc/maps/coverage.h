// New coverage area A(v|C) by eq. 1 (Yao et al. 2010, sec. 4.2), over the candidates' 32x32x6 maps.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/gpu/read_back.h"
#include "gi_module/techniques/emc/maps/layered_maps.h"
#include "gi_module/techniques/emc/maps/unseen_survey.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

inline constexpr int kCoverageResolution = 32;

struct Coverage {
    double area = 0;  // m^2 seen from v and from no other member of C
    double back_share =
        0;  // share of what v sees (in solid angle) that shows its back: near 1 inside a solid
    double seen_share = 0;    // share of the sphere of directions that meets geometry
    double min_distance = 0;  // metres to the nearest surface seen; infinite without any
};

// A texel of what is seen from a place.
struct Seen {
    vec3 direction{0};  // unit
    float distance = 0;
    float solid_angle = 0;
};
using Sight = std::vector<Seen>;

class CoverageMeter {
  public:
    CoverageMeter();

    // The candidates (render space). Their maps are drawn anew if these are others than before.
    void place(const std::vector<vec3>& centres);
    // One of them is elsewhere.
    void move(int candidate, const vec3& centre);
    // Brings the maps of some of them up to date. See LayeredMaps::update.
    void draw(const FrameScene& scene, const render::GpuScene& gpu_scene, const std::vector<int>& candidates,
              int look = 0);

    // Who tells what of many triangles is seen, from here on; may be null, see LayeredMaps::update.
    void see_by(TriangleSight* sight) { sight_ = sight; }

    // What candidates that have been drawn see, one after the other. Waits for the GPU. Cost: all maps are
    // read.
    std::vector<Sight> sights() const;
    // Areas count in full up to this distance from who sees them, and less by its square beyond: of a world
    // without end, what is far is not worth a map. Infinite at first.
    void reach(float metres) { reach_ = metres; }

    // Waits for the GPU. `selected` as C; each viewer v is left out of its own C. O(viewers * 6144 * |C|).
    std::vector<Coverage> measure(const std::vector<int>& viewers, const std::vector<int>& selected);
    // The same in two steps: asked in one frame, taken in a later one, in the order in which it was asked. At
    // most kQuestions at a time. Taking waits for what the GPU had to do until then.
    static constexpr std::size_t kQuestions = gpu::ReadBack::kSlots;
    void ask(const std::vector<int>& viewers, const std::vector<int>& selected);
    std::vector<Coverage> take();
    void forget();  // what was asked

    // Which of the places each viewer sees, of surfaces that face where their rays started. Waits for the
    // GPU. O(viewers * places).
    std::vector<std::vector<bool>> sees(const std::vector<int>& viewers,
                                        const std::vector<UnseenPlace>& places);

  private:
    void use(const gpu::Program& program) const;
    // Into partial_.
    void sum(const std::vector<int>& viewers, const std::vector<int>& selected);

    gpu::Program program_, places_program_;
    float reach_ = std::numeric_limits<float>::infinity();
    std::optional<LayeredMaps> maps_;
    TriangleSight* sight_ = nullptr;
    std::vector<vec3> placed_;
    gpu::Buffer centres_;
    gpu::Buffer viewers_, selected_, partial_;
    gpu::ReadBack answers_;
};

// A centre is usable if it is in the open: no more than a few percent of what it sees are backs, and nothing
// is so near that it hides the rest: nearer than `clearance` of the scene's diagonal.
bool in_the_open(const Coverage& coverage, float diagonal, double clearance = 0.01);

}  // namespace lanthorn::gi
