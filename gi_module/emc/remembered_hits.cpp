#include "lanthorn/gi/emc/remembered_hits.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void RememberedHits::shoot(const SurfacePoints& points, const LitTexels& texels, const EnvironmentMaps& maps,
                           const GiSettings& settings, const FrameScene& scene) {
    if (!one_map_ || settings.emc_search != search_) {
        search_ = settings.emc_search;
        const char* secant = search_ == Search::secant ? "SEARCH_SECANT 1" : "SEARCH_SECANT 0";
        one_map_ = gpu::Program({"gi_module/emc/gather_trace.comp"}, {"ONE_MAP 1"});
        every_map_ = gpu::Program({"gi_module/emc/gather_trace.comp"}, {"ONE_MAP 0", secant});
        shade_ = gpu::Program({"gi_module/emc/gather_shade.comp"});
    }
    if (points.capacity() != capacity_ || points.rays() != rays_) {
        capacity_ = points.capacity();
        rays_ = points.rays();
        frames_ = 0;
        const std::size_t rays = static_cast<std::size_t>(capacity_) * static_cast<std::size_t>(rays_);
        hits_ = gpu::Buffer(rays * kFrames * sizeof(std::uint32_t));
        irradiance_ = gpu::Buffer(static_cast<std::size_t>(capacity_) * sizeof(vec4));
        rounds_.resize(rays);
    }
    if (complete()) {
        return;
    }
    points.bind_storage();
    hits_.bind_storage(4);
    const auto prepare = [&](const gpu::Program& program) {
        program.use();
        maps.bind(program, 0, 1, settings, scene);
        index_view_.bind(2, texels.index(), GL_R32UI);
        points_view_.bind(3, texels.points().points(), GL_RGBA32F);
        program.set("lit_index", 2);
        program.set("lit_points", 3);
        program.set("lit_resolution", texels.resolution());
        program.set("rays", rays_);
        program.set("frame", frames_);
        program.set("capacity", capacity_);
        program.set("row", points.row());
        program.set("seed", settings.seed);
    };
    rounds_.run(one_map_, every_map_, settings, prepare,
                [&](const gpu::Program&) { points.dispatch_rays(); });
    ++frames_;
}

const gpu::Buffer& RememberedHits::shade(const SurfacePoints& points, const gpu::Buffer& radiosity) {
    shade_.use();
    hits_view_.bind(0, hits_, GL_R32UI);
    radiosity_view_.bind(1, radiosity, GL_RGBA32F);
    shade_.set("hits", 0);
    shade_.set("radiosity", 1);
    shade_.set("capacity", capacity_);
    shade_.set("taken", frames_ * rays_);
    points.bind_storage();
    irradiance_.bind_storage(1);
    points.dispatch();
    wait_for_shaders();
    return irradiance_;
}

}  // namespace lanthorn::gi
