#include "gi_module/techniques/splat/splat_views.h"

#include "gi_module/shared/debug/debug_picture.h"
#include "gi_module/techniques/splat/kernel_areas.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

gpu::Texture draw_photons(PhotonCollection& photons, std::span<const vec3> powers,
                          const render::FrameInputs& inputs) {
    const SeenPoints seen(inputs);
    DebugPicture picture(seen.size());
    const bool read = photons.store().each([&](const RecordRun& run) {
        for (const PhotonBlock& block : run.blocks) {
            for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
                const PhotonRecord& record = run.records[i];
                const vec3 copies(record.copies(0), record.copies(1), record.copies(2));
                seen.draw(picture, record.position, hue_of(copies * powers[block.group]), seen.point_side());
            }
        }
    });
    return read ? picture.texture() : gpu::Texture();
}

// Of the first round, before any adaptation: h = C sqrt(A / N) of the surface that each pixel shows.
gpu::Texture draw_bandwidths(const PhotonCollection& photons, const PictureSurfaces& surfaces_seen,
                             const SplatSurfaces& surfaces, const SplatSettings& settings) {
    const std::vector<float> h = bandwidths(surfaces, photons.photons(false), settings.bandwidth);
    DebugPicture picture(surfaces_seen.size());
    for (int y = 0; y < picture.size().y; ++y) {
        for (int x = 0; x < picture.size().x; ++x) {
            const auto i = static_cast<std::size_t>(y * picture.size().x + x);
            const SurfaceSide side = surfaces_seen.pixels()[i].side;
            picture.at({x, y}) = vec4(vec3(side < h.size() ? h[side] : 0.0f), 1);
        }
    }
    return picture.texture();
}

}  // namespace

std::vector<DebugView> splat_views() {
    return {
        {"photons", "the photons that the picture shows, in the colour of their light", "", Shown::colour},
        {"bandwidth", "the radius of the kernel at each pixel, before it is adapted", "m", Shown::amount}};
}

gpu::Texture draw_splat_view(std::string_view name, PhotonCollection& photons, std::span<const vec3> powers,
                             const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                             const SplatSettings& settings, const render::FrameInputs& inputs) {
    return name == "photons" ? draw_photons(photons, powers, inputs)
                             : draw_bandwidths(photons, picture, surfaces, settings);
}

}  // namespace lanthorn::gi
