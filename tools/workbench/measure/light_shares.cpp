#include "tools/workbench/measure/light_shares.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace lanthorn::workbench {

std::vector<LightShare> light_shares(const reference::LightSplitter& light, const CameraView& camera,
                                     ivec2 size, int places, int paths) {
    // A grid of about so many places of the picture's shape.
    const double side = std::sqrt(static_cast<double>(size.x) * size.y / std::max(1, places));
    const ivec2 cells = glm::max(ivec2(glm::dvec2(size) / std::max(1.0, side)), 1);
    std::map<reference::LightSource, LightShare> by_lamp;
    double whole = 0;
    int seen = 0;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            const ivec2 pixel((2 * ivec2(x, y) + 1) * size / (2 * cells));
            const auto point = light.seen(camera, size, pixel);
            if (!point) {
                continue;
            }
            ++seen;
            for (const reference::LampPart& lamp : light.lamps(*point, paths)) {
                LightShare& share = by_lamp[lamp.source];
                share.source = lamp.source;
                share.entity = lamp.entity;
                share.lux += lamp.sum.value();
                whole += lamp.sum.value();
            }
        }
    }
    std::vector<LightShare> result;
    for (auto& [source, share] : by_lamp) {
        share.share = whole > 0 ? share.lux / whole : 0;
        share.lux /= std::max(1, seen);
        result.push_back(share);
    }
    std::ranges::stable_sort(result, std::greater(), &LightShare::share);
    return result;
}

}  // namespace lanthorn::workbench
