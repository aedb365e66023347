// Where the picture's indirect light is wrong, as a tint over it.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

namespace {

constexpr float kMostTint = 0.85f;  // opacity of an error of 100 %

}  // namespace

// "8 % +- 2"; "under 4 %" where it lies within the reference's noise.
std::string error_words(const editor::ErrorMap& map) {
    if (map.within_noise) {
        return fmt::format("under {:.0f} %", 100 * (map.local + 2 * map.uncertainty));
    }
    const int digits = map.uncertainty < 0.005 ? 1 : 0;
    return fmt::format("{:.{}f} % +- {:.{}f}", 100 * map.local, digits, 100 * map.uncertainty, digits);
}

// Too bright is red and plain, too dark is blue and chequered: colours are never alone.
void Viewport::show_error(const editor::ErrorMap& map) {
    ++state_.other_pictures;
    std::vector<std::uint8_t> texels;
    texels.reserve(4 * map.error.size());
    for (int y = 0; y < map.cells.y; ++y) {
        for (int x = 0; x < map.cells.x; ++x) {
            const float error =
                map.error[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.cells.x) +
                          static_cast<std::size_t>(x)];
            const float amount = std::isfinite(error) ? std::min(std::abs(error), 1.0f) : 0.0f;
            const bool faint = error < 0 && (x + y) % 2 == 0;
            const auto alpha =
                static_cast<std::uint8_t>(std::lround(255 * kMostTint * amount * (faint ? 0.4f : 1.0f)));
            if (error > 0) {
                texels.insert(texels.end(), {0xff, 0x38, 0x28, alpha});
            } else {
                texels.insert(texels.end(), {0x30, 0x7c, 0xff, alpha});
            }
        }
    }
    if (!error_tint_ || ivec2(error_tint_.size()) != map.cells) {
        error_tint_ = gpu::Texture::make_2d(GL_RGBA8, map.cells);
        error_tint_.set_filter(GL_NEAREST, GL_NEAREST);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(error_tint_.id(), 0, 0, 0, map.cells.x, map.cells.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
}

void Viewport::draw_error() {
    if (!state_.error_shown) {
        return;
    }
    const Box& box = state_.layout.picture;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float u = state_.unit;
    const bool known = state_.error && state_.error_of_frame == state_.picture.frames();
    if (known && error_tint_) {
        const vec2 covered = vec2(state_.error->cells * state_.error->stride) / vec2(state_.error->size);
        const auto id = image_of(error_tint_.id());
        // It is B's.
        const float left = state_.other_side ? box.x + state_.divider * box.width : box.x;
        list.PushClipRect({left, box.y}, {box.x + box.width, box.y + box.height}, true);
        list.AddImage(id, {box.x, box.y}, {box.x + covered.x * box.width, box.y + covered.y * box.height});
        list.PopClipRect();
    }
    const vec2 at(box.x + box.width - 176 * u, box.y + 28 * u);
    list.AddRectFilled({at.x, at.y}, {at.x + 170 * u, at.y + 38 * u}, IM_COL32(0, 0, 0, 190));
    constexpr int kSteps = 34;
    for (int i = 0; i < kSteps; ++i) {
        const float error = 2 * (static_cast<float>(i) + 0.5f) / kSteps - 1;
        const float x = at.x + 4 * u + 162 * u * static_cast<float>(i) / kSteps, width = 162 * u / kSteps;
        const auto alpha = static_cast<int>(255 * kMostTint * std::abs(error));
        const ImU32 shade = error > 0 ? IM_COL32(0xff, 0x38, 0x28, alpha) : IM_COL32(0x30, 0x7c, 0xff, alpha);
        const float top = error < 0 && i % 2 == 0 ? 4 * u : 0;
        list.AddRectFilled({x, at.y + 4 * u + top}, {x + width, at.y + 16 * u}, shade);
    }
    const std::string words = known                       ? "too dark to 100 % | too bright"
                              : state_.rest_watch->busy() ? "measuring ..."
                                                          : "measured when the picture rests";
    list.AddText(nullptr, 0.8f * ImGui::GetFontSize(), {at.x + 4 * u, at.y + 20 * u}, colour::words,
                 words.c_str());
}

}  // namespace lanthorn::edit_window
