#include "tools/editor/window/layout.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::edit_window {

Layout lay_out(ivec2 window, float unit, const Splits& splits) {
    const auto px = [unit](float units) { return std::round(units * unit); };
    const float w = static_cast<float>(window.x), h = static_cast<float>(window.y);
    Layout at;
    at.narrow = w < px(kNarrowBelow);
    at.low = h < px(kLowBelow);
    at.status = {0, h - px(kStatus), w, px(kStatus)};
    if (splits.only_picture) {
        at.picture = {0, 0, w, at.status.y};
        return at;
    }
    at.toolbar = {0, 0, w, px(kToolbar)};
    const float top = at.toolbar.height, bottom = at.status.y;
    const float splitter = px(kSplitter), least_width = px(160), least_height = px(90);
    // The inspector first: it is the last that a small window gives up.
    const float right = std::clamp(px(at.narrow ? std::min(splits.right, kNarrowPanel) : splits.right),
                                   px(120), std::max(px(120), w - least_width - splitter));
    at.right = {w - right, top, right, bottom - top};
    at.right_splitter = {at.right.x - splitter, top, splitter, bottom - top};
    float x = 0;
    if (!at.narrow) {
        const float left = std::clamp(px(splits.left), px(120),
                                      std::max(px(120), at.right_splitter.x - least_width - splitter));
        const float history = std::clamp(px(splits.history), px(kTabs), (bottom - top) * 0.6f);
        at.history = {0, bottom - history, left, history};
        at.history_splitter = {0, at.history.y - splitter, left, splitter};
        at.left = {0, top, left, at.history_splitter.y - top};
        at.left_splitter = {left, top, splitter, bottom - top};
        x = left + splitter;
    }
    const float width = at.right_splitter.x - x;
    const float drawer = splits.drawer_open
                             ? std::clamp(px(splits.drawer), px(kTabs) + px(60),
                                          std::max(px(kTabs) + px(60), bottom - top - least_height))
                             : px(kTabs);
    at.drawer = {x, bottom - drawer, width, drawer};
    const float gap = splits.drawer_open ? splitter : 0;
    if (splits.drawer_open) {
        at.drawer_splitter = {x, at.drawer.y - gap, width, gap};
    }
    at.picture = {x, top, width, at.drawer.y - gap - top};
    return at;
}

}  // namespace lanthorn::edit_window
