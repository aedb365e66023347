#include <algorithm>

#include "game/ui/pages.h"
#include "game/ui/widgets.h"

namespace lanthorn::game::ui {

namespace {

const char* key_of(Button button) {
    switch (button) {
        case kUse:
            return "E";
        case kLight:
            return "F";
        case kCarry:
            return "G";
        case kDimUp:
            return "+";
        case kDimDown:
            return "-";
        case kColour:
            return "C";
        case kView:
            return "V";
        case kHint:
            return "H";
        case kReset:
            return "R";
    }
    return "";
}

// A key on a small lit plate, and words after it; `at`: the middle of the left edge. Returns its width.
float draw_key(const Model& model, const ImVec2& at, const char* key, const std::string& words, float alpha) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float u = model.unit;
    ImFont* font = model.fonts.text;
    const float height = font->FontSize;
    const ImVec2 key_size = font->CalcTextSizeA(height, 1e9f, 0, key);
    const ImVec2 text_size = font->CalcTextSizeA(height, 1e9f, 0, words.c_str());
    const float plate = std::max(key_size.x + 14 * u, height + 8 * u);
    const float width = plate + 10 * u + text_size.x;
    const ImVec2 low{at.x, at.y - 0.5f * height - 4 * u};
    draw.AddRectFilled({low.x - 6 * u, low.y - 4 * u}, {low.x + width + 12 * u, low.y + height + 12 * u},
                       night(0.62f * alpha), 9 * u);
    draw.AddRectFilled(low, {low.x + plate, low.y + height + 8 * u}, lamplight(0.92f * alpha), 6 * u);
    draw.AddText(font, height, {low.x + 0.5f * (plate - key_size.x), low.y + 4 * u}, night(alpha), key);
    draw.AddText(font, height, {low.x + plate + 10 * u, low.y + 4 * u}, parchment(alpha), words.c_str());
    return width + 18 * u;
}

}  // namespace

void draw_hud(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.unit;
    float lowest = size.y;  // labels do not cover one another
    for (const HudLabel& label : model.hud.labels) {
        ImVec2 at{label.place.x * size.x, label.place.y * size.y};
        const float line = model.fonts.text->FontSize + 20 * u;
        at.x = std::clamp(at.x, 10 * u, std::max(10 * u, size.x - 260 * u));
        at.y = std::clamp(at.y, line, std::max(line, size.y - line));
        if (std::abs(at.y - lowest) < line) {
            at.y = lowest + line;
        }
        lowest = at.y;
        draw_key(model, at, key_of(label.button), label.words, 1);
    }
    // The keys of always: for a while, then they leave the picture to the light.
    const float alpha = std::clamp(0.2f * (12 - model.shown_seconds), 0.0f, 0.9f);
    if (alpha > 0) {
        ImVec2 at{24 * u, size.y - 36 * u};
        for (const auto& [key, words] : {std::pair("F", "light"), {"H", "hint"}, {"Esc", "menu"}}) {
            at.x += draw_key(model, at, key, words, alpha) + 10 * u;
        }
    }
}

void draw_notices(const Model& model) {
    if (model.notices.empty()) {
        return;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.unit;
    ImFont* font = model.fonts.text;
    const float wrap = std::max(60.0f, std::min(size.x - 32 * u, 620 * u));
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    float y = 16 * u;
    for (const std::string& line : model.notices) {
        const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, wrap, line.c_str());
        const ImVec2 low{size.x - extent.x - 30 * u, y};
        draw.AddRectFilled({low.x - 14 * u, low.y}, {size.x - 16 * u, low.y + extent.y + 16 * u},
                           night(0.85f), 8 * u);
        draw.AddText(font, font->FontSize, {low.x, low.y + 8 * u}, parchment(), line.c_str(), nullptr, wrap);
        y += extent.y + 24 * u;
    }
}

}  // namespace lanthorn::game::ui
