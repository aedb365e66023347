#include "gi_module/techniques/drm/drm_views.h"

#include <algorithm>
#include <span>

#include "gi_module/shared/debug/debug_picture.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

constexpr int kCell = 16;  // pixels a side of a sample in the map's picture
constexpr int kGap = 4;    // between two lights' pictures

// Each light's picture is a square of its samples, side by side.
template <class Colour>
gpu::Texture draw_map(std::span<const RadianceSample> samples, int pictures, int side, const Colour& colour) {
    const int across = side * kCell + kGap;
    DebugPicture picture({pictures * across - kGap, side * kCell});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int number = static_cast<int>(i);
        const ivec2 place(number % side, number / side % side);
        const ivec2 lower = ivec2(number / (side * side) * across, 0) + place * kCell;
        picture.fill(lower + kCell / 2, kCell, colour(samples[i]));
    }
    return picture.texture();
}

// What the solid angle has made of the radiance, undone.
float radiance_of_sent(SolidAngle kind, const RadianceSample& s) {
    switch (kind) {
        case SolidAngle::eq_11:
            return 1;
        case SolidAngle::eq_15:
            return 1 / std::max(s.across, 1e-30f);
        case SolidAngle::eq_13:
        case SolidAngle::eq_14:
        case SolidAngle::disc:
            break;
    }
    return 1 / std::max(s.area, 1e-30f);
}

}  // namespace

std::vector<DebugView> drm_views() {
    return {{"radiance-map",
             "what the samples of each light's picture send on, a square a light: reflected lumen over pi, "
             "or nits times steradians (gi.drm.solid_angle)",
             "", Shown::light},
            {"samples", "where the samples lie that the picture shows, in the colour of what they send on",
             "", Shown::colour},
            {"map-positions",
             "where the samples of each light's picture lie, a square a light: shares of the scene's box "
             "(Frisvad et al. 2005, Fig. 6 a)",
             "", Shown::colour},
            {"map-radiance", "the radiance that they send on, but for a factor (Fig. 6 b)", "", Shown::light},
            {"map-normals", "their normals, from -1..1 to 0..1 (Fig. 6 c)", "", Shown::colour}};
}

gpu::Texture draw_drm_view(std::string_view name, const RadianceMap& map, const DrmSettings& settings,
                           const render::FrameInputs& inputs) {
    const std::vector<RadianceSample> samples = map.read();
    const auto draw = [&](const auto& colour) {
        const std::span direct = std::span(samples).first(static_cast<std::size_t>(map.direct_samples()));
        return draw_map(direct, map.pictures().count(), settings.samples, colour);
    };
    const auto lit = [](const RadianceSample& s, const vec3& colour) {
        return s.normal != vec3(0) ? colour : vec3(0);
    };
    if (name == "radiance-map") {
        return draw([](const RadianceSample& s) { return s.sent; });
    }
    if (name == "map-positions") {
        const Aabb& box = inputs.scene.bounds;
        const vec3 size = glm::max(box.size(), vec3(1e-30f));
        return draw([&](const RadianceSample& s) { return lit(s, (s.position - box.lower) / size); });
    }
    if (name == "map-radiance") {
        return draw([&](const RadianceSample& s) {
            return lit(s, s.sent * radiance_of_sent(settings.solid_angle, s));
        });
    }
    if (name == "map-normals") {
        return draw([&](const RadianceSample& s) { return lit(s, 0.5f * s.normal + 0.5f); });
    }
    const SeenPoints seen(inputs);
    DebugPicture picture(seen.size());
    for (const RadianceSample& sample : samples) {
        seen.draw(picture, sample.position, hue_of(sample.sent), 5 * seen.point_side());
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
