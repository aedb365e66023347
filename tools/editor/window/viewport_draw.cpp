// What is drawn in the viewport: the picture, and over it badge, icons, handles and figures.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lanthorn/scene/components.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/window/quantity.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

namespace {

ImU32 part_colour(Part part) {
    switch (part) {
        case Part::x:
        case Part::yz:
            return colour::x_axis;
        case Part::y:
        case Part::zx:
            return colour::y_axis;
        case Part::z:
        case Part::xy:
            return colour::z_axis;
        default:
            return IM_COL32(0xf4, 0xf4, 0xf4, 255);
    }
}

ImU32 faded(ImU32 colour, float alpha) {
    ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
    c.w *= alpha;
    return ImGui::ColorConvertFloat4ToU32(c);
}

// Words that can be read over any picture.
void outlined(ImDrawList& list, const vec2& at, ImU32 colour, const std::string& words) {
    for (const vec2 shift : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)}) {
        list.AddText(im(at + shift), IM_COL32(0, 0, 0, 220), words.c_str());
    }
    list.AddText(im(at), colour, words.c_str());
}

void chip(ImDrawList& list, const vec2& at, float pad, ImU32 colour, const std::string& words) {
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    list.AddRectFilled(im(at), {at.x + size.x + 2 * pad, at.y + size.y + pad}, IM_COL32(0, 0, 0, 190));
    list.AddText({at.x + pad, at.y + pad / 2}, colour, words.c_str());
}

}  // namespace

void Viewport::draw(double now) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Box& box = state_.layout.picture;
    eye_ = Projector(look_, origin_, box);
    if (state_.picture.texture() != 0) {
        const auto id = image_of(state_.picture.texture());
        list.AddImage(id, {box.x, box.y}, {box.x + box.width, box.y + box.height}, {0, 1}, {1, 0});
    }
    list.PushClipRect({box.x, box.y}, {box.x + box.width, box.y + box.height}, true);
    float below = box.y + 48 * state_.unit;  // the badge's lines
    if (state_.session.is_open()) {
        draw_compared();
        draw_compare_popup();
        draw_error();
        draw_selection();
        if (state_.helpers) {
            draw_icons();
            place_handles();
            draw_handles();
        }
        draw_divider();  // its letters over what stands there
        draw_why_ways();
        draw_beside_ghosts();
        draw_wishes_places();
        draw_scale_bar();
        draw_lux();
        if (marquee_from_) {
            list.AddRectFilled(im(*marquee_from_), im(last_), IM_COL32(255, 176, 64, 30));
            list.AddRect(im(*marquee_from_), im(last_), colour::chosen);
        }
        below = std::max(below, draw_progress(draw_badge()) + 8 * state_.unit);
    }
    const float pad = 4 * state_.unit;
    const vec2 said(box.x + 8 * state_.unit, below);
    if (!state_.problem.empty()) {
        chip(list, said, pad, colour::bad, state_.problem);
    } else if (now < state_.toast_until) {
        chip(list, said, pad, colour::words, state_.toast);
    }
    list.PopClipRect();
}

