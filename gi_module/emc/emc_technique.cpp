#include "gi_module/emc/emc_technique.h"

#include <algorithm>

namespace lanthorn::gi {

// The frame, in the paper's order. Whether each step runs is the plan's decision alone.
render::IndirectLight EmcTechnique::render(const render::FrameInputs& inputs, const GiSettings& settings) {
    const FrameScene& scene = inputs.scene;
    forget_what_settings_changed(settings, inputs);
    ++history_.frames_since_update;
    plan_ = make_plan(scene, settings, history_);
    if (plan_.bounces == 0) {
        history_ = {};
        irradiance_ = nullptr;
        return {};
    }
    if (scene.changes.geometry || scene.changes.assets || total_area_ == 0) {
        measure_area(scene);
        history_.geometry_pending = true;
    }
    if (plan_.select_maps) {
        const gpu::PassTimer::Scope scope(inputs.timer, "selection");
        maps_.select(scene, inputs.gpu_scene, settings);
    } else if (plan_.draw_maps) {
        const gpu::PassTimer::Scope scope(inputs.timer, "environment_maps");
        maps_.redraw(scene, inputs.gpu_scene);
    }
    maps_.advance_fade(settings);
    if (plan_.update_maps) {
        const gpu::PassTimer::Scope scope(inputs.timer, "progressive_update");
        maps_.update(scene, inputs.gpu_scene, settings);
    }
    if (plan_.select_maps || plan_.update_maps) {
        history_.frames_since_update = 0;
        history_.geometry_pending = false;
    }
    if (maps_.count() == 0) {
        plan_.give_up("no candidate sees the front of a surface: there is no map to trace photons in");
        irradiance_ = nullptr;
        return {};
    }
    if (plan_.trace) {
        photons_.trace(inputs, maps_, settings, plan_.bounces, total_area_);
    }
    if (plan_.gather) {
        const bool maps_changed = plan_.draw_maps || plan_.update_maps || maps_.fading() || history_.fading;
        // What settings alter of the march or of the bandwidth makes photons or image anew.
        const bool surroundings_changed =
            !history_.has_image || !history_.has_photons || scene.changes.camera || maps_changed;
        irradiance_ = &splatting_.irradiance(inputs, maps_, photons_, settings, surroundings_changed);
    }
    history_.has_maps = true;
    history_.has_photons = true;
    history_.has_image = true;
    history_.fading = maps_.fading();
    return {irradiance_, nullptr};
}

void EmcTechnique::forget_what_settings_changed(const GiSettings& settings,
                                                const render::FrameInputs& inputs) {
    const GiSettings& last = last_settings_;
    if (settings.emc_count != last.emc_count || settings.emc_candidates != last.emc_candidates ||
        settings.emc_resolution != last.emc_resolution || settings.seed != last.seed) {
        history_.has_maps = false;
    }
    if (settings.photons != last.photons || settings.bounces != last.bounces || settings.seed != last.seed ||
        settings.emc_search != last.emc_search || settings.emc_steps != last.emc_steps ||
        settings.emc_exhaustive != last.emc_exhaustive || settings.emc_threshold != last.emc_threshold ||
        settings.splat_bandwidth != last.splat_bandwidth || settings.splat_c0 != last.splat_c0) {
        history_.has_photons = false;
    }
    if (settings.splat_base != last.splat_base || settings.splat_contrast != last.splat_contrast ||
        inputs.gbuffer.size() != last_size_) {
        history_.has_image = false;
    }
    last_settings_ = settings;
    last_size_ = inputs.gbuffer.size();
}

// A, the total area of the scene's surfaces, for the bandwidth.
void EmcTechnique::measure_area(const FrameScene& scene) {
    total_area_ = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.assets->meshes[instance.mesh];
        const mat3 linear(instance.transform);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const vec3 p0 = mesh.vertices[mesh.indices[i]].position;
            const vec3 e1 = linear * (mesh.vertices[mesh.indices[i + 1]].position - p0);
            const vec3 e2 = linear * (mesh.vertices[mesh.indices[i + 2]].position - p0);
            total_area_ += 0.5 * static_cast<double>(glm::length(glm::cross(e1, e2)));
        }
    }
}

GiStatistics EmcTechnique::statistics(bool count_photons) {
    GiStatistics result;
    result.plan = plan_;
    result.emc = maps_.statistics();
    if (count_photons) {
        result.photons = photons_.statistics();
    }
    return result;
}

}  // namespace lanthorn::gi
