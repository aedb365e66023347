#include "lanthorn/coarse/coarse_path_technique.h"

#include <fmt/format.h>

#include <algorithm>

#include "lanthorn/coarse/sample_budget.h"

namespace lanthorn::gi {

namespace {

int spacing_of(const GiSettings& settings) {
    return 1 << static_cast<int>(settings.coarse.grid);
}

bool same_paths(const GiSettings& a, const GiSettings& b) {
    return a.bounces == b.bounces && a.seed == b.seed && a.coarse.grid == b.coarse.grid;
}

bool same_picture(const GiSettings& a, const GiSettings& b) {
    return same_paths(a, b) && a.coarse.filter == b.coarse.filter && a.coarse.sigma == b.coarse.sigma;
}

}  // namespace

void CoarsePathTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    const bool other_points = size != size_ || settings.coarse.grid != settings_.coarse.grid;
    if (!workers_ || settings.coarse.threads != settings_.coarse.threads) {
        workers_ = std::make_unique<reference::TileWorkers>(settings.coarse.threads);
    }
    if (!same_paths(settings, settings_) || size != size_) {
        history_.clear();
    }
    const bool same = same_picture(settings, settings_);
    settings_ = settings;
    size_ = size;
    plan_ = {};
    const auto add = [&](std::string pass, bool on, std::string what, std::string why) {
        plan_.entries.push_back({std::move(pass), on, std::move(what), std::move(why)});
    };
    if (const std::string why = no_indirect_light(scene); !why.empty()) {
        for (const char* pass :
             {"acceleration_structure", "points", "paths", "history", "filter", "upsampling"}) {
            add(pass, false, "", why);
        }
        paths_.clear();
        history_.clear();
        irradiance_ = nullptr;
        return;
    }
    plan_.bounces = useful_bounces(scene, settings.bounces);

    const CoarseSettings& c = settings.coarse;
    const SceneChanges& changes = scene.changes;
    const bool first = irradiance_ == nullptr;
    const bool changed = first || !changes.nothing() || changes.assets;
    still_frames_ = changed || !same ? 0 : still_frames_ + 1;
    find_points_ = first || other_points || changes.geometry || changes.camera || changes.relief;
    const int kept = frames_kept();
    trace_ = find_points_ || changed || still_frames_ < kept;
    const int spacing = spacing_of(settings);
    const ivec2 cells = (size + spacing - 1) / spacing;
    add("acceleration_structure", changed, "",
        first              ? "built once"
        : changes.geometry ? "refitted where something moved, rebuilt if something came or went"
                           : "no geometry changed: it holds");
    add("points", find_points_, find_points_ ? fmt::format("{}x{} and extra ones", cells.x, cells.y) : "",
        find_points_ ? "the picture shows something else"
                     : "neither camera nor geometry changed: the points hold");
    add("paths", trace_, trace_ ? fmt::format("{} a point, {} bounces", c.samples, plan_.bounces) : "",
        trace_ ? (changed ? "light or geometry changed" : "the mean over frames still grows")
               : fmt::format("a still picture has its {} frames", kept));
    add("history", trace_, trace_ ? fmt::format("{} frames", kept) : "",
        still_frames_ > 0 ? "light and geometry stand still" : "old light must go");
    add("filter", trace_, trace_ ? fmt::format("{} levels", c.filter) : "",
        trace_ ? "along surfaces, as far as the noise goes" : "the picture holds");
    add("upsampling", trace_ && spacing > 1, "",
        spacing > 1 ? "from the grid; what it lacks has points of its own"
                    : "gi.coarse.grid is 1: full resolution");
}

int CoarsePathTechnique::frames_kept() const {
    const CoarseSettings& c = settings_.coarse;
    return still_frames_ > 0 ? std::max({c.history, c.still_history, settings_.accumulate}) : c.history;
}

void CoarsePathTechnique::update(const render::LightInputs& inputs) {
    if (plan_.bounces == 0 || !trace_) {
        return;
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "acceleration_structure");
    paths_.follow(inputs.scene);
}

