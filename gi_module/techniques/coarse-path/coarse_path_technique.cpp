#include "gi_module/techniques/coarse-path/coarse_path_technique.h"
#include "lanthorn/coarse-path/coarse_path.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gi_module/techniques/coarse-path/coarse_views.h"
#include "gi_module/techniques/coarse-path/sample_budget.h"

namespace lanthorn::gi {

namespace {

int spacing_of(const GiSettings& settings) {
    return 1 << static_cast<int>(settings.of<CoarseSettings>().grid);
}

std::string statistics_in_json(const GiStatistics& gi) {
    const auto& coarse = gi.of<CoarseStatistics>();
    return nlohmann::ordered_json{{"points", coarse.points},
                                  {"extra_points", coarse.extra_points},
                                  {"new_points", coarse.new_points},
                                  {"samples", coarse.samples},
                                  {"rays", coarse.rays},
                                  {"history", coarse.history},
                                  {"builds", coarse.builds}}
        .dump();
}

}  // namespace

void CoarsePathTechnique::follow(const GiSettings& settings, ivec2 size) {
    const auto& own = settings.of<CoarseSettings>();
    if (!workers_ || own.threads != settings_.of<CoarseSettings>().threads) {
        workers_ = std::make_unique<reference::TileWorkers>(own.threads);
    }
    sampling_.follow({own.grid, own.samples, own.history, own.still_history, settings.bounces, settings.seed,
                      settings.accumulate});
    size_.follow(size);
    filtering_.follow({own.filter, own.sigma});
    now_ = {sampling_.version(), size_.version(), filtering_.version()};
    settings_ = settings;
}

void CoarsePathTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    follow(settings, size);
    CoarseHistory history;
    history.has_picture = irradiance_ != nullptr;
    history.has_samples = !sampled_.due(now_);
    history.filtered = !filtered_.due(now_);
    history.still_frames = plan_.still_frames;
    if (!history.has_samples) {
        history_.clear();
        paths_.begin_again();
        frames_ = 0;
    }
    plan_ = make_coarse_plan(scene, settings, history);
    if (plan_.bounces == 0) {
        paths_.clear();
        history_.clear();
        irradiance_ = nullptr;
    }
}

void CoarsePathTechnique::update(const render::LightInputs& inputs) {
    if (!plan_.on(CoarsePass::paths)) {
        return;
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "acceleration_structure");
    paths_.follow(inputs.scene);
}

render::IndirectLight CoarsePathTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.bounces == 0) {
        return {};
    }
    if (plan_.on(CoarsePass::paths)) {
        find_movers(inputs.scene);
        if (plan_.on(CoarsePass::points)) {
            const gpu::PassTimer::Scope scope(inputs.timer, "points");
            grid_.find(inputs, spacing_of(settings_));
            history_.follow(grid_.points(), {inputs.camera, inputs.scene.origin}, movers_, *workers_);
        }
        const gpu::PassTimer::Scope scope(inputs.timer, "paths");
        history_.age(plan_.kept);
        trace();
        sampled_.made(now_);
    } else {
        statistics_.samples = statistics_.rays = 0;
    }
    if (plan_.on(CoarsePass::filter)) {
        const gpu::Texture* light = nullptr;
        {
            const gpu::PassTimer::Scope scope(inputs.timer, "filter");
            const std::span<const PointEstimate> estimates(history_.estimates());
            if (estimates_.bytes() < estimates.size_bytes()) {
                estimates_ = gpu::Buffer(estimates.size_bytes() + estimates.size_bytes() / 8);
            }
            estimates_.write(0, estimates);
            light =
                &filter_.filter(inputs, grid_.points().cells, grid_.buffer(), estimates_,
                                settings_.of<CoarseSettings>().filter, settings_.of<CoarseSettings>().sigma);
        }
        const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
        irradiance_ = &upsampling_.irradiance(inputs, grid_, *light, estimates_);
        filtered_.made(now_);
    }
    return {.irradiance = irradiance_};
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
    const GridPoints& points = grid_.points();
    std::vector<PointEstimate>& estimates = history_.estimates();
    statistics_ = {};
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        if (points.points[i].distance > 0) {
            ++statistics_.points;
            statistics_.extra_points += i >= points.lattice() ? 1 : 0;
            statistics_.new_points += estimates[i].samples > 0 ? 0 : 1;
        }
    }
    const float samples = settings_.of<CoarseSettings>().samples;
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

gpu::Texture CoarsePathTechnique::debug_view(std::string_view name, const render::FrameInputs&) {
    return plan_.bounces == 0 ? gpu::Texture() : draw_coarse_view(name, grid_.points(), history_.estimates());
}

GiStatistics CoarsePathTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    result.add(statistics_);
    result.nan_count = paths_.nan_count();
    return result;
}

TechniqueKind add_coarse_path() {
    TechniqueEntry entry;
    entry.name = "coarse-path";
    entry.docs =
        "paths traced from a coarse grid of the picture on the processor and filtered (Schied et al. 2017)";
    entry.has_presets = true;
    entry.reads = {"gi.coarse-path.", "gi.bounces", "gi.seed"};
    entry.turns = {{"gi.coarse-path.grid", {"2", "8", "16"}},
                   {"gi.coarse-path.samples", {"1", "4", "8", "16"}},
                   {"gi.coarse-path.history", {"1", "4", "16"}},
                   {"gi.coarse-path.filter", {"0", "3", "5"}}};
    entry.debug_views = coarse_views();
    entry.declare = declare_coarse_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<CoarsePathTechnique>(); };
    entry.first_plan = first_coarse_plan;
    entry.statistics_json = statistics_in_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi
