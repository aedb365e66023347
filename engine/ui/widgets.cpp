#include "lanthorn/ui/widgets.h"

#include <imgui_internal.h>  // NavMoveRequestTryWrapping

#include <algorithm>
#include <cmath>

namespace lanthorn::ui {

namespace {

// Whether it went down in this frame, or repeats because it is held. After a frame longer than the delay
// nobody knows for how long it was.
bool pressed(ImGuiNavInput input) {
    constexpr float kDelay = 0.4f, kRate = 0.1f;  // seconds
    const ImGuiIO& io = ImGui::GetIO();
    const float held = io.NavInputsDownDuration[input], before = io.NavInputsDownDurationPrev[input];
    if (held < kDelay || io.DeltaTime > kDelay) {
        return held == 0;
    }
    return std::floor((held - kDelay) / kRate) > std::floor((std::max(before, 0.0f) - kDelay) / kRate);
}

int sideways() {
    const auto any = [](ImGuiNavInput key, ImGuiNavInput pad, ImGuiNavInput stick) {
        return pressed(key) || pressed(pad) || pressed(stick);
    };
    return any(ImGuiNavInput_KeyRight_, ImGuiNavInput_DpadRight, ImGuiNavInput_LStickRight) -
           any(ImGuiNavInput_KeyLeft_, ImGuiNavInput_DpadLeft, ImGuiNavInput_LStickLeft);
}

void draw_arrow(const ImVec2& middle, float size, ImU32 colour) {
    ImGui::GetWindowDrawList()->AddTriangleFilled({middle.x - 0.5f * size, middle.y - size},
                                                  {middle.x - 0.5f * size, middle.y + size},
                                                  {middle.x + 0.5f * size, middle.y}, colour);
}

// A lit plate behind what is chosen, fading to the right.
void draw_chosen(const Page& page, const ImVec2& low, const ImVec2& high) {
    const vec3& light = page.theme->chosen;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilledMultiColor(low, high, packed(light, 0.22f), packed(light, 0.02f), packed(light, 0.02f),
                                 packed(light, 0.22f));
    draw.AddRectFilled(low, {low.x + 3 * page.unit, high.y}, packed(light));
}

}  // namespace

void draw_shade(const Page& page, float reach, float darkness, float words) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    // Two pieces: dark where words are, and a long slope that ends without an edge.
    const float column = std::min(words * page.unit, size.x);
    const float bend = std::max(0.5f * reach * size.x, column);
    const float end = std::max(reach * size.x, 1.4f * column);
    draw.AddRectFilledMultiColor({0, 0}, {bend, size.y}, packed(page.theme->behind, darkness),
                                 packed(page.theme->behind, 0.72f * darkness),
                                 packed(page.theme->behind, 0.72f * darkness),
                                 packed(page.theme->behind, darkness));
    draw.AddRectFilledMultiColor({bend, 0}, {end, size.y}, packed(page.theme->behind, 0.72f * darkness),
                                 packed(page.theme->behind, 0), packed(page.theme->behind, 0),
                                 packed(page.theme->behind, 0.72f * darkness));
}

void begin_column(const Page& page, const char* id, const std::string& heading, const std::string& words) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = page.unit;
    const bool roomy = size.y > 420 * u && size.x > 560 * u;
    const ImVec2 padding = roomy ? ImVec2(72 * u, 56 * u) : ImVec2(8 * u, 6 * u);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({std::min(size.x, kColumnUnits * u), size.y});
    if (page.appearing) {
        ImGui::SetNextWindowFocus();
    }
    let_keys_choose(page);
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (roomy && heading == page.theme->name) {
        ImGui::PushFont(page.fonts.title);
        ImGui::TextUnformatted(heading.c_str());
        ImGui::PopFont();
    } else {
        ImGui::PushFont(page.fonts.heading);
        ImGui::TextUnformatted(heading.c_str());
        ImGui::PopFont();
    }
    if (roomy && !words.empty()) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 460 * u);
        ImGui::TextDisabled("%s", words.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::Dummy({0, roomy ? 14 * u : 0});
}

void let_keys_choose(const Page& page) {
    if (!page.pointing || !ImGui::IsAnyItemHovered()) {
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
    }
}

