#include "gi_module/techniques/emc/emc_views.h"

#include "gi_module/shared/debug/debug_picture.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

constexpr GLuint kPlanesUnit = 2, kAlbedoUnit = 3;  // beside the G-buffer's

}  // namespace

std::vector<DebugView> emc_views() {
    return {{"maps", "the environment maps, a row of six faces each, shaded by how they face their centre",
             "", Shown::colour},
            {"coverage", "how many maps see the surface of each pixel", "", Shown::amount},
            {"lit-texels",
             "what the lit texels reflect, a row of six faces for each map and one that fades (of gather)",
             "lux", Shown::light},
            {"photons", "where photons have arrived, in the colour of their light", "", Shown::colour},
            {"hits", "the rays behind each point of the gather's grid", "", Shown::amount},
            {"unfiltered", "what each point of the gather's grid gathers, before the filter", "lux",
             Shown::light}};
}

gpu::Texture EmcViews::maps(const EnvironmentMaps& maps, const GiSettings& settings,
                            const render::FrameInputs& inputs) {
    if (!atlas_) {
        atlas_ = gpu::Program({"gi_module/techniques/emc/maps/view_maps.comp"});
    }
    const CubeAtlas atlas{maps.statistics().resolution, maps.count()};
    gpu::Texture result = gpu::Texture::make_2d(GL_RGBA32F, atlas.size());
    inputs.gpu_scene.bind_materials();
    atlas_.use();
    maps.bind(atlas_, kPlanesUnit, kAlbedoUnit, settings, inputs.scene);
    atlas_.set("slots", maps.slots_in_use());
    atlas_.set("cubes", atlas.cubes);
    result.bind_image(0, GL_WRITE_ONLY);
    atlas_.dispatch(atlas.size(), ivec2(8));
    wait_for_shaders();
    return result;
}

gpu::Texture EmcViews::coverage(const EnvironmentMaps& maps, const GiSettings& settings,
                                const render::FrameInputs& inputs) {
    if (!coverage_) {
        coverage_ = gpu::Program({"gi_module/techniques/emc/maps/view_coverage.comp"});
    }
    gpu::Texture result = gpu::Texture::make_2d(GL_RGBA32F, inputs.gbuffer.size());
    inputs.gpu_scene.bind_materials();
    use_surfaces(coverage_, inputs);
    maps.bind(coverage_, kPlanesUnit, kAlbedoUnit, settings, inputs.scene);
    coverage_.set("slots", maps.slots_in_use());
    coverage_.set("slot_count", maps.count());
    result.bind_image(0, GL_WRITE_ONLY);
    coverage_.dispatch(inputs.gbuffer.size(), ivec2(8));
    wait_for_shaders();
    return result;
}

gpu::Texture draw_lit_texels(const LitMaps& lit) {
    const LitTexels& texels = lit.texels();
    const auto places = static_cast<std::size_t>(texels.places());
    const std::vector<vec4> radiosity = lit.radiosity().read<vec4>(places);
    const CubeAtlas atlas{texels.resolution(), texels.faces() / 6};
    DebugPicture picture(atlas.size());
    for (std::size_t i = 0; i < places; ++i) {
        const auto place = static_cast<int>(i);
        const ivec2 texel(place % atlas.resolution, place / atlas.resolution % atlas.resolution);
        const int face = place / (atlas.resolution * atlas.resolution);
        picture.at(atlas.at(face / 6, face % 6, texel)) =
            radiosity[i].a < 0 ? vec4(0, 0, 0, 1) : vec4(vec3(radiosity[i]), 1);
    }
    return picture.texture();
}

gpu::Texture draw_photons(const std::vector<PhotonHit>& photons, const render::FrameInputs& inputs) {
    const SeenPoints seen(inputs);
    DebugPicture picture(seen.size());
    for (const PhotonHit& photon : photons) {
        if (photon.radius > 0) {
            seen.draw(picture, photon.position, hue_of(photon.power), seen.point_side());
        }
    }
    return picture.texture();
}

gpu::Texture draw_points(const std::vector<vec4>& values, ivec2 grid, int stride, ivec2 size) {
    DebugPicture picture(size);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const ivec2 cell = glm::min(ivec2(x, y) / stride, grid - 1);
            const vec4& value = values[static_cast<std::size_t>(cell.y * grid.x + cell.x)];
            picture.at({x, y}) = vec4(glm::max(vec3(value), vec3(0)), 1);
        }
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
