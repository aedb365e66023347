#include "engine/render/scene_renderer.h"

#include <algorithm>

namespace lanthorn::render {

namespace {

// Versions of a set: so many that no two sets of a run have one in common.
constexpr std::uint64_t kVersionsOfASet = std::uint64_t{1} << 40;

RenderSettings of_light_maps(const RenderSettings& settings) {
    RenderSettings result;
    result.shadow_resolution = settings.shadow_resolution;
    result.area_lights_max = settings.area_lights_max;
    result.area_lights_samples = settings.area_lights_samples;
    result.area_lights_resolution = settings.area_lights_resolution;
    result.lamps_error = settings.lamps_error;
    result.adaptive_detail = settings.adaptive_detail;
    return result;
}

}  // namespace

void SceneRenderer::update(const FrameScene& scene, gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "upload");
    gpu_scene_.update(scene);
    emissive_.update(scene);
    sky_.follow(scene);
}

// The set that has these settings; else the view's own of the frame before, unless another uses that; else a
// new one.
SceneRenderer::Set& SceneRenderer::set_for(const FrameRenderer& view) {
    const RenderSettings wanted = of_light_maps(view.settings);
    auto found = std::ranges::find(sets_, wanted, &Set::settings);
    if (found == sets_.end()) {
        found = std::ranges::find_if(
            sets_, [&](const Set& set) { return set.maps == view.light_maps_ && !set.drawn; });
    }
    if (found == sets_.end()) {
        sets_.push_back({wanted, std::make_shared<LightMaps>(sets_made_++ * kVersionsOfASet)});
        found = sets_.end() - 1;
    }
    found->settings = wanted;
    return *found;
}

void SceneRenderer::draw_light_maps(const FrameScene& scene, std::span<FrameRenderer* const> views,
                                    gpu::PassTimer& timer) {
    const gpu::PassTimer::Scope pass(timer, "light_maps");
    for (Set& set : sets_) {
        set.drawn = false;
    }
    for (FrameRenderer* view : views) {
        Set& set = set_for(*view);
        view->light_maps_ = set.maps;
        if (!set.drawn) {
            set.drawn = true;
            draw_for(set.settings);
            set.maps->update(scene, gpu_scene_, emissive_, set.settings);
        }
    }
    std::erase_if(sets_, [](const Set& set) { return !set.drawn; });
}

}  // namespace lanthorn::render