float Viewport::draw_badge() {
    const PictureFacts& facts = state_.picture.facts();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Box& box = state_.layout.picture;
    const float pad = 4 * state_.unit;
    const float row = ImGui::GetFontSize() + pad;
    // While samples are added their bar says how many there are.
    const bool all_traced = state_.traced.grows() && !state_.traced.due();
    std::string words = picture_words(facts, all_traced ? state_.traced.words() : state_.refinement.words());
    if (state_.session.moment() > 0) {
        words += fmt::format(" - at {:.2f} s", state_.session.moment());
    }
    if (!state_.solo.empty()) {
        words += fmt::format(" - {} solo", state_.solo.size());
    } else if (!state_.muted.empty()) {
        words += fmt::format(" - {} muted", state_.muted.size());
    }
    const ImU32 shade = facts.quality == Quality::drag ? colour::warning : colour::words;
    vec2 corner(box.x, box.y);
    state_.compare_button = {};
    if (state_.other_side) {
        // A's above the left part; B's above the right one, or below A's where there is no room.
        words = "B  " + words;
        std::string left = other_words(true);
        if (ImGui::CalcTextSize(left.c_str()).x + 2 * pad > box.width) {
            left = other_words(false);
        }
        const float wide = ImGui::CalcTextSize(left.c_str()).x + 2 * pad;
        const float mine = ImGui::CalcTextSize(words.c_str()).x + 2 * pad;
        chip(list, corner, pad, colour::chosen, left);
        state_.compare_button = {corner.x, corner.y, wide, row};
        if (state_.compare_button.contains(last_) && !ImGui::IsPopupOpen("A|B")) {
            ImGui::SetTooltip("what stands left of the divider: click for another");
        }
        const bool beside = wide + mine + pad < box.width;
        corner = beside ? vec2(box.x + box.width - mine, box.y) : vec2(box.x, box.y + row);
    }
    float lowest = corner.y + row;
    chip(list, corner, pad, shade, words);
    const float at = corner.x + ImGui::CalcTextSize(words.c_str()).x + 3 * pad, top = corner.y;
    state_.game_button = {};
    // Of a picture that is the game's in all but proof.
    const bool comparable = !state_.exposure_locked && state_.muted.empty() && state_.solo.empty() &&
                            facts.view == "final" && facts.quality == Quality::still &&
                            state_.session.moment() == 0 && !state_.session.shown_clip();
    if (comparable) {
        const bool known = !state_.game_words.empty() && state_.game_version == state_.session.version() &&
                           state_.game_pose == state_.session.pose();
        const std::string says = known ? state_.game_words : "= game ?";
        const ImU32 colour_of = !known ? colour::faint : state_.game_same ? colour::good : colour::bad;
        const ImVec2 size = ImGui::CalcTextSize(says.c_str());
        // Beside the badge, or below it where there is no room.
        const bool fits = at + size.x + 2 * pad < box.x + box.width;
        const vec2 place(fits ? at : box.x, fits ? top : top + row);
        chip(list, place, pad, colour_of, says);
        lowest = std::max(lowest, place.y + row);
        state_.game_button = {place.x, place.y, size.x + 2 * pad, row};
        if (state_.game_button.contains(last_)) {
            ImGui::SetTooltip("draws the saved bytes by a fresh App, and compares bit for bit (G)");
        }
    }
    if (state_.exposure_locked) {
        const std::string says = fmt::format("EV {:.1f} held", state_.locked_ev);
        const bool fits = at + ImGui::CalcTextSize(says.c_str()).x + 2 * pad < box.x + box.width;
        chip(list, fits ? vec2(at, top) : vec2(box.x, top + row), pad, colour::warning, says);
        lowest = std::max(lowest, fits ? top + row : top + 2 * row);
    }
    return lowest;
}

