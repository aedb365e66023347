#include "gi_module/techniques/vertex-map/vertex_map_technique.h"
#include "lanthorn/vertex-map/vertex_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "gi_module/techniques/vertex-map/kept_tree.h"
#include "gi_module/techniques/vertex-map/vertex_views.h"

namespace lanthorn::gi {

namespace {

std::string statistics_in_json(const GiStatistics& gi) {
    const auto& v = gi.of<VertexMapStatistics>();
    return nlohmann::ordered_json{{"photons", v.photons},
                                  {"rays", v.rays},
                                  {"left", v.left},
                                  {"stored", v.stored},
                                  {"corners", v.corners},
                                  {"triangles", v.triangles},
                                  {"seen", v.seen},
                                  {"estimates", v.estimates},
                                  {"mirror_rays", v.mirror_rays},
                                  {"builds", v.builds},
                                  {"shoot_ms", v.shoot_ms},
                                  {"balance_ms", v.balance_ms},
                                  {"estimate_ms", v.estimate_ms}}
        .dump();
}

// Adds the time from here to the end of the scope.
class Stage {
  public:
    explicit Stage(double& ms) : ms_(ms), start_(Clock::now()) {}
    ~Stage() { ms_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& ms_;
    Clock::time_point start_;
};

}  // namespace

void VertexMapTechnique::forget() {
    turns_.begin_again();
    vertices_.clear();
    vertices_known_ = refines_ = false;
    since_refined_ = 0;
    seen_.clear();
    irradiance_ = lamps_ = nullptr;
    mirrors_.clear();
    mirrored_.clear();
}

// Whatever alters the picture begins anew, so that it is the same whatever was set before.
void VertexMapTechnique::follow(const GiSettings& settings, ivec2 size) {
    const auto& now = settings.of<VertexMapSettings>();
    if (!workers_ || now.threads != own().threads) {
        workers_ = std::make_unique<reference::TileWorkers>(now.threads);
    }
    made_by_.follow({now.total, now.per_frame, now.max_level, now.distribution, now.simplify, now.edge,
                     now.density, now.corners, now.distance, now.nearest, now.kernel, now.surface_area,
                     now.any_surface, now.direct, now.tree, settings.bounces, settings.seed,
                     settings.accumulate});
    size_.follow(size);
    skip_.follow(now.skip);
    now_ = {made_by_.version(), size_.version(), skip_.version()};
    settings_ = settings;
}

void VertexMapTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    const float roughness = settings_.specular_roughness;
    follow(settings, size);
    const VertexMapSettings& now = own();
    if (begun_.due(now_) || scene.changes.replaced) {
        begun_.made(now_);
        forget();
        const TreeSurfaces surfaces = now.any_surface ? TreeSurfaces::together : TreeSurfaces::apart;
        tree_ =
            now.tree == TreeKind::kept ? std::make_unique<KeptTree>(surfaces) : make_rebuilt_tree(surfaces);
    }
    VertexMapHistory history;
    history.has_photons = vertices_known_;
    history.has_picture = irradiance_ != nullptr && !pictured_.due(now_);
    history.has_estimates = vertices_known_;
    history.refines = refines_;
    history.left = turns_.left(now);
    history.has_mirrors = mirrors_.has(size) && roughness == settings.specular_roughness;
    plan_ = make_vertex_map_plan(scene, settings, history);
    if (plan_.levels == 0) {
        light_version_ += vertices_known_ ? 1 : 0;
        scene_.clear();
        unsimplified_.clear();
        forget();
    }
}

render::TracedLobes VertexMapTechnique::traced_lobes() const {
    return {plan_.mirrors ? settings_.specular_roughness : 0, plan_.direct};
}

void VertexMapTechnique::carry_photons(const FrameScene& scene) {
    if (!plan_.begins_again && !scene.changes.geometry) {
        return;
    }
    std::unordered_map<SurfaceKey, mat4> moves;
    for (const std::uint32_t i : plan_.begins_again ? std::vector<std::uint32_t>() : scene.changes.moved) {
        const Instance& now = scene.instances[i];
        const auto before = placed_.find(surface_key(now.id, now.mesh));
        if (before == placed_.end() || before->second == now.transform ||
            std::ranges::find(scene.changes.arrived, i) != scene.changes.arrived.end()) {
            continue;  // an arrival has another's number at most
        }
        const mat4 move = now.transform * glm::inverse(before->second);
        bool finite = true;
        for (glm::length_t column = 0; column < 4; ++column) {
            const vec4& c = move[column];
            finite = finite && std::isfinite(c.x + c.y + c.z + c.w);
        }
        if (finite) {  // what had no size cannot be followed
            moves.emplace(before->first, move);
        }
    }
    store_.carry(moves);
    placed_.clear();
    for (const Instance& instance : scene.instances) {
        placed_.emplace(surface_key(instance.id, instance.mesh), instance.transform);
    }
}

void VertexMapTechnique::update(const render::LightInputs& inputs) {
    statistics_ = {};
    if (plan_.levels == 0) {
        return;
    }
    if (plan_.begins_again) {
        turns_.begin_again();
        store_.reset(static_cast<std::size_t>(own().total), static_cast<std::size_t>(own().max_level));
    } else if (plan_.changed) {
        turns_.outdate();
    }
    carry_photons(inputs.scene);
    // Mirrors show what the light maps light, too: where those are others though nothing in the scene has
    // changed (render.shadow.resolution), the frame does more than was planned before they were drawn.
    if (std::exchange(light_maps_, inputs.light_maps.version()) != inputs.light_maps.version() &&
        plan_.mirrors) {
        plan_.set(VertexMapPass::mirrors, true, VertexMapReason::mirrors_show_more);
    }
    sensors_ = inputs.scene.sensors;
    if (plan_.on(VertexMapPass::acceleration_structure)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "acceleration_structure");
        scene_.follow(inputs.scene, own().simplify);
        if (plan_.mirrors && own().simplify > 0) {
            unsimplified_.follow(inputs.scene);
        }
    }
    if (!plan_.mirrors || !(own().simplify > 0)) {
        unsimplified_.clear();
    }
    if (plan_.on(VertexMapPass::photons)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "photons");
        const Stage stage(statistics_.shoot_ms);
        const PhotonTurns::Shot shot =
            turns_.shoot(scene_.tracer({plan_.bounces, settings_.seed, PhotonScattering::even}),
                         scene_.sources(), inputs.scene, plan_.photons, own(), store_, *workers_);
        statistics_.photons = shot.photons;
        statistics_.rays = shot.rays;
        bad_ += shot.bad;
    }
    if (plan_.on(VertexMapPass::tree)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "tree");
        const Stage stage(statistics_.balance_ms);
        tree_->update(store_, plan_.begins_again);
        store_.forget_changed();
        ++version_;
        ++light_version_;
    }
    if (plan_.on(VertexMapPass::corners)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "corners");
        follow_triangles(inputs.scene);
    }
}