void end_column(const Page&) {
    // Up from the first entry is the last one, but not for a key that is held.
    const auto repeats = [](ImGuiNavInput input) { return ImGui::GetIO().NavInputsDownDuration[input] > 0; };
    if (!repeats(ImGuiNavInput_KeyUp_) && !repeats(ImGuiNavInput_KeyDown_) &&
        !repeats(ImGuiNavInput_DpadUp) && !repeats(ImGuiNavInput_DpadDown)) {
        ImGui::NavMoveRequestTryWrapping(ImGui::GetCurrentWindow(), ImGuiNavMoveFlags_LoopY);
    }
    ImGui::End();
}

bool is_chosen(const Page& page) {
    const bool focused = ImGui::IsItemFocused();
    if (focused && !page.pointing) {
        const float low = ImGui::GetItemRectMin().y - ImGui::GetWindowPos().y;
        const float high = ImGui::GetItemRectMax().y - ImGui::GetWindowPos().y;
        if (low < 0 || high > ImGui::GetWindowHeight()) {
            ImGui::SetScrollHereY(0.5f);
        }
    }
    // Where the mouse points at nothing, what keys would choose is seen all the same.
    return page.pointing && ImGui::IsAnyItemHovered() ? ImGui::IsItemHovered() : focused;
}

namespace {

// Something to choose, as large as `size`; what is chosen stands before a shade.
struct Item {
    ImVec2 low, high;
    bool pressed = false, chosen = false;
};

Item make_item(const Page& page, const char* words, const ImVec2& size, bool first) {
    Item item;
    item.pressed = ImGui::InvisibleButton(words, size);
    if (first) {
        ImGui::SetItemDefaultFocus();
    }
    item.low = ImGui::GetItemRectMin();
    item.high = ImGui::GetItemRectMax();
    item.chosen = is_chosen(page);
    if (item.chosen) {
        draw_chosen(page, item.low, item.high);
    }
    return item;
}

}  // namespace

bool entry(const Page& page, const char* words, bool first) {
    const float u = page.unit;
    ImGui::PushFont(page.fonts.heading);
    const ImVec2 text = ImGui::CalcTextSize(words);
    const float width = std::min(ImGui::GetContentRegionAvail().x, std::max(300 * u, text.x + 44 * u));
    const Item item = make_item(page, words, {width, text.y + 14 * u}, first);
    ImGui::GetWindowDrawList()->AddText({item.low.x + 18 * u, item.low.y + 7 * u},
                                        item.chosen ? packed(page.theme->chosen) : packed(page.theme->words),
                                        words);
    ImGui::PopFont();
    return item.pressed;
}

void row(const Page& page, const char* words, const std::string& value, const std::function<void(int)>& step,
         bool first) {
    const float u = page.unit;
    const float height = ImGui::GetFontSize() + 11 * u;
    const auto [low, high, pressed, chosen] =
        make_item(page, words, {ImGui::GetContentRegionAvail().x, height}, first);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float y = low.y + 5.5f * u;
    draw.AddText({low.x + 18 * u, y}, chosen ? packed(page.theme->chosen) : packed(page.theme->words), words);
    // The value stands between two arrows, on the right half.
    const float left = low.x + 0.52f * (high.x - low.x), right = high.x - 14 * u;
    const ImVec2 size = ImGui::CalcTextSize(value.c_str());
    draw.AddText({0.5f * (left + right - size.x), y},
                 chosen ? packed(page.theme->words) : packed(page.theme->faint), value.c_str());
    if (chosen) {
        draw_arrow({left, 0.5f * (low.y + high.y)}, -6 * u, packed(page.theme->chosen));
        draw_arrow({right, 0.5f * (low.y + high.y)}, 6 * u, packed(page.theme->chosen));
    }
    if (pressed) {
        const bool on_left = page.pointing && ImGui::GetIO().MousePos.x < 0.5f * (left + right);
        step(on_left ? -1 : 1);
    } else if (ImGui::IsItemFocused()) {
        if (const int way = sideways(); way != 0) {
            step(way);
        }
    }
}

void section(const Page& page, const char* words) {
    ImGui::Dummy({0, 4 * page.unit});
    ImGui::TextDisabled("%s", words);
}

bool wants_back(const Page& page) {
    return !page.appearing && ImGui::GetIO().NavInputsDownDuration[ImGuiNavInput_Cancel] == 0;
}

}  // namespace lanthorn::ui
