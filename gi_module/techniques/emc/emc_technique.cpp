#include "gi_module/techniques/emc/emc_technique.h"

#include <algorithm>
#include <utility>

#include "gi_module/techniques/emc/maps/surroundings.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

// Frames with rays from one survey of what they met to the next; and after one in vain.
constexpr int kSurveyInterval = 8;
constexpr int kSurveyRest = 32;

}  // namespace

// The frame, in the paper's order: plan, update, indirect. Whether each step runs is the plan's decision
// alone.
void EmcTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& wanted) {
    GiSettings settings = wanted;
    settings.edit<EmcSettings>().gather_grid = gather_stride(wanted, size);
    now_ = inputs_.follow(scene, size, settings);
    history_.forget_outdated(now_);
    settings_ = settings;
    history_.exact_rays = has_exact_rays();
    const EnvironmentMaps::Reach reach =
        history_.has_maps ? maps_.follow(scene, settings) : EnvironmentMaps::Reach();
    history_.reach_changed = reach.changed;
    history_.lost = reach.lost;
    history_.apart = reach.apart;
    plan_ = make_emc_plan(scene, settings, history_);
    if (plan_.bounces == 0) {
        darken(scene.changes);
    }
}

// What follows the scene from change to change has nothing to go by once it has missed one.
void EmcTechnique::darken(const SceneChanges& changes) {
    history_.darken(changes);
    irradiance_ = with_caustics_ = specular_ = nullptr;
    if (!history_.has_maps) {
        exact_.reset();
        gather_rays_ = nullptr;
        total_area_ = 0;
    }
}

void EmcTechnique::update(const render::LightInputs& inputs) {
    if (plan_.bounces == 0) {
        return;
    }
    reserve(inputs);
    follow_light_maps(inputs);
    follow_geometry(inputs);
    if (maps_.count() == 0) {
        plan_.give_up();
        history_.has_caustics = history_.has_caustic_image = false;
        irradiance_ = with_caustics_ = specular_ = nullptr;
        return;
    }
    follow_photons(inputs);
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "movers");
        movers_.follow(inputs.scene, maps_.extent(inputs.scene));
    }
    follow_rays(inputs);
    trace_caustics(inputs);
    if (plan_.on(EmcPass::lit_maps)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_maps");
        const SceneChanges& changes = inputs.scene.changes;
        const bool other_maps = std::exchange(lit_version_, maps_.version()) != maps_.version();
        std::vector<LitMaps::Returned> returned;
        for (const auto& [slot, rays] : maps_.take_returned()) {
            returned.push_back({slot, rays});
        }
        lit_maps_.update(
            inputs, maps_, movers_, gather_rays_, settings_, plan_.lit_bounces,
            {.forget = plan_.on(EmcPass::selection) || !history_.has_lit,
             .from_dark = history_.dark,
             .look = plan_.list_texels,
             .look_all = !history_.has_lit || other_maps || changes.assets || changes.pattern ||
                         !changes.painted.empty(),
             .verify = inputs.scene.changes.geometry || plan_.on(EmcPass::progressive_update) ||
                       plan_.on(EmcPass::reserved_map),
             .light = plan_.light_texels,
             .light_all = changes.lights || changes.emission || !changes.geometry || history_.dark,
             .compare = compare_rays_,
             .shoot = plan_.texel_rays,
             .photon_bounces = plan_.photon_bounces,
             .trace = plan_.on(EmcPass::lit_photons),
             .new_photons = !history_.has_lit_photons,
             .returned = std::move(returned)},
            photons_.bad_values());
        if (compare_rays_) {
            compare_rays_ = false;
            prefer_maps_ = gather_rays_ == nullptr || lit_maps_.times().prefer_maps();
            gather_rays_ = prefer_maps_ ? nullptr : gather_rays_;
        }
        const bool other_light = plan_.light_texels || (plan_.by_photons && plan_.light_frames == 0);
        history_.light_frames = other_light ? 1 : history_.light_frames + 1;
        if (!history_.has_lit) {
            points_.forget();
        }
        history_.has_lit = true;
        history_.has_lit_photons = plan_.by_photons;
        history_.texel_frames = lit_maps_.frames();
    }
}

// A map for what the picture's rays have met and no map shows. Where none is worth it the frame does less
// than was planned.
void EmcTechnique::reserve(const render::LightInputs& inputs) {
    if (!plan_.on(EmcPass::reserved_map)) {
        return;
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "reserved_map");
    history_.lacks_maps = false;
    if (!maps_.reserve(inputs.scene, inputs.gpu_scene, settings_, survey_)) {
        history_.survey_in = kSurveyRest;
        plan_ = make_emc_plan(inputs.scene, settings_, history_);
    }
}