void VertexMapTechnique::add_irradiance(const render::LightInputs& /*inputs*/,
                                        const render::SensorTargets& targets) {
    if (plan_.levels == 0 || sensors_.empty()) {
        return;
    }
    const std::vector<SensorPoint> points = sensor_points(scene_.surfaces(), sensors_);
    std::vector<vec4> irradiances;
    irradiances.reserve(points.size());
    for (const SensorPoint& p : points) {
        irradiances.emplace_back(
            vertices_.estimate_at(p.instance, p.position, p.normal, *tree_, store_, own()).irradiance, 0);
    }
    sensor_light_.add(points, irradiances, targets);
}

void VertexMapTechnique::follow_triangles(const FrameScene& scene) {
    vertices_.follow(scene, own());
    std::vector<vec3> positions;
    std::vector<std::uint32_t> triangles;
    vertices_.list_positions(positions);
    vertices_.list_triangles(triangles);
    picture_.set_triangles(positions, triangles);
    vertices_known_ = true;
}

void VertexMapTechnique::find_seen(const render::FrameInputs& inputs) {
    switch (own().skip) {
        case SkippedVertices::none:
            seen_.clear();
            break;
        case SkippedVertices::back_faces:
            seen_ = vertices_.facing(inputs.scene.camera);
            break;
        case SkippedVertices::hidden:
            if (plan_.on(VertexMapPass::seen)) {
                seen_ = picture_.find_seen(inputs);
            }
            break;
    }
}

// Where the rays of pixels that mirror end, and on which of the triangles that light is interpolated over.
void VertexMapTechnique::follow_mirror_rays(const render::FrameInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "mirror_rays");
    if (plan_.on(VertexMapPass::mirror_rays)) {
        mirrors_.shoot(inputs, own().simplify > 0 ? unsimplified_ : scene_.followed(),
                       settings_.specular_roughness, *workers_);
        statistics_.mirror_rays = mirrors_.rays();
    }
    mirrored_.clear();
    for (std::size_t i = 0; i < mirrors_.hits().size(); ++i) {
        const ChainSurface& on = mirrors_.surfaces()[i];
        mirrored_.push_back(mirrors_.hits()[i].kind == kMetSurface
                                ? vertices_.at(on.instance, on.primitive, on.barycentric, on.front)
                                : std::nullopt);
    }
}

