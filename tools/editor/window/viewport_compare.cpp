// A|B: a picture that was kept beside the one of now, with a divider between them.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

namespace {

constexpr float kGrip = 6;  // units to either side of the divider that take hold of it

}  // namespace

void Viewport::compare(bool on) {
    if (!on || state_.picture.texture() == 0) {
        state_.kept_picture.reset();
        return;
    }
    const PictureFacts& facts = state_.picture.facts();
    KeptPicture kept;
    kept.texture = state_.picture.copy();
    kept.words = fmt::format("A: {} {} {} - {}x{} - {:.0f} ms", name_of(facts.quality), facts.technique,
                             facts.preset, facts.size.x, facts.size.y, facts.ms);
    if (facts.view != "final") {
        kept.words += " - " + facts.view;
    }
    kept.version = state_.session.version();
    kept.pose = state_.session.pose();
    state_.kept_picture = std::move(kept);
}

bool Viewport::over_divider(const vec2& pixel) const {
    const Box& box = state_.layout.picture;
    return state_.kept_picture && box.contains(pixel) &&
           std::abs(pixel.x - box.x - state_.divider * box.width) < kGrip * state_.unit;
}

void Viewport::move_divider(const vec2& pixel) {
    const Box& box = state_.layout.picture;
    state_.divider = std::clamp((pixel.x - box.x) / box.width, 0.02f, 0.98f);
}

void Viewport::draw_compared() {
    if (!state_.kept_picture) {
        return;
    }
    const KeptPicture& kept = *state_.kept_picture;
    const Box& box = state_.layout.picture;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float u = state_.unit, x = box.x + state_.divider * box.width;
    const auto id = reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(kept.texture.id()));
    list.AddImage(id, {box.x, box.y}, {x, box.y + box.height}, {0, 1}, {state_.divider, 0});
    list.AddRectFilled({x - 2 * u, box.y}, {x + 2 * u, box.y + box.height}, IM_COL32(0, 0, 0, 160));
    list.AddRectFilled({x - 0.5f * u, box.y}, {x + 0.5f * u, box.y + box.height}, colour::words);
    const vec2 middle(x, box.y + box.height / 2);
    list.AddCircleFilled(im(middle), 8 * u, IM_COL32(0, 0, 0, 200), 16);
    list.AddTriangleFilled(im(middle + vec2(-6 * u, 0)), im(middle + vec2(-2 * u, -4 * u)),
                           im(middle + vec2(-2 * u, 4 * u)), colour::words);
    list.AddTriangleFilled(im(middle + vec2(6 * u, 0)), im(middle + vec2(2 * u, -4 * u)),
                           im(middle + vec2(2 * u, 4 * u)), colour::words);
    std::string words = kept.words;
    if (!(kept.pose == state_.session.pose())) {
        words += " - from another place";
    } else if (kept.version != state_.session.version()) {
        words += " - before later edits";
    }
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float pad = 4 * u, top = box.y + size.y + pad + 4 * u;
    list.AddRectFilled({box.x, top}, {box.x + size.x + 2 * pad, top + size.y + pad}, IM_COL32(0, 0, 0, 190));
    list.AddText({box.x + pad, top + pad / 2}, colour::chosen, words.c_str());
}

}  // namespace lanthorn::edit_window