render::IndirectLight CoarsePathTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.bounces == 0) {
        return {};
    }
    if (trace_) {
        find_movers(inputs.scene);
        if (find_points_) {
            const gpu::PassTimer::Scope scope(inputs.timer, "points");
            grid_.find(inputs, spacing_of(settings_));
            history_.follow(grid_.points(), {inputs.camera, inputs.scene.origin}, movers_, *workers_);
        }
        {
            const gpu::PassTimer::Scope scope(inputs.timer, "paths");
            history_.age(frames_kept());
            trace();
        }
        const gpu::Texture* light = nullptr;
        {
            const gpu::PassTimer::Scope scope(inputs.timer, "filter");
            const std::span<const PointEstimate> estimates(history_.estimates());
            if (estimates_.bytes() < estimates.size_bytes()) {
                estimates_ = gpu::Buffer(estimates.size_bytes() + estimates.size_bytes() / 8);
            }
            estimates_.write(0, estimates);
            light = &filter_.filter(inputs, grid_.points().cells, grid_.buffer(), estimates_,
                                    settings_.coarse.filter, settings_.coarse.sigma);
        }
        const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
        irradiance_ = &upsampling_.irradiance(inputs, grid_, *light, estimates_);
    } else {
        statistics_.samples = statistics_.rays = 0;
    }
    return {irradiance_, nullptr};
}

// Where what moved rigidly was in the frame before.
void CoarsePathTechnique::find_movers(const FrameScene& scene) {
    movers_.clear();
    for (const std::uint32_t i : scene.changes.moved) {
        const Instance& now = scene.instances[i];
        const auto before = std::ranges::lower_bound(placed_, std::pair(now.id, now.mesh), {},
                                                     [](const Placed& p) { return std::pair(p.id, p.mesh); });
        if (before != placed_.end() && before->id == now.id && before->mesh == now.mesh &&
            before->transform != now.transform && glm::determinant(now.transform) != 0) {
            movers_.push_back({now.bounds, before->transform * glm::inverse(now.transform)});
        }
    }
    placed_.clear();
    for (const Instance& instance : scene.instances) {
        placed_.push_back({instance.id, instance.mesh, instance.transform});
    }
}

// In two rounds where nothing is known of most points: half the paths evenly, then where they found noise.
void CoarsePathTechnique::trace() {
    const SurfacePoints& points = grid_.points();
    std::vector<PointEstimate>& estimates = history_.estimates();
    statistics_ = {};
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        if (points.points[i].distance > 0) {
            ++statistics_.points;
            statistics_.extra_points += i >= points.lattice() ? 1 : 0;
            statistics_.new_points += estimates[i].samples > 0 ? 0 : 1;
        }
    }
    const float samples = settings_.coarse.samples;
    const int rounds = 2 * statistics_.new_points > statistics_.points && samples >= 2 ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<int> counts =
            share_samples(points, estimates, samples / static_cast<float>(rounds), 4 * samples,
                          2 * frames_ + static_cast<std::uint32_t>(round));
        for (const int count : counts) {
            statistics_.samples += static_cast<std::uint64_t>(count);
        }
        statistics_.rays += paths_.trace(points, counts, plan_.bounces, settings_.seed, estimates, *workers_);
    }
    double known = 0;
    for (const PointEstimate& estimate : estimates) {
        known += static_cast<double>(estimate.samples);
    }
    statistics_.history = statistics_.points > 0 ? known / static_cast<double>(statistics_.points) : 0;
    statistics_.builds = paths_.builds();
    ++frames_;
}

GiStatistics CoarsePathTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = plan_;
    result.coarse = statistics_;
    result.nan_count = paths_.nan_count();
    return result;
}

void add_coarse_path() {
    add_technique(TechniqueKind::coarse_path,
                  []() -> std::unique_ptr<Technique> { return std::make_unique<CoarsePathTechnique>(); });
}

}  // namespace lanthorn::gi
