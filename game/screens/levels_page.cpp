#include <fmt/format.h>

#include <algorithm>

#include "game/screens/pages.h"

namespace lanthorn::game::ui {

namespace {

constexpr float kWidth = 300, kGap = 22;  // units, of a card and between two

// A picture with its title below, and a small flame where it is solved.
bool card(const Model& model, int level, const LevelCard& shown) {
    const float u = model.page.unit;
    const float width = std::min(kWidth * u, ImGui::GetContentRegionAvail().x);
    const float picture = width * 9 / 16, line = ImGui::GetFontSize() + 12 * u;
    const bool pressed =
        ImGui::InvisibleButton(fmt::format("level {}", level).c_str(), {width, picture + line});
    if (level == model.screens.level) {
        ImGui::SetItemDefaultFocus();
    }
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 corner{high.x, low.y + picture};
    const bool chosen = is_chosen(model.page);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (shown.picture != nullptr) {
        draw.AddImageRounded(shown.picture, low, corner, {0, 0}, {1, 1},
                             IM_COL32(255, 255, 255, chosen ? 255 : 205), 8 * u);
    } else {
        draw.AddRectFilled(low, corner, lamplight(0.12f), 8 * u);
        const std::string number = std::to_string(level + 1);
        ImFont* font = model.page.fonts.heading;
        const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, 0, number.c_str());
        draw.AddText(font, font->FontSize,
                     {0.5f * (low.x + high.x - size.x), low.y + 0.5f * (picture - size.y)}, lamplight(0.8f),
                     number.c_str());
    }
    draw.AddRect(low, corner, chosen ? lamplight() : lamplight(0.25f), 8 * u, 0, (chosen ? 3.0f : 1.0f) * u);
    const std::string title = fmt::format("{}  {}", level + 1, shown.title);
    draw.AddText({low.x + 4 * u, corner.y + 7 * u}, chosen ? lamplight() : parchment(), title.c_str());
    if (shown.solved) {
        const ImVec2 flame{high.x - 14 * u, corner.y + 7 * u + 0.5f * ImGui::GetFontSize()};
        draw.AddCircleFilled(flame, 9 * u, lamplight(0.25f));
        draw.AddCircleFilled(flame, 5 * u, lamplight());
    }
    return pressed;
}

}  // namespace

std::optional<Event> draw_levels(const Model& model) {
    std::optional<Event> event;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, night(0.78f));
    const bool roomy = size.x > 760 * u && size.y > 420 * u;
    const int columns = std::clamp(
        static_cast<int>((size.x - (roomy ? 144 : 16) * u + kGap * u) / ((kWidth + kGap) * u)), 1, 3);
    const float content = static_cast<float>(columns) * (kWidth + kGap) * u - kGap * u;
    const float side = roomy ? 0.5f * (size.x - content) : 8 * u;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {side, (roomy ? 48 : 6) * u});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap * u, 14 * u});
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size);
    if (model.page.appearing) {
        ImGui::SetNextWindowFocus();
    }
    let_keys_choose(model.page);
    ImGui::Begin("levels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(model.page.fonts.heading);
    ImGui::TextUnformatted(model.say("Levels").c_str());
    ImGui::PopFont();
    for (int level = 0; level < static_cast<int>(model.levels.size()); ++level) {
        if (level % columns != 0) {
            ImGui::SameLine();
        }
        if (card(model, level, model.levels[static_cast<std::size_t>(level)])) {
            event = {Happening::choose, level};
        }
    }
    if (entry(model.page, model.say("Back").c_str())) {
        event = {Happening::back};
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    return wants_back(model.page) ? Event{Happening::back} : event;
}

}  // namespace lanthorn::game::ui