// Photons and lit maps start from the light maps: where those are others though nothing in the scene has
// changed (render.shadow.resolution), the frame does more than was planned before they were drawn.
void EmcTechnique::follow_light_maps(const render::LightInputs& inputs) {
    const std::uint64_t before = std::exchange(light_maps_, inputs.light_maps.version());
    if (before != light_maps_ && !plan_.on(EmcPass::emission) && !plan_.light_texels) {
        history_.other_light_maps = true;
        plan_ = make_emc_plan(inputs.scene, settings_, history_);
        history_.other_light_maps = false;
    }
}

// The maps: chosen, drawn, looked at, exchanged.
void EmcTechnique::follow_geometry(const render::LightInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    area_outdated_ = area_outdated_ || scene.changes.geometry || total_area_ == 0;
    if (plan_.on(EmcPass::selection)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "selection");
        maps_.keep_rays([this](int slot) { return lit_maps_.kept_rays(slot); });
        maps_.select(scene, inputs.gpu_scene, settings_,
                     plan_.why(EmcPass::selection) == EmcReason::camera_is_elsewhere);
        history_.chosen_for = scene.bounds;
        area_outdated_ = true;
        history_.lacks_maps = false;
        gather_.unseen().forget();
        survey_ = {};
        history_.update.reset();
        plan_.faces += maps_.faces_drawn();
    } else if (plan_.on(EmcPass::environment_maps)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "environment_maps");
        maps_.redraw(scene, inputs.gpu_scene);
        plan_.faces += maps_.faces_drawn();
    }
    maps_.advance_fade(settings_);
    maps_.take_answers();
    bool exchanged = false;
    if (plan_.on(EmcPass::progressive_update)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "progressive_update");
        exchanged = maps_.exchange(scene, inputs.gpu_scene, settings_);
        if (exchanged) {
            plan_.faces += maps_.faces_drawn();
            plan_.set(EmcPass::environment_maps, true, EmcReason::map_exchanged);
        }
    }
    if (plan_.on(EmcPass::coverage) || plan_.update.ask) {
        const gpu::PassTimer::Scope scope(inputs.timer, "coverage");
        if (plan_.update.share >= 0) {
            maps_.look(scene, inputs.gpu_scene, settings_, plan_.update.share, plan_.update.shares);
        }
        if (plan_.update.ask) {
            maps_.ask();
        }
    }
    plan_.maps = maps_.count();
    if (!plan_.on(EmcPass::selection)) {
        history_.update.advance(scene.changes.geometry || history_.reach_changed, exchanged, plan_.update);
    }
}

// By the gather sensors alone count photons: those are traced when sensors are read.
void EmcTechnique::follow_photons(const render::LightInputs& inputs) {
    const bool gather = settings_.of<EmcSettings>().final_stage == EmcFinal::gather;
    if (plan_.on(EmcPass::emission)) {
        ++light_version_;
        sensors_lack_photons_ = gather;
        if (!gather) {
            trace_photons(inputs, plan_.pass);
        }
    }
    if (gather) {
        history_.has_photons = plan_.on(EmcPass::emission) || (history_.has_photons && !plan_.light_texels);
    }
}

void EmcTechnique::trace_photons(const render::LightInputs& inputs, int pass) {
    if (area_outdated_) {
        measure_area(inputs.scene);
        area_outdated_ = false;
    }
    photons_.trace(inputs, maps_, settings_, plan_.bounces, total_area_, pass);
}

render::IndirectLight EmcTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.bounces == 0) {
        return {};
    }
    if (gather_.unseen().found()) {  // in the frame before: the GPU is done with it
        survey_ = gather_.unseen().take();
        // Rays through the maps do not know what those do not see.
        history_.lacks_maps = gather_rays_ != nullptr && lacks_maps(survey_);
    }
    if (plan_.on(EmcPass::splats)) {
        splat(inputs);
    }
    if (plan_.on(EmcPass::gather)) {
        gather(inputs);
    } else if (plan_.on(EmcPass::accumulation) &&
               settings_.of<EmcSettings>().final_stage == EmcFinal::gather) {
        refine(inputs);
    }
    splat_caustics(inputs);
    mirror(inputs);
    history_.has_maps = true;
    history_.has_image = true;
    history_.fading = maps_.fading();
    history_.dark = false;
    return {shown(), specular_};
}

