#include "gi_module/techniques/path/path_views.h"

#include "gi_module/reference/sampling.h"
#include "gi_module/shared/debug/debug_picture.h"

namespace lanthorn::gi {

namespace {

using reference::Film;
using Shown = DebugView::Shown;

// Of the mean's luminance, as the two halves of its samples tell (reference/film.h).
float variance_of(const Film::Pixel& pixel) {
    const auto& [even, odd] = pixel;
    const double a = even.count, b = odd.count;
    if (a == 0 || b == 0) {
        return 0;
    }
    const vec3 off(even.sum() / a - odd.sum() / b);
    const float difference = luminance(off);
    return difference * difference * static_cast<float>(a * b / ((a + b) * (a + b)));
}

}  // namespace

std::vector<DebugView> path_views() {
    return {{"samples", "the samples behind each pixel that shows a surface", "", Shown::amount},
            {"variance", "the variance of each pixel's luminance, as two halves of its samples tell", "lux^2",
             Shown::amount},
            {"triangles", "which triangle the paths of each pixel start from", "", Shown::colour}};
}

gpu::Texture draw_path_view(std::string_view name, const reference::PixelSamples& samples) {
    DebugPicture picture(samples.size());
    const Film& film = samples.films()[0];
    for (int y = 0; y < picture.size().y; ++y) {
        for (int x = 0; x < picture.size().x; ++x) {
            const auto i = static_cast<std::size_t>((picture.size().y - 1 - y) * picture.size().x + x);
            const Film::Pixel& pixel = film.pixels()[i];
            const auto& seen = samples.first()[i];
            vec3 value(0);
            if (seen && name == "samples") {
                value = vec3(static_cast<float>(pixel[0].count + pixel[1].count));
            } else if (seen && name == "variance") {
                value = vec3(variance_of(pixel));
            } else if (seen && name == "triangles") {
                value = colour_of(seen->hit.triangle);
            }
            picture.at({x, y}) = vec4(value, 1);
        }
    }
    return picture.texture();
}

}  // namespace lanthorn::gi
