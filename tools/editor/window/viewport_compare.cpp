// A|B: another picture left of the one of now, with a divider between them.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

namespace {

constexpr float kGrip = 6;  // units to either side of the divider that take hold of it

}  // namespace

std::string picture_words(const PictureFacts& facts, const std::string& more, bool sized) {
    const std::string size = sized ? fmt::format("{}x{} - ", facts.size.x, facts.size.y) : std::string();
    std::string words =
        fmt::format("{}{}{} - {} {} - {}{:.0f} ms", name_of(facts.quality), more.empty() ? "" : ", ", more,
                    facts.technique, facts.preset, size, facts.ms);
    if (facts.view != "final") {
        words += " - " + facts.view;
    }
    return words;
}

std::shared_ptr<const OtherSide> Viewport::kept_side() const {
    if (state_.picture.texture() == 0) {
        return nullptr;
    }
    OtherSide side;
    side.kept.emplace();
    side.kept->texture = state_.picture.copy();
    side.kept->words = picture_words(state_.picture.facts(), "");
    side.kept->version = state_.session.version();
    side.kept->pose = state_.session.pose();
    return std::make_shared<const OtherSide>(std::move(side));
}

void Viewport::compare(std::shared_ptr<const OtherSide> with, double now) {
    history_.leave(looked(), now, true);
    state_.other_side = std::move(with);
    ++state_.other_pictures;
}

bool Viewport::over_divider(const vec2& pixel) const {
    const Box& box = state_.layout.picture;
    return state_.other_side && box.contains(pixel) &&
           std::abs(pixel.x - box.x - state_.divider * box.width) < kGrip * state_.unit;
}

void Viewport::move_divider(const vec2& pixel) {
    const Box& box = state_.layout.picture;
    state_.divider = std::clamp((pixel.x - box.x) / box.width, 0.02f, 0.98f);
}

std::string Viewport::other_words(bool sized) const {
    if (const KeptPicture* kept = state_.kept_picture()) {
        const bool moved = !(kept->pose == state_.session.pose());
        const bool edited = kept->version != state_.session.version();
        return "A  before: " + kept->words +
               (moved    ? " - from another place"
                : edited ? " - before later edits"
                         : "");
    }
    if (state_.picture.other_texture() == 0) {
        return "A  " + words_of(*state_.other_side->as) + " - not drawn yet";
    }
    const editor::TracedSamples& traced = state_.other_traced;
    const std::string left = traced.left_words();
    return "A  " +
           picture_words(state_.picture.other_facts(), traced.words() + (left.empty() ? "" : ", " + left),
                         sized) +
           (state_.picture.other_is_new() ? "" : " - as before the hand moved");
}

void Viewport::draw_compared() {
    const Box& box = state_.layout.picture;
    if (!state_.other_side) {
        return;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = box.x + state_.divider * box.width;
    const KeptPicture* kept = state_.kept_picture();
    if (const GLuint texture = kept != nullptr ? kept->texture.id() : state_.picture.other_texture();
        texture != 0) {
        const auto id = image_of(texture);
        list.AddImage(id, {box.x, box.y}, {x, box.y + box.height}, {0, 1}, {state_.divider, 0});
    } else {
        list.AddRectFilled({box.x, box.y}, {x, box.y + box.height}, IM_COL32(0, 0, 0, 120));
    }
}

void Viewport::draw_divider() {
    const Box& box = state_.layout.picture;
    if (!state_.other_side) {
        return;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float u = state_.unit, x = box.x + state_.divider * box.width;
    list.AddRectFilled({x - 2 * u, box.y}, {x + 2 * u, box.y + box.height}, IM_COL32(0, 0, 0, 160));
    list.AddRectFilled({x - 0.5f * u, box.y}, {x + 0.5f * u, box.y + box.height}, colour::words);
    const vec2 middle(x, box.y + box.height / 2);
    list.AddCircleFilled(im(middle), 8 * u, IM_COL32(0, 0, 0, 200), 16);
    list.AddTriangleFilled(im(middle + vec2(-6 * u, 0)), im(middle + vec2(-2 * u, -4 * u)),
                           im(middle + vec2(-2 * u, 4 * u)), colour::words);
    list.AddTriangleFilled(im(middle + vec2(6 * u, 0)), im(middle + vec2(2 * u, -4 * u)),
                           im(middle + vec2(2 * u, 4 * u)), colour::words);
    const float line = ImGui::GetFontSize();
    const auto letter = [&](const char* name, float left, ImU32 shade) {
        const vec2 at(left, middle.y - 0.65f * line);
        list.AddRectFilled(im(at), im(at + vec2(1.2f * line, 1.3f * line)), IM_COL32(0, 0, 0, 190));
        list.AddText(im(at + vec2(0.3f * line, 0.15f * line)), shade, name);
    };
    letter("A", x - 12 * u - 1.2f * line, colour::chosen);
    letter("B", x + 12 * u, colour::words);
}

void Viewport::draw_compare_popup() {
    if (std::exchange(state_.compare_menu, false)) {
        ImGui::OpenPopup("A|B");
        const Box& button = state_.compare_button;
        const Box& box = state_.layout.picture;
        ImGui::SetNextWindowPos(button.empty() ? ImVec2(box.x, box.y)
                                               : ImVec2(button.x, button.y + button.height));
    }
    if (ImGui::BeginPopup("A|B")) {
        draw_compare_menu(state_);
        ImGui::EndPopup();
    }
}

}  // namespace lanthorn::edit_window