// Below the badge, while samples are added: how many of how many, the time that is left, and a way out.
float Viewport::draw_progress(float top) {
    const editor::TracedSamples& traced = state_.traced;
    state_.cancel_button = {};
    if (!traced.due() || state_.picture.facts().quality == Quality::drag) {
        return top;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Box& box = state_.layout.picture;
    const float pad = 4 * state_.unit, row = ImGui::GetFontSize() + 2 * pad;
    const std::string left = traced.left_words(), leave = "Cancel (Esc)";
    std::string words = traced.words();
    words += left.empty() ? "" : " \u00b7 " + left;
    const float button = ImGui::CalcTextSize(leave.c_str()).x + 4 * pad;
    // One width while the numbers in it grow.
    const float wanted = std::max(17 * ImGui::GetFontSize(), ImGui::CalcTextSize(words.c_str()).x + 4 * pad);
    const float wide = std::min(wanted, std::max(0.0f, box.width - button - 3 * pad));
    const vec2 at(box.x + pad, top + pad), end = at + vec2(wide, row);
    list.AddRectFilled(im(at), im(end), IM_COL32(0, 0, 0, 210));
    list.AddRectFilled(im(at), {at.x + wide * static_cast<float>(traced.share()), end.y},
                       IM_COL32(0x2f, 0x6a, 0xa8, 255));
    list.AddRect(im(at), im(end), IM_COL32(0xa0, 0xa0, 0xa0, 255));
    list.PushClipRect(im(at), im(end), true);
    list.AddText({at.x + 2 * pad, at.y + pad}, colour::words, words.c_str());
    list.PopClipRect();
    const vec2 beside(end.x + pad, at.y);
    state_.cancel_button = {beside.x, beside.y, button, row};
    const bool over = state_.cancel_button.contains(last_);
    list.AddRectFilled(im(beside), im(beside + vec2(button, row)),
                       over ? IM_COL32(0x2f, 0x6a, 0xa8, 255) : IM_COL32(0x30, 0x30, 0x30, 255));
    list.AddRect(im(beside), im(beside + vec2(button, row)), IM_COL32(0xa0, 0xa0, 0xa0, 255));
    list.AddText({beside.x + 2 * pad, beside.y + pad}, colour::words, leave.c_str());
    if (over) {
        ImGui::SetTooltip("the picture is drawn by the technique before this one");
    }
    return end.y;
}

void Viewport::draw_icons() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float r = 6 * state_.unit;
    state_.light_places.clear();
    for (const editor::LightRow& light : state_.lights) {
        const auto at = eye_.at(light.at);
        if (!at || !light.shown) {
            continue;
        }
        state_.light_places.emplace_back(light.name, *at);
        const bool guest = light.node == kNone, chosen = state_.selected(light.node);
        const bool off =
            state_.muted.contains(light.node) || (!state_.solo.empty() && !state_.solo.contains(light.node));
        vec3 c = light.colour / std::max({light.colour.x, light.colour.y, light.colour.z, 1e-6f});
        c = glm::mix(c, vec3(1), 0.25f);
        const ImU32 fill =
            off ? IM_COL32(90, 90, 90, 255)
                : ImGui::ColorConvertFloat4ToU32({std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z), 1});
        const ImU32 rim = chosen ? colour::chosen : IM_COL32(20, 20, 20, 255);
        list.AddCircleFilled(im(*at), r + 1.5f, rim, 16);
        list.AddCircleFilled(im(*at), r - 0.5f, fill, 16);
        if (light.type == LightType::spot) {
            list.AddTriangleFilled({at->x, at->y}, {at->x - 0.7f * r, at->y + 0.9f * r},
                                   {at->x + 0.7f * r, at->y + 0.9f * r}, rim);
        } else if (light.type == LightType::directional) {
            for (int i = 0; i < 8; ++i) {
                const float a = static_cast<float>(i) * kPi / 4;
                const vec2 way(std::cos(a), std::sin(a));
                list.AddLine(im(*at + (r + 2) * way), im(*at + (r + 6) * way), rim, 1.5f);
            }
        }
        if (guest) {  // striped: not in the file
            for (float x = -r + 2; x < r; x += 4) {
                list.AddLine({at->x + x, at->y + r * 0.7f}, {at->x + x + 3, at->y - r * 0.7f},
                             IM_COL32(0, 0, 0, 160));
            }
        }
        if (off) {
            list.AddLine({at->x - r, at->y - r}, {at->x + r, at->y + r}, colour::bad, 2);
        }
        if (chosen) {
            // Below the handles, which would strike it through.
            outlined(list, *at + vec2(r + 4, 1.5f * r), colour::words, light.name);
        }
    }
}

