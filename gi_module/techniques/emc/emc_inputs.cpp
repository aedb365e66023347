#include "gi_module/techniques/emc/emc_inputs.h"

#include "gi_module/shared/plan_rules.h"

namespace lanthorn::gi {

void EmcInputs::follow(const FrameScene& scene, ivec2 size, const GiSettings& s, Unlit unlit,
                       EmcStamps::Versions& versions) {
    const auto& e = s.of<EmcSettings>();
    const auto& rules = s.of<PlanRules>();
    const March march{e.search, e.steps, e.exhaustive, e.threshold};
    maps_.follow({e.count, e.reserved, e.candidates, e.resolution, s.seed, rules.count});
    round_.follow(e.update_interval);
    photons_.follow({s.bounces, rules.bounces, s.photons, s.seed, e.final_stage, e.splat_bandwidth,
                     e.splat_glossy, e.splat_c0, march});
    lit_.follow({s.bounces, rules.bounces, s.seed, e.final_stage, e.rays, e.gather_texels, e.gather_source,
                 e.gather_endless, march});
    lit_photons_.follow(e.gather_photons);
    // More passes go on with a picture that there is; of fewer it is made again, and splats of one pass are
    // wider than those of many.
    picture_ +=
        s.accumulate < passes_ || (e.final_stage == EmcFinal::splat && s.accumulate != passes_) ? 1 : 0;
    passes_ = s.accumulate;
    image_.follow({picture_, e.final_stage, e.gather_grid, e.gather_points, e.gather_rays, e.gather_guide,
                   e.splat_base, e.splat_contrast});
    points_.follow({e.final_stage, e.gather_grid, e.gather_points, e.gather_rays, e.gather_guide});
    specular_.follow({s.specular_roughness, e.specular_grid});
    caustics_.follow({s.bounces, s.seed, e.caustic_photons, e.caustic_c0, e.rays == EmcRays::maps});
    size_.follow(size);
    origin_.follow(scene.origin);
    sky_rays_.follow(e.gather_source == GatherSource::photons && scene.sky.has_value());
    const SceneChanges& changes = scene.changes;
    scene_.follow(changes);
    const bool dark = unlit != Unlit::no;
    darkness_ += dark ? 1 : 0;
    dark_surfaces_ += dark && (changes.geometry || changes.pattern || !changes.painted.empty()) ? 1 : 0;

    const auto is = [&](EmcInput input, std::uint64_t version) { version_of(versions, input) = version; };
    is(EmcInput::map_settings, maps_.version());
    is(EmcInput::round_settings, round_.version());
    is(EmcInput::photon_settings, photons_.version());
    is(EmcInput::lit_settings, lit_.version());
    is(EmcInput::lit_photon_settings, lit_photons_.version());
    is(EmcInput::image_settings, image_.version());
    is(EmcInput::point_settings, points_.version());
    is(EmcInput::specular_settings, specular_.version());
    is(EmcInput::caustic_settings, caustics_.version());
    is(EmcInput::size, size_.version());
    is(EmcInput::origin, origin_.version());
    is(EmcInput::sky_rays, sky_rays_.version());
    is(EmcInput::scene, scene_.whole);
    is(EmcInput::geometry, scene_.geometry);
    is(EmcInput::pattern, scene_.pattern);
    is(EmcInput::paint, scene_.paint);
    is(EmcInput::assets, scene_.assets);
    is(EmcInput::relief, scene_.relief);
    is(EmcInput::lights, scene_.lights);
    is(EmcInput::emission, scene_.emission);
    is(EmcInput::camera, scene_.camera);
    is(EmcInput::darkness, darkness_);
    is(EmcInput::dark_surfaces, dark_surfaces_);
}

}  // namespace lanthorn::gi
