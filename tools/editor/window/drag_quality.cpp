#include "tools/editor/window/drag_quality.h"

#include <algorithm>

#include "lanthorn/render/render_settings.h"

namespace lanthorn::edit_window {

namespace {

constexpr int kFewestTexels = 96;  // a side of a lamp's map
constexpr int kFewestPoints = 1000;
constexpr int kTimesLarger = 2;  // each way, than what is drawn

}  // namespace

Settings drag_settings(const Settings& chosen) {
    Settings coarse = chosen;
    const int texels = chosen.get<int>("render.shadow.resolution");
    coarse.set("render.shadow.resolution", std::min(texels, std::max(kFewestTexels, texels / 2)));
    if (chosen.schema().find("gi.gather.points") != nullptr) {
        const int points = chosen.get<int>("gi.gather.points");
        coarse.set("gi.gather.points", std::min(points, std::max(kFewestPoints, points / 2)));
    }
    if (chosen.get<render::Upscale>("render.upscale") == render::Upscale::temporal) {
        coarse.set("render.upscale", render::Upscale::spatial);
    }
    return coarse;
}

ivec2 drag_whole(ivec2 drawn, ivec2 whole) {
    return glm::min(whole, kTimesLarger * drawn);
}

}  // namespace lanthorn::edit_window
