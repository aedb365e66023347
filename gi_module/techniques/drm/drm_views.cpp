#include "gi_module/techniques/drm/drm_views.h"

#include "gi_module/shared/debug/debug_picture.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

constexpr int kCell = 16;  // pixels a side of a sample in the map's picture
constexpr int kGap = 4;    // between two lights' pictures

// Each light's picture is a square of its samples, side by side.
gpu::Texture draw_map(const std::vector<RadianceSample>& samples, int pictures, int side) {
    const int across = side * kCell + kGap;
    DebugPicture picture({pictures * across - kGap, side * kCell});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int number = static_cast<int>(i);
        const ivec2 place(number % side, number / side % side);
        const ivec2 lower = ivec2(number / (side * side) * across, 0) + place * kCell;
        picture.fill(lower + kCell / 2, kCell, samples[i].sent);
    }
    return picture.texture();
}

}  // namespace

std::vector<DebugView> drm_views() {
    return {{"radiance-map",
             "what the samples of each light's picture send on, a square a light: reflected lumen over pi, "
             "or nits times steradians (gi.drm.solid_angle)",
             "", Shown::light},
            {"samples", "where the samples lie that the picture shows, in the colour of what they send on",
             "", Shown::colour}};
}

gpu::Texture draw_drm_view(std::string_view name, const RadianceMap& map, int side,
                           const render::FrameInputs& inputs) {
    const std::vector<RadianceSample> samples = map.read();
    if (name == "radiance-map") {
        return draw_map(samples, map.pictures().count(), side);
    }
    const SeenPoints seen(inputs);
    DebugPicture picture(seen.size());
    for (const RadianceSample& sample : samples) {
        seen.draw(picture, sample.position, hue_of(sample.sent), 5 * seen.point_side());
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