void EmcTechnique::splat(const render::FrameInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    const bool maps_changed = plan_.on(EmcPass::selection) || scene.changes.geometry ||
                              plan_.on(EmcPass::progressive_update) || maps_.fading() || history_.fading;
    // What settings alter of the march or of the bandwidth makes photons or image anew.
    const bool surroundings_changed = !history_.has_image || !history_.has_photons || scene.changes.camera ||
                                      scene.changes.relief || maps_changed;
    GiSettings splats = settings_;
    splats.edit<EmcSettings>().splat_base = plan_.base;
    irradiance_ = &splatting_.irradiance(inputs, maps_, photons_.arrived(), splats, surroundings_changed,
                                         photons_.bad_values());
    plan_.splat_kernel = splatting_.kernel();
    plan_.splat_binning = splatting_.binning();
    if (plan_.on(EmcPass::accumulation)) {
        irradiance_ = &accumulation_.add(*irradiance_, plan_.pass);
    }
    history_.passes = plan_.pass + 1;
    history_.has_photons = true;
}

void EmcTechnique::gather(const render::FrameInputs& inputs) {
    plan_.exact_rays = gather_rays_ != nullptr;
    irradiance_ = &gather_.irradiance(
        inputs, maps_, lit_maps_, movers_, gather_rays_, settings_,
        {.forget = plan_.on(EmcPass::selection) || points_.due(now_),
         .points = plan_.list_points,
         .verify = inputs.scene.changes.geometry || plan_.on(EmcPass::progressive_update) ||
                   plan_.on(EmcPass::reserved_map),
         .shoot = plan_.point_rays,
         .survey = plan_.survey});
    points_.made(now_);
    history_.point_frames = gather_.frames();
    history_.survey_in = plan_.survey       ? kSurveyInterval
                         : plan_.point_rays ? std::max(history_.survey_in - 1, 0)
                                            : history_.survey_in;
    history_.passes = 1;
}

// A still picture whose gather is done.
void EmcTechnique::refine(const render::FrameInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "accumulation");
    const RayScene rays{maps_,     lit_maps_.texels(), movers_,     gather_rays_,
                        settings_, inputs.scene,       inputs.timer};
    irradiance_ = &still_gather_.irradiance(inputs, rays, lit_maps_.radiosity(), gather_.picture(),
                                            plan_.pass, settings_.accumulate - 1);
    history_.passes = plan_.pass + 1;
}

render::TracedLobes EmcTechnique::traced_lobes() const {
    return {plan_.has_specular() ? settings_.specular_roughness : 0};
}

// What mirrors and glass show. With splats what they show has direct light alone: there are no lit maps.
void EmcTechnique::mirror(const render::FrameInputs& inputs) {
    if (plan_.on(EmcPass::specular)) {
        const bool lit = settings_.of<EmcSettings>().final_stage == EmcFinal::gather;
        specular_ = &specular_view_.radiance(
            inputs, maps_, lit ? &lit_maps_ : nullptr, shown(), plan_.caustics ? &caustics_ : nullptr,
            through_maps() ? nullptr : exact_.get(), settings_, plan_.specular_rays, photons_.bad_values());
        history_.has_specular = true;
    } else if (!plan_.has_specular()) {
        specular_ = nullptr;
        history_.has_specular = false;
    }
}

bool EmcTechnique::through_maps() const {
    return settings_.of<EmcSettings>().rays == EmcRays::maps ||
           (settings_.of<EmcSettings>().rays == EmcRays::fastest && prefer_maps_);
}

// Exact rays are kept where somebody needs them.
void EmcTechnique::follow_rays(const render::LightInputs& inputs) {
    const bool gather = settings_.of<EmcSettings>().final_stage == EmcFinal::gather && !through_maps();
    if (!gather && (through_maps() || !plan_.has_specular()) && !plan_.caustics) {
        exact_.reset();
    } else if (!exact_) {
        exact_ = make_exact_rays();
    }
    if (exact_) {
        const gpu::PassTimer::Scope scope(inputs.timer, "follow_rays");
        // What is mirrored, or bends light, is looked at closely.
        const bool coarser = inputs.gpu_scene.uses_levels() && !plan_.has_specular() && !plan_.caustics;
        exact_->follow(inputs.scene, coarser ? RayDetail::coarser : RayDetail::full);
    }
    ExactRays* const before = std::exchange(gather_rays_, gather ? exact_.get() : nullptr);
    compare_rays_ =
        gather_rays_ != nullptr && before == nullptr && settings_.of<EmcSettings>().rays == EmcRays::fastest;
}