void Viewport::draw_selection() {
    if (state_.chosen.empty()) {
        return;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    editor::EditSession& session = state_.session;
    const FrameScene* scene = session.world().try_resource<FrameScene>();
    if (scene == nullptr) {
        return;
    }
    for (const std::uint32_t top : state_.chosen) {
        const Aabb bounds = bounds_of(top);
        if (bounds.empty()) {
            continue;
        }
        const auto corner = [&](int i) {
            return scene->origin + dvec3((i & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                         (i & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                         (i & 4) != 0 ? bounds.upper.z : bounds.lower.z);
        };
        constexpr std::array<std::pair<int, int>, 12> kEdges = {
            {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
        for (const auto& [a, b] : kEdges) {
            if (const auto line = eye_.line(corner(a), corner(b))) {
                list.AddLine(im(line->first), im(line->second), IM_COL32(0, 0, 0, 160), 3);
                list.AddLine(im(line->first), im(line->second), colour::chosen, 1.5f);
            }
        }
    }
}

void Viewport::draw_handles() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Part lit = handles_.held() ? handles_.part() : hovered_;
    for (const Handles::Stroke& stroke : handles_.strokes()) {
        std::vector<ImVec2> points;
        for (const vec2& p : stroke.points) {
            points.push_back(im(p));
        }
        const bool on = stroke.part == lit && lit != Part::none;
        ImU32 shade = on ? colour::chosen : part_colour(stroke.part);
        const bool patch = stroke.part == Part::yz || stroke.part == Part::zx || stroke.part == Part::xy;
        if (stroke.part == Part::none) {
            shade = faded(shade, 0.5f);
        }
        const auto count = static_cast<int>(points.size());
        if (stroke.filled) {
            list.AddConvexPolyFilled(points.data(), count, patch ? faded(shade, on ? 0.8f : 0.4f) : shade);
            list.AddPolyline(points.data(), count, patch ? shade : IM_COL32(0, 0, 0, 200), ImDrawFlags_Closed,
                             1);
        } else {
            list.AddPolyline(points.data(), count, IM_COL32(0, 0, 0, 150), 0, 4);
            list.AddPolyline(points.data(), count, shade, 0, on ? 3.0f : 2.0f);
        }
    }
    if (!change_words_.empty()) {
        outlined(list, drag_pixel_ + vec2(18, 14), colour::words, change_words_);
    }
}

void Viewport::draw_scale_bar() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Box& box = state_.layout.picture;
    const float u = state_.unit;
    // At the distance that is orbited round.
    const dvec3 there = eye_.eye() + std::max(distance_, 0.01) * eye_.ahead();
    const double metre = eye_.pixels_a_metre(there);
    double length = 1;
    const double longest = std::min(260 * static_cast<double>(u), 0.4 * static_cast<double>(box.width));
    while (metre * length > longest && length > 1e-3) {
        length /= 10;
    }
    while (metre * length < 16 * static_cast<double>(u) && length < 1e5) {
        length *= 10;
    }
    const vec2 from(box.x + 56 * u, box.y + box.height - 12 * u);
    const vec2 to = from + vec2(static_cast<float>(metre * length), 0);
    list.AddLine(im(from + vec2(0, 1)), im(to + vec2(0, 1)), IM_COL32(0, 0, 0, 200), 3);
    list.AddLine(im(from), im(to), colour::words, 2);
    outlined(list, from + vec2(0, -18 * u), colour::words, shown_number(length) + " m");
    const vec2 middle(box.x + 24 * u, box.y + box.height - 24 * u);
    for (int i = 0; i < 3; ++i) {
        dvec3 axis(0);
        axis[i] = 1;
        const vec2 way(static_cast<float>(glm::dot(axis, eye_.right())),
                       static_cast<float>(-glm::dot(axis, eye_.up())));
        constexpr std::array kParts = {Part::x, Part::y, Part::z};
        list.AddLine(im(middle), im(middle + 16 * u * way), part_colour(kParts[static_cast<std::size_t>(i)]),
                     2);
    }
}

void Viewport::draw_lux() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Box& box = state_.layout.picture;
    const float u = state_.unit;
    if (state_.picture.view() == "lux" && state_.picture.scale() > 0) {
        const vec2 from(box.x + box.width - 24 * u, box.y + 34 * u);
        const float height = 120 * u;
        for (int i = 0; i < 30; ++i) {
            const vec3 c = heat_colour(1 - static_cast<float>(i) / 29);
            list.AddRectFilled({from.x, from.y + height * static_cast<float>(i) / 30},
                               {from.x + 14 * u, from.y + height * static_cast<float>(i + 1) / 30},
                               ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}));
        }
        for (int i = 0; i <= 3; ++i) {
            const std::string words = shown_number(state_.picture.scale() * std::pow(10.0, -i), 3) + " lx";
            const float width = ImGui::CalcTextSize(words.c_str()).x;
            outlined(list, {from.x - width - 6 * u, from.y + height * static_cast<float>(i) / 3 - 8 * u},
                     colour::words, words);
        }
    }
    state_.lux_under_pointer.reset();
    if (lux_of_frame_ != state_.picture.frames() || lux_.pixels.empty() || !box.contains(last_)) {
        return;
    }
    const int x = static_cast<int>((last_.x - box.x) / box.width * static_cast<float>(lux_.width));
    const int y = static_cast<int>((last_.y - box.y) / box.height * static_cast<float>(lux_.height));
    if (x < 0 || y < 0 || x >= lux_.width || y >= lux_.height) {
        return;
    }
    const float lux = lux_.at(x, y, 0);
    if (lux > 0) {
        state_.lux_under_pointer = static_cast<double>(lux);
        const std::string words = shown_number(static_cast<double>(lux), 3) + " lx";
        const ImVec2 size = ImGui::CalcTextSize(words.c_str());
        chip(list, {box.x + box.width - size.x - 12 * u, box.y + box.height - size.y - 8 * u}, 3 * u,
             colour::words, words);
    }
}

}  // namespace lanthorn::edit_window