void VertexMapTechnique::estimate(const render::FrameInputs& inputs) {
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "seen");
        find_seen(inputs);
    }
    if (plan_.mirrors && (plan_.on(VertexMapPass::mirror_rays) || plan_.on(VertexMapPass::corners))) {
        follow_mirror_rays(inputs);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "estimates");
    const Stage stage(statistics_.estimate_ms);
    std::vector<std::uint32_t> wanted = seen_;
    for (const auto& at : mirrored_) {
        if (at && !wanted.empty()) {
            wanted[at->triangle] = 1;
        }
    }
    statistics_.estimates = vertices_.estimate(wanted, version_, *tree_, store_, own(), *workers_);
    vertices_.list_light(light_, &LightEstimate::irradiance);
    lamp_light_.clear();
    if (plan_.direct) {
        vertices_.list_light(lamp_light_, &LightEstimate::from_lamps);
    }
}

void VertexMapTechnique::mirror(const render::FrameInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "mirrors");
    std::vector<vec4> light(mirrored_.size(), vec4(0));
    for (std::size_t i = 0; i < mirrored_.size(); ++i) {
        for (std::size_t k = 0; k < 3 && mirrored_[i]; ++k) {
            const std::uint32_t corner = mirrored_[i]->corners[k];
            const vec4 there = plan_.direct ? light_[corner] + lamp_light_[corner] : light_[corner];
            light[i] += mirrored_[i]->weights[static_cast<glm::length_t>(k)] * there;
        }
    }
    mirrors_.shade(inputs, settings_.specular_roughness, light, plan_.direct);
}

render::IndirectLight VertexMapTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.levels == 0) {
        return {};
    }
    if (!plan_.mirrors) {  // before estimates: what was mirrored names triangles of frames before
        mirrors_.clear();
        mirrored_.clear();
    }
    if (plan_.on(VertexMapPass::estimates)) {
        estimate(inputs);
        const gpu::PassTimer::Scope scope(inputs.timer, "picture");
        irradiance_ = &picture_.draw(inputs, light_);
        lamps_ = plan_.direct ? &picture_.draw_lamps(inputs, lamp_light_) : nullptr;
        pictured_.made(now_);
    }
    if (plan_.on(VertexMapPass::mirrors)) {
        mirror(inputs);
    }
    if (plan_.on(VertexMapPass::estimates)) {
        // Once all photons have been shot anew: how fine triangles have to be is told by them all.
        since_refined_ += statistics_.photons;
        const bool all = turns_.left(own()) == 0 || since_refined_ >= static_cast<std::uint64_t>(own().total);
        may_coarsen_ = may_coarsen_ || plan_.changed;
        refines_ = all && vertices_.refine(may_coarsen_);
        may_coarsen_ = may_coarsen_ && turns_.left(own()) > 0;
        since_refined_ = all ? 0 : since_refined_;
    }
    statistics_.left = turns_.left(own());
    statistics_.stored = tree_->size();
    statistics_.corners = vertices_.corners();
    statistics_.triangles = vertices_.triangles();
    statistics_.seen = seen_.empty() ? vertices_.triangles() : 0;
    for (const std::uint32_t seen : seen_) {
        statistics_.seen += seen;
    }
    statistics_.builds = scene_.builds();
    return {.irradiance = irradiance_,
            .specular = plan_.mirrors ? &mirrors_.picture() : nullptr,
            .lamps = lamps_};
}

GiStatistics VertexMapTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    result.add(statistics_);
    result.nan_count = bad_ + mirrors_.bad();
    return result;
}

gpu::Texture VertexMapTechnique::debug_view(std::string_view name, const render::FrameInputs& inputs) {
    if (plan_.levels == 0) {
        return {};
    }
    std::vector<vec4> light = light_;
    for (std::size_t i = 0; i < lamp_light_.size(); ++i) {
        light[i] += lamp_light_[i];
    }
    return draw_vertex_map_view(name, vertices_, light, store_, inputs);
}

TechniqueKind add_vertex_map() {
    TechniqueEntry entry;
    entry.name = "vertex-map";
    entry.docs =
        "photons of several frames in a k-d tree, light estimated from them at the vertices of the triangles "
        "(Jozwowski 2002), on the processor";
    entry.has_presets = true;
    entry.reads = {"gi.vertex-map.", "gi.specular.roughness", "gi.bounces", "gi.seed"};
    entry.turns = {{"gi.vertex-map.total", {"2000", "8000", "80000", "320000"}},
                   {"gi.vertex-map.nearest", {"50", "800"}},
                   {"gi.vertex-map.edge", {"1", "0.12", "0.03"}},
                   {"gi.vertex-map.density", {"0", "2"}}};
    entry.debug_views = vertex_map_views();
    entry.declare = declare_vertex_map_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<VertexMapTechnique>(); };
    entry.first_plan = first_vertex_map_plan;
    entry.statistics_json = statistics_in_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi
