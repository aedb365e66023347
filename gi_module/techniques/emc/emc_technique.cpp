#include "gi_module/techniques/emc/emc_technique.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "gi_module/techniques/emc/gather/error_model.h"
#include "gi_module/techniques/emc/maps/surroundings.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

// Frames with rays until the next survey, after one in vain.
constexpr int kSurveyRest = 32;
constexpr int kWidestGrid = 64;  // as gi.gather.grid has it

// Whether maps are drawn of what rays have seen. A few texels in ten thousand are others then, slivers on
// outlines: maps of smaller scenes are drawn of all triangles, as their figures were measured.
bool has_many_triangles(const render::LightInputs& inputs) {
    constexpr std::uint64_t kMany = 90'000;
    return inputs.gpu_scene.triangle_count() > kMany;
}

}  // namespace

// The frame, in the paper's order: what it is made from is followed, and it is planned once the light maps
// are drawn; then update, indirect. Whether each step runs is the plan's decision alone.
void EmcTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& wanted) {
    settings_ = wanted;
    settings_.edit<EmcSettings>().gather_grid = gather_stride(wanted, size);
    frame_.glossy = shows_glossy(scene, wanted);
    if (frame_.glossy) {
        settings_.specular_roughness = std::min(wanted.specular_roughness, kGlossyFromRays);
    }
    frame_.light = light_bounds(scene);
    const bool dark = frame_.light.unlit != Unlit::no;
    frame_.specular = !dark && shows_specular(scene, settings_);
    frame_.exact_rays = has_exact_rays();
    frame_.reserved = false;
    inputs_.follow(scene, size, settings_, frame_.light.unlit, frame_.inputs);
    if (dark) {
        show_nothing();
    }
    const bool maps_hold = !kept_.centres.empty() &&
                           !kept_.centres.differs(EmcInput::map_settings, frame_.inputs) &&
                           !kept_.centres.differs(EmcInput::dark_surfaces, frame_.inputs);
    if (maps_hold) {
        const EnvironmentMaps::Reach reach = maps_.follow(scene, settings_);
        version_of(frame_.inputs, EmcInput::reach) += reach.changed ? 1 : 0;
        version_of(frame_.inputs, EmcInput::bulk) += reach.apart ? 1 : 0;
        version_of(frame_.inputs, EmcInput::sight) += reach.lost ? 1 : 0;
    } else if (dark) {
        // What follows the scene from change to change has nothing to go by once it has missed one.
        exact_.reset();
        gather_rays_ = nullptr;
        total_area_ = 0;
    }
}

void EmcTechnique::update(const render::LightInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    results_ = {};
    version_of(frame_.inputs, EmcInput::light_maps) = inputs.light_maps.version();
    if (frame_.light.unlit == Unlit::no && wants_reserved_map(scene, settings_, frame_, kept_)) {
        reserve(inputs);
    }
    plan_ = make_emc_plan(scene, settings_, frame_, kept_);
    frame_.inputs = plan_.now;
    if (idle()) {
        return;
    }
    follow_rays(inputs);
    // A GPU draws all triangles faster than rays find those that are seen.
    maps_.see_by(gpu::draws_in_software() && has_many_triangles(inputs) ? exact_.get() : nullptr);
    update_maps(inputs);
    if (maps_.count() == 0) {
        results_.no_map = true;
        kept_.no_map();
        show_nothing();
        return;
    }
    emit(inputs);
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "movers");
        movers_.follow(scene, maps_.extent(scene));
    }
    trace_caustics(inputs);
    if (plan_.on(EmcPass::lit_maps)) {
        update_lit_maps(inputs);
    }
}

void EmcTechnique::update_lit_maps(const render::LightInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "lit_maps");
    const std::uint64_t before = std::exchange(lit_version_, maps_.version());
    LitMaps::Found found{
        .other_maps = before != maps_.version(),
        .exchanged = maps_.exchanged_since(before).value_or(ivec2(-1)),
        .compare = compare_rays_,
        .returned = {},
    };
    for (const auto& [slot, rays] : maps_.take_returned()) {
        found.returned.push_back({slot, rays});
    }
    lit_maps_.update(inputs, maps_, movers_, gather_rays_, settings_, plan_.lit_bounces, plan_.lit, found,
                     photons_.bad_values());
    if (compare_rays_) {
        compare_rays_ = false;
        prefer_maps_ = gather_rays_ == nullptr || lit_maps_.times().prefer_maps();
        gather_rays_ = prefer_maps_ ? nullptr : gather_rays_;
    }
}

// A map for what the picture's rays have met and no map shows, where one is worth it.
void EmcTechnique::reserve(const render::LightInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "reserved_map");
    kept_.lacks_maps = false;
    frame_.reserved = maps_.reserve(inputs.scene, inputs.gpu_scene, settings_, survey_);
    if (!frame_.reserved) {
        kept_.survey_in = kSurveyRest;
    }
}

// The maps: chosen, drawn, looked at, exchanged.
void EmcTechnique::update_maps(const render::LightInputs& inputs) {
    const FrameScene& scene = inputs.scene;
    area_outdated_ = area_outdated_ || scene.changes.geometry || total_area_ == 0;
    if (plan_.on(EmcPass::selection)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "selection");
        maps_.keep_rays([this](int slot) { return lit_maps_.kept_rays(slot); });
        maps_.select(scene, inputs.gpu_scene, settings_,
                     plan_.why(EmcPass::selection) == EmcReason::camera_is_elsewhere);
        area_outdated_ = true;
        gather_.unseen().forget();
        survey_ = {};
        results_.faces += maps_.faces_drawn();
    } else if (plan_.on(EmcPass::environment_maps)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "environment_maps");
        maps_.redraw(scene, inputs.gpu_scene, plan_.redraw_all);
        results_.faces += maps_.faces_drawn();
    }
    maps_.advance_fade(settings_);
    maps_.take_answers();
    if (plan_.on(EmcPass::progressive_update)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "progressive_update");
        if (maps_.exchange(scene, inputs.gpu_scene, settings_)) {
            results_.faces += maps_.faces_drawn();
            results_.exchanged = true;
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
    results_.maps = maps_.count();
    results_.fading = maps_.fading();
}

// By the gather sensors alone count photons: those are traced when sensors are read.
void EmcTechnique::emit(const render::LightInputs& inputs) {
    if (!plan_.on(EmcPass::emission)) {
        return;
    }
    ++light_version_;
    sensors_lack_photons_ = gathers();
    if (!gathers()) {
        trace_photons(inputs, plan_.pass);
    }
}

void EmcTechnique::trace_photons(const render::LightInputs& inputs, int pass) {
    if (area_outdated_) {
        measure_area(inputs.scene);
        area_outdated_ = false;
    }
    photons_.keep_directions(plan_.glossy);
    photons_.trace(inputs, maps_, settings_, plan_.bounces, total_area_, pass, {});
}

render::IndirectLight EmcTechnique::indirect(const render::FrameInputs& inputs) {
    if (idle()) {
        return {};
    }
    if (gather_.unseen().found()) {  // in the frame before: the GPU is done with it
        survey_ = gather_.unseen().take();
        // Rays through the maps do not know what those do not see.
        kept_.lacks_maps = gather_rays_ != nullptr && lacks_maps(survey_);
    }
    if (plan_.on(EmcPass::splats)) {
        splat(inputs);
    } else if (plan_.on(EmcPass::gather)) {
        gather(inputs);
    } else if (plan_.on(EmcPass::accumulation)) {
        refine(inputs);
    }
    splat_caustics(inputs);
    splat_glossy(inputs);
    mirror(inputs);
    kept_.done(plan_, results_, inputs.scene.bounds);
    return {.irradiance = shown(),
            .specular = specular_,
            .blended_irradiance = blended_gather_ ? &blended_gather_->picture() : nullptr};
}

void EmcTechnique::splat(const render::FrameInputs& inputs) {
    blended_gather_.reset();
    GiSettings splats = settings_;
    splats.edit<EmcSettings>().splat_base = plan_.base;
    irradiance_ = &splatting_.irradiance(inputs, maps_, photons_.arrived(), splats, plan_.splat_surroundings,
                                         photons_.bad_values());
    results_.splat_kernel = splatting_.kernel();
    results_.splat_binning = splatting_.binning();
    if (plan_.on(EmcPass::accumulation)) {
        irradiance_ = &accumulation_.add(*irradiance_, plan_.pass);
    }
}

