#include "gi_module/techniques/coarse-path/coarse_views.h"

#include "gi_module/shared/debug/debug_picture.h"

namespace lanthorn::gi {

namespace {

using Shown = DebugView::Shown;

constexpr vec3 kLatticeColour(0.25f, 0.5f, 1.0f);
constexpr vec3 kExtraColour(1.0f, 0.5f, 0.1f);

void draw_points(DebugPicture& picture, const GridPoints& points) {
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const SurfacePoint& point = points.points[i];
        if (point.distance > 0) {
            picture.fill(point.xy(), 1, i < points.lattice() ? kLatticeColour : kExtraColour);
        }
    }
}

}  // namespace

std::vector<DebugView> coarse_views() {
    return {
        {"points", "the points that light is computed at: blue those of the lattice, orange extra ones", "",
         Shown::colour},
        {"variance", "the variance of each point's luminance, as its samples tell", "lux^2", Shown::amount},
        {"history", "the samples of this frame and those before that count at each point", "",
         Shown::amount}};
}

gpu::Texture draw_coarse_view(std::string_view name, const GridPoints& points,
                              std::span<const PointEstimate> estimates) {
    DebugPicture picture(points.size);
    if (name == "points") {
        draw_points(picture, points);
        return picture.texture();
    }
    const auto value = [&](std::size_t i) {
        const PointEstimate& known = estimates[i];
        return vec3(!(points.points[i].distance > 0) ? 0.0f
                    : name == "variance"             ? known.variance()
                                                     : known.samples);
    };
    for (int y = 0; y < points.size.y; ++y) {
        for (int x = 0; x < points.size.x; ++x) {
            const ivec2 cell = glm::min(ivec2(x, y) / points.spacing, points.cells - 1);
            picture.at({x, y}) = vec4(value(points.cell_index(cell)), 1);
        }
    }
    for (std::size_t i = points.lattice(); i < points.points.size(); ++i) {
        picture.fill(points.points[i].xy(), 1, value(i));
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