void EmcTechnique::trace_caustics(const render::LightInputs& inputs) {
    if (!plan_.caustics) {
        history_.has_caustics = false;
    } else if (plan_.on(EmcPass::caustic_photons)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "caustic_photons");
        caustics_.trace(inputs, *exact_, settings_, plan_.keep_caustics);
        history_.has_caustics = true;
    }
    const std::uint64_t now = plan_.caustics ? caustics_.version() : 0;
    light_version_ += std::exchange(caustic_version_, now) != now ? 1 : 0;
}

void EmcTechnique::splat_caustics(const render::FrameInputs& inputs) {
    if (!plan_.caustics) {
        with_caustics_ = nullptr;
    } else if (plan_.on(EmcPass::caustic_splats)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "caustic_splats");
        if (plan_.splat_caustics) {
            const bool surfaces = !history_.has_caustic_image || inputs.scene.changes.camera ||
                                  inputs.scene.changes.geometry || inputs.scene.changes.assets;
            caustic_splats_.splat(inputs, caustics_.hits(), surfaces, maps_.extent(inputs.scene),
                                  photons_.bad_values());
        }
        with_caustics_ = &caustic_splats_.with(irradiance_);
    }
    history_.has_caustic_image = plan_.caustics;
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
    // Photons are many or few by what lies about the camera.
    if (!maps_.surroundings().empty()) {
        total_area_ = std::min(total_area_, area_within(scene, maps_.surroundings()));
    }
}

// Sensors are read every few frames. Photons that they alone count are the same whichever frame that is:
// those of the first pass.
void EmcTechnique::add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) {
    if (plan_.bounces > 0 && maps_.count() > 0) {
        if (std::exchange(sensors_lack_photons_, false)) {
            trace_photons(inputs, 0);
        }
        sensor_photons_.add(photons_.arrived(), targets);
        if (plan_.caustics) {
            sensor_photons_.add(caustics_.hits(), targets);
        }
    }
}

gpu::Texture EmcTechnique::debug_view(std::string_view name, const render::FrameInputs& inputs) {
    if (plan_.bounces == 0 || maps_.count() == 0) {
        return {};
    }
    if (name == "maps" || name == "coverage") {
        return name == "maps" ? views_.maps(maps_, settings_, inputs)
                              : views_.coverage(maps_, settings_, inputs);
    }
    const bool gathers = settings_.of<EmcSettings>().final_stage == EmcFinal::gather;
    if (name == "photons") {
        std::vector<PhotonHit> photons;
        if (!gathers || plan_.by_photons) {
            photons = (gathers ? lit_maps_.photons().arrived() : photons_.arrived()).read();
        }
        if (plan_.caustics) {
            const std::vector<PhotonHit>& caustics = caustics_.hits();
            photons.insert(photons.end(), caustics.begin(), caustics.end());
        }
        return photons.empty() ? gpu::Texture() : draw_photons(photons, inputs);
    }
    if (!gathers || !history_.has_lit) {
        return {};
    }
    if (name == "lit-texels") {
        return draw_lit_texels(lit_maps_);
    }
    const bool hits = name == "hits";
    return draw_points(hits ? gather_.known() : gather_.unfiltered(lit_maps_), gather_.grid(),
                       gather_.stride(), inputs.gbuffer.size());
}

GiStatistics EmcTechnique::statistics(bool count_photons) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    const CausticStatistics caustics = plan_.caustics ? caustics_.statistics() : CausticStatistics();
    const LitPhotons& lit_photons = lit_maps_.photons();
    result.nan_count = photons_.bad_value_count() + lit_photons.bad_value_count() + caustics.bad_values;
    result.add(caustics);
    result.add(maps_.statistics());
    if (settings_.of<EmcSettings>().final_stage == EmcFinal::splat) {
        result.add(splatting_.statistics());
    }
    GatherStatistics gather;
    if (settings_.of<EmcSettings>().final_stage == EmcFinal::gather) {
        gather.rays = plan_.point_rays ? gather_.rays() : 0;
        gather.remembered = gather_.remembered();
        gather.points = survey_.points;
        gather.blind_points = survey_.blind;
        gather.unknown_share = survey_.rays > 0 ? survey_.unknown / survey_.rays : 0;
    }
    if (count_photons) {
        result.add(plan_.by_photons ? lit_photons.statistics() : photons_.statistics());
        gather.lit_texels = lit_maps_.lit_texels();
        gather.rays += plan_.texel_rays ? lit_maps_.rays() : 0;
    }
    result.add(gather);
    return result;
}

}  // namespace lanthorn::gi