void EmcTechnique::splat_glossy(const render::FrameInputs& inputs) {
    if (!plan_.glossy) {
        glossy_ = nullptr;
    } else if (plan_.on(EmcPass::glossy_splats)) {
        glossy_splats_.splat(inputs, maps_, photons_.arrived(), settings_, splatting_, photons_.bad_values());
        glossy_ = &glossy_splats_.picture();
        if (plan_.on(EmcPass::accumulation)) {
            glossy_ = &glossy_accumulation_.add(*glossy_, plan_.pass);
        }
    }
}

void EmcTechnique::gather(const render::FrameInputs& inputs) {
    results_.exact_rays = gather_rays_ != nullptr;
    irradiance_ = &gather_.irradiance(inputs, maps_, lit_maps_, movers_, gather_rays_, settings_,
                                      plan_.gather, photons_.bad_values());
    if (plan_.gather.points || plan_.gather.verify) {
        still_gather_.end_fade();
    }
    irradiance_ = &still_gather_.faded(gather_.picture());
    gather_blended(inputs);
}

// What falls on blended surfaces before the picture's: a gather of their own, coarser, as they are half
// clear.
void EmcTechnique::gather_blended(const render::FrameInputs& inputs) {
    if (inputs.blended == nullptr) {
        blended_gather_.reset();
        return;
    }
    GatherWork work = plan_.gather;
    work.survey = false;
    if (!blended_gather_) {
        blended_gather_ = std::make_unique<Gather>(false);
        work = {.forget = false, .points = true, .verify = false, .shoot = true};
    }
    GiSettings coarser = settings_;
    int& grid = coarser.edit<EmcSettings>().gather_grid;
    grid = std::min(2 * grid, kWidestGrid);
    const render::LightInputs& light = inputs;
    const render::FrameInputs before{light, *inputs.blended, inputs.camera};
    blended_gather_->irradiance(before, maps_, lit_maps_, movers_, gather_rays_, coarser, work,
                                photons_.bad_values());
}

// A still picture whose gather is done.
void EmcTechnique::refine(const render::FrameInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "accumulation");
    const RayScene rays{maps_,     lit_maps_.texels(), movers_,     gather_rays_,
                        settings_, inputs.scene,       inputs.timer};
    irradiance_ = &still_gather_.irradiance(inputs, rays, lit_maps_, gather_.picture(), plan_.pass,
                                            settings_.accumulate - 1, photons_.bad_values());
    if (settings_.target_error > 0 && StillGather::changes_picture(plan_.pass, settings_.accumulate - 1)) {
        const ErrorEstimate estimate = estimate_error();
        kept_.estimated_error = estimate.known ? std::optional(estimate.relrmse.value) : std::nullopt;
    }
}

render::TracedLobes EmcTechnique::traced_lobes() const {
    return {frame_.specular ? settings_.specular_roughness : 0};
}

// What mirrors and glass show. With splats what they show has direct light alone: there are no lit maps.
void EmcTechnique::mirror(const render::FrameInputs& inputs) {
    if (plan_.on(EmcPass::specular)) {
        traced_ = &specular_view_.radiance(
            inputs, maps_, gathers() ? &lit_maps_ : nullptr, shown(), plan_.caustics ? &caustics_ : nullptr,
            through_maps() ? nullptr : exact_.get(), settings_, plan_.specular_rays, photons_.bad_values());
    } else if (!plan_.has_specular()) {
        traced_ = nullptr;
    }
    specular_ = glossy_ == nullptr
                    ? traced_
                    : &glossy_splats_.with(inputs, traced_, *glossy_,
                                           with_caustics_ != nullptr ? &caustic_splats_.picture() : nullptr,
                                           settings_);
}

bool EmcTechnique::through_maps() const {
    return settings_.of<EmcSettings>().rays == EmcRays::maps ||
           (settings_.of<EmcSettings>().rays == EmcRays::fastest && prefer_maps_);
}

