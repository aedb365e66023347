#include "tests/bench/vertex-map/stages.h"

#include <span>
#include <vector>

#include "gi_module/techniques/vertex-map/kept_tree.h"
#include "gi_module/techniques/vertex-map/photon_turns.h"
#include "gi_module/techniques/vertex-map/shot_scene.h"
#include "gi_module/techniques/vertex-map/vertex_scene.h"
#include "tests/bench/vertex-map/every_surface.h"
#include "tests/bench/vertex-map/thesis_scene.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"

namespace lanthorn::bench {

using namespace gi;

namespace {

// Of a call, by frame; the first frame, which shoots all and finds areas, does not count.
class Times {
  public:
    template <class Call>
    void add(const Call& call) {
        const double start = support::processor_ms();
        call();
        values_.push_back(support::processor_ms() - start);
    }
    double median() const { return support::median(std::span(values_).subspan(1)); }

  private:
    std::vector<double> values_;
};

// The points of light of one way, and what it takes to light them.
struct Estimates {
    Estimates(const FrameScene& scene, const VertexMapSettings& s) : settings(s) {
        vertices.follow(scene, settings);
    }
    std::size_t make(const FrameScene& scene, int frame, const PhotonTree& tree, const PhotonStore& store,
                     reference::TileWorkers& workers) {
        const std::vector<std::uint32_t> wanted = settings.skip == SkippedVertices::none
                                                      ? std::vector<std::uint32_t>()
                                                      : vertices.facing(scene.camera);
        return vertices.estimate(wanted, static_cast<std::uint64_t>(frame) + 1, tree, store, settings,
                                 workers);
    }
    VertexMapSettings settings;
    VertexScene vertices;
};

}  // namespace

Case thesis_case(int side) {
    Case c;
    c.side = side;
    c.settings.total = 2000;
    c.settings.per_frame = 100;
    c.settings.max_level = 3;
    c.settings.direct = true;
    c.settings.nearest = 100;
    c.settings.distance = 0.3f;
    c.settings.kernel = EstimateKernel::constant;
    c.settings.edge = 1;
    c.settings.density = 0;
    c.settings.corners = false;
    c.settings.skip = SkippedVertices::none;
    c.settings.threads = 1;
    return c;
}

Stages measure(const Case& c, int frames) {
    FrameScene drawn = thesis_scene(c.side);
    FrameScene shot = thesis_scene(c.shot_side > 0 ? c.shot_side : c.side);
    const EverySurface every(shot);
    reference::TileWorkers workers(c.settings.threads);
    ShotScene scene;
    PhotonTurns turns;
    PhotonStore store;
    store.reset(static_cast<std::size_t>(c.settings.total), static_cast<std::size_t>(c.settings.max_level));
    const auto together = make_rebuilt_tree(TreeSurfaces::together);
    const auto apart = make_rebuilt_tree(TreeSurfaces::apart);
    KeptTree kept;
    VertexMapSettings as_published = c.settings;
    as_published.any_surface = true;
    as_published.surface_area = false;
    Estimates thesis(drawn, as_published), here(drawn, c.settings);
    Times shoot, ask, one_tree, rebuild, keep, estimate_thesis, estimate_here;
    EverySurface::Asked asked;
    Stages result;
    for (int frame = 0; frame <= frames; ++frame) {
        circle_light(drawn, frame);
        circle_light(shot, frame);
        shoot.add([&] {
            scene.follow(shot, 0);
            turns.outdate();
            const auto count =
                static_cast<std::uint64_t>(frame == 0 ? c.settings.total : c.settings.per_frame);
            turns.shoot(scene.tracer({c.settings.max_level - 1, 1, PhotonScattering::even}), scene.sources(),
                        shot, count, c.settings, store, workers);
        });
        ask.add([&] {
            const EverySurface::Asked now = every.ask(store, shot.lights[0].position);
            asked.rays += now.rays;
            asked.agree += now.agree;
        });
        one_tree.add([&] { together->update(store, frame == 0); });
        rebuild.add([&] { apart->update(store, frame == 0); });
        keep.add([&] { kept.update(store, frame == 0); });
        store.forget_changed();
        estimate_thesis.add([&] { thesis.make(drawn, frame, *together, store, workers); });
        estimate_here.add([&] { result.estimates = here.make(drawn, frame, kept, store, workers); });
    }
    result.thesis = {shoot.median() + ask.median(), one_tree.median(), estimate_thesis.median()};
    result.here = {shoot.median(), keep.median(), estimate_here.median()};
    result.rebuilt = rebuild.median();
    result.stored = store.used();
    result.agree = static_cast<double>(asked.agree) / static_cast<double>(asked.rays);
    return result;
}

}  // namespace lanthorn::bench
