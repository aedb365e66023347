#include "lanthorn/gi/emc/emc_technique.h"

#include <algorithm>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

// The frame, in the paper's order: plan, update, indirect. Whether each step runs is the plan's decision
// alone.
void EmcTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    forget_what_settings_changed(settings, size);
    plan_ = make_emc_plan(scene, settings, history_);
    if (plan_.bounces == 0) {
        history_ = {};
        irradiance_ = nullptr;
    }
}

void EmcTechnique::update(const render::LightInputs& inputs) {
    if (plan_.bounces == 0) {
        return;
    }
    follow_geometry(inputs);
    if (maps_.count() == 0) {
        plan_.give_up();
        irradiance_ = nullptr;
        return;
    }
    if (plan_.on(EmcPass::emission)) {
        ++light_version_;
        photons_.trace(inputs, maps_, settings_, plan_.bounces, total_area_, plan_.pass);
    }
    movers_.follow(inputs.scene);
    follow_rays(inputs.scene);
    if (plan_.on(EmcPass::lit_maps)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_maps");
        lit_maps_.update(inputs, maps_, movers_, exact_.get(), settings_, plan_.bounces,
                         {.forget = plan_.on(EmcPass::selection) || !history_.has_lit,
                          .list = plan_.list_texels,
                          .verify = inputs.scene.changes.geometry || plan_.on(EmcPass::progressive_update),
                          .light = plan_.light_texels,
                          .shoot = plan_.texel_rays},
                         photons_.bad_values());
        forget_points_ = forget_points_ || !history_.has_lit;
        history_.has_lit = true;
        history_.texel_frames = lit_maps_.frames();
    }
}

// The maps: chosen, drawn, looked at, exchanged.
void EmcTechnique::follow_geometry(const render::LightInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    if (scene.changes.geometry || total_area_ == 0) {
        measure_area(scene);
    }
    if (plan_.on(EmcPass::selection)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "selection");
        maps_.select(scene, inputs.gpu_scene, settings_);
        history_.chosen_for = scene.bounds;
        history_.update.reset();
        plan_.faces += maps_.faces_drawn();
    } else if (plan_.on(EmcPass::environment_maps)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "environment_maps");
        maps_.redraw(scene, inputs.gpu_scene);
        plan_.faces += maps_.faces_drawn();
    }
    maps_.advance_fade(settings_);
    if (plan_.on(EmcPass::coverage)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "coverage");
        maps_.look(scene, inputs.gpu_scene, settings_, plan_.update.share, plan_.update.shares);
    }
    if (plan_.on(EmcPass::progressive_update)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "progressive_update");
        const bool faded = maps_.fading();
        maps_.exchange(scene, inputs.gpu_scene, settings_);
        if (!faded && maps_.fading()) {
            plan_.faces += maps_.faces_drawn();
            plan_.set(EmcPass::environment_maps, true, EmcReason::map_exchanged);
        }
    }
    plan_.maps = maps_.count();
    if (!plan_.on(EmcPass::selection)) {
        history_.update.advance(scene.changes.geometry, plan_.update);
    }
}

render::IndirectLight EmcTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.bounces == 0) {
        return {};
    }
    if (plan_.on(EmcPass::splats)) {
        splat(inputs);
    }
    if (plan_.on(EmcPass::gather)) {
        gather(inputs);
    }
    history_.has_maps = true;
    history_.has_image = true;
    history_.fading = maps_.fading();
    return {irradiance_, nullptr};
}

void EmcTechnique::splat(const render::FrameInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    const bool maps_changed = plan_.on(EmcPass::selection) || scene.changes.geometry ||
                              plan_.on(EmcPass::progressive_update) || maps_.fading() || history_.fading;
    // What settings alter of the march or of the bandwidth makes photons or image anew.
    const bool surroundings_changed = !history_.has_image || !history_.has_photons || scene.changes.camera ||
                                      scene.changes.relief || maps_changed;
    GiSettings splats = settings_;
    splats.splat_base = plan_.base;
    irradiance_ = &splatting_.irradiance(inputs, maps_, photons_.arrived(), splats, surroundings_changed,
                                         photons_.bad_values());
    if (plan_.on(EmcPass::accumulation)) {
        irradiance_ = &accumulation_.add(*irradiance_, plan_.pass);
    }
    history_.passes = plan_.pass + 1;
    history_.has_photons = true;
}