// Exact rays are kept where somebody needs them.
void EmcTechnique::follow_rays(const render::LightInputs& inputs) {
    const bool gather = gathers() && !through_maps();
    const bool exact_caustics = plan_.caustics && !plan_.caustics_by_maps;
    // A choice of maps draws a large scene some hundred times: for that alone rays are worth their structure.
    const bool draws = plan_.on(EmcPass::selection) && gpu::draws_in_software() && has_many_triangles(inputs);
    if (!gather && (through_maps() || !plan_.has_specular()) && !exact_caustics && !draws) {
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
    if (plan_.on(EmcPass::caustic_photons)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "caustic_photons");
        caustics_.trace(inputs, plan_.caustics_by_maps ? nullptr : exact_.get(), maps_, settings_,
                        plan_.keep_caustics);
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
            caustic_splats_.splat(inputs, caustics_.hits(), plan_.caustic_surfaces,
                                  maps_.extent(inputs.scene), photons_.bad_values());
        }
        with_caustics_ = &caustic_splats_.with(irradiance_);
    }
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
        const Material& material = scene.material(instance);
        const bool blended = material.alpha_mode == AlphaMode::blend;
        total_area_ += now.area * (blended ? static_cast<double>(material.base_colour.a) : 1.0);
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
    if (!idle()) {
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
    if (idle()) {
        return {};
    }
    if (name == "maps" || name == "coverage") {
        return name == "maps" ? views_.maps(maps_, settings_, inputs)
                              : views_.coverage(maps_, settings_, inputs);
    }
    if (name == "photons") {
        std::vector<PhotonHit> photons;
        if (!gathers() || plan_.by_photons()) {
            photons = (gathers() ? lit_maps_.photons().arrived() : photons_.arrived()).read();
        }
        if (plan_.caustics) {
            const std::vector<PhotonHit>& caustics = caustics_.hits();
            photons.insert(photons.end(), caustics.begin(), caustics.end());
        }
        return photons.empty() ? gpu::Texture() : draw_photons(photons, inputs);
    }
    if (!gathers()) {
        return {};
    }
    if (name == "lit-texels") {
        return draw_lit_texels(lit_maps_);
    }
    const bool hits = name == "hits";
    return draw_points(hits ? gather_.known() : gather_.unfiltered(lit_maps_), gather_.grid(),
                       gather_.stride(), inputs.gbuffer.size());
}

ErrorEstimate EmcTechnique::estimate_error() {
    ErrorEstimate estimate;
    if (idle() || !gathers() || irradiance_ == nullptr) {
        return estimate;
    }
    const auto& e = settings_.of<EmcSettings>();
    const GatherError::Parts& parts = gather_.error_parts(lit_maps_);
    estimate.known = parts.known;
    estimate.relrmse_parts = parts.relrmse;
    estimate.local_parts = parts.local;
    estimate.texels = std::min(e.gather_texels, e.resolution);
    estimate.photons = plan_.by_photons() ? lit_maps_.photons().mean_units() * e.gather_photons : 0;
    if (irradiance_ != &gather_.picture()) {
        still_gather_.refine(estimate.relrmse_parts);
        still_gather_.refine(estimate.local_parts);
    }
    apply_error_model(estimate);
    return estimate;
}

GiStatistics EmcTechnique::statistics(bool count_photons) {
    GiStatistics result;
    result.plan = in_words(plan_, results_, settings_);
    const EmcPlan nothing;
    const EmcPlan& done = idle() ? nothing : plan_;
    const CausticStatistics caustics = done.caustics ? caustics_.statistics() : CausticStatistics();
    const LitPhotons& lit_photons = lit_maps_.photons();
    result.nan_count = photons_.bad_value_count() + lit_photons.bad_value_count() + caustics.bad_values;
    result.add(caustics);
    result.add(maps_.statistics());
    if (!gathers()) {
        result.add(splatting_.statistics());
    }
    GatherStatistics gather;
    if (gathers()) {
        gather.rays = done.gather.shoot ? gather_.rays() : 0;
        gather.remembered = gather_.remembered();
        gather.points = survey_.points;
        gather.blind_points = survey_.blind;
        gather.unknown_share = survey_.rays > 0 ? survey_.unknown / survey_.rays : 0;
    }
    if (count_photons) {
        result.add(done.by_photons() ? lit_photons.statistics() : photons_.statistics());
        gather.lit_texels = lit_maps_.lit_texels();
        gather.rays += done.lit.shoot ? lit_maps_.rays() : 0;
    }
    result.add(gather);
    return result;
}

}  // namespace lanthorn::gi
