#include "gi_module/techniques/emc/emc_inputs.h"

namespace lanthorn::gi {

EmcStamps::Versions EmcInputs::follow(const FrameScene& scene, ivec2 size, const GiSettings& s) {
    const auto& e = s.of<EmcSettings>();
    const March march{e.search, e.steps, e.exhaustive, e.threshold};
    maps_.follow({e.count, e.reserved, e.candidates, e.resolution, s.seed});
    round_.follow(e.update_interval);
    photons_.follow({s.bounces, s.photons, s.seed, e.final_stage, e.splat_bandwidth, e.splat_c0, march});
    lit_.follow({s.bounces, s.seed, e.final_stage, e.rays, e.gather_texels, e.gather_source, e.gather_endless,
                 march});
    lit_photons_.follow(e.gather_photons);
    image_.follow({s.accumulate, e.final_stage, e.gather_grid, e.gather_points, e.gather_rays, e.gather_guide,
                   e.splat_base, e.splat_contrast});
    points_.follow({e.final_stage, e.gather_grid, e.gather_points, e.gather_rays, e.gather_guide});
    specular_.follow({s.specular_roughness, e.specular_grid});
    caustics_.follow({s.bounces, s.seed, e.caustic_photons, e.caustic_c0});
    size_.follow(size);
    origin_.follow(scene.origin);
    sky_rays_.follow(e.gather_source == GatherSource::photons && scene.sky.has_value());
    return {maps_.version(),        round_.version(), photons_.version(), lit_.version(),
            lit_photons_.version(), image_.version(), points_.version(),  specular_.version(),
            caustics_.version(),    size_.version(),  origin_.version(),  sky_rays_.version()};
}

}  // namespace lanthorn::gi