void EmcTechnique::gather(const render::FrameInputs& inputs) {
    irradiance_ =
        &gather_.irradiance(inputs, maps_, lit_maps_, movers_, exact_.get(), settings_,
                            {.forget = plan_.on(EmcPass::selection) || forget_points_,
                             .points = plan_.list_points,
                             .verify = inputs.scene.changes.geometry || plan_.on(EmcPass::progressive_update),
                             .shoot = plan_.point_rays});
    forget_points_ = false;
    history_.point_frames = gather_.frames();
    history_.has_photons = plan_.on(EmcPass::emission) || (history_.has_photons && !plan_.light_texels);
}

void EmcTechnique::follow_rays(const FrameScene& scene) {
    if (settings_.emc_final != EmcFinal::gather || settings_.emc_rays != EmcRays::bvh) {
        exact_.reset();
        return;
    }
    if (!exact_) {
        exact_ = make_exact_rays();
    }
    if (exact_) {
        exact_->follow(scene);
    }
}

void EmcTechnique::forget_what_settings_changed(const GiSettings& settings, ivec2 size) {
    const GiSettings& last = settings_;
    if (settings.emc_count != last.emc_count || settings.emc_candidates != last.emc_candidates ||
        settings.emc_resolution != last.emc_resolution || settings.seed != last.seed) {
        history_.has_maps = false;
    }
    if (settings.emc_update_interval != last.emc_update_interval) {
        history_.update.restart_round();
    }
    if (settings.photons != last.photons || settings.bounces != last.bounces || settings.seed != last.seed ||
        settings.emc_search != last.emc_search || settings.emc_final != last.emc_final ||
        settings.emc_steps != last.emc_steps || settings.emc_exhaustive != last.emc_exhaustive ||
        settings.emc_threshold != last.emc_threshold || settings.splat_bandwidth != last.splat_bandwidth ||
        settings.splat_c0 != last.splat_c0) {
        history_.has_photons = false;
    }
    if (settings.splat_base != last.splat_base || settings.splat_contrast != last.splat_contrast ||
        size != last_size_ || (settings.accumulate > 1) != (last.accumulate > 1)) {
        history_.has_image = false;
    }
    if (settings.bounces != last.bounces || settings.seed != last.seed ||
        settings.emc_search != last.emc_search || settings.emc_steps != last.emc_steps ||
        settings.emc_exhaustive != last.emc_exhaustive || settings.emc_threshold != last.emc_threshold ||
        settings.emc_final != last.emc_final || settings.emc_rays != last.emc_rays) {
        history_.has_lit = false;
    }
    if (settings.gather_grid != last.gather_grid || settings.gather_rays != last.gather_rays ||
        settings.emc_final != last.emc_final || size != last_size_) {
        history_.has_image = false;
        forget_points_ = true;
    }
    settings_ = settings;
    last_size_ = size;
}

// A, the total area of the surfaces that photons can meet, for the bandwidth. What has not moved keeps its
// area.
void EmcTechnique::measure_area(const FrameScene& scene) {
    std::vector<InstanceArea> areas;
    areas.reserve(scene.instances.size());
    total_area_ = 0;
    auto before = areas_.begin();
    for (const Instance& instance : scene.instances) {
        while (before != areas_.end() &&
               std::pair(before->id, before->mesh) < std::pair(instance.id, instance.mesh)) {
            ++before;
        }
        if (scene.material(instance).alpha_mode == AlphaMode::blend) {
            continue;
        }
        InstanceArea now{instance.id,
                         instance.mesh,
                         instance.version,
                         scene.mesh_version(instance).any,
                         mat3(instance.transform),
                         0};
        if (before != areas_.end() && before->same_shape(now)) {
            now.area = before->area;
        } else {
            const InstanceShape shape(scene, instance);
            for (std::size_t t = 0; 3 * t + 2 < shape.indices().size(); ++t) {
                now.area += static_cast<double>(glm::length(shape.half_cross(t, now.linear)));
            }
        }
        total_area_ += now.area;
        areas.push_back(now);
    }
    areas_ = std::move(areas);
}

void EmcTechnique::add_irradiance(const render::SensorTargets& targets) {
    if (plan_.bounces > 0 && maps_.count() > 0) {
        sensor_photons_.add(photons_.arrived(), targets);
    }
}

GiStatistics EmcTechnique::statistics(bool count_photons) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    result.emc = maps_.statistics();
    result.nan_count = photons_.bad_value_count();
    if (settings_.emc_final == EmcFinal::gather) {
        result.gather.rays = plan_.point_rays ? gather_.rays() : 0;
        result.gather.remembered = gather_.remembered();
    }
    if (count_photons) {
        result.photons = photons_.statistics();
        result.gather.lit_texels = lit_maps_.texels().points().count();
        result.gather.rays += plan_.texel_rays ? lit_maps_.rays() : 0;
    }
    return result;
}

}  // namespace lanthorn::gi
