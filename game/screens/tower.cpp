#include "game/screens/tower.h"

#include <algorithm>
#include <array>

#include "game/screens/pages.h"

namespace lanthorn::game::ui {

namespace {

// Its parts, in heights of the tower from its middle and its foot.
constexpr float kFoot = 0.155f, kNeck = 0.105f, kWall = 0.74f, kGallery = 0.145f;
constexpr float kLamp = 0.085f, kRoof = 0.9f, kTop = 1.0f;

// Half of its width at a height on the wall.
float half_at(float height) {
    return kFoot + (kNeck - kFoot) * height / kWall;
}

class Drawing {
  public:
    Drawing(const ImVec2& foot, float height) : foot_(foot), height_(height) {}

    ImVec2 at(float x, float y) const { return {foot_.x + x * height_, foot_.y - y * height_}; }
    // Between two heights, symmetric, as wide as said at either.
    void band(float low, float high, float half_low, float half_high, ImU32 colour) const {
        draw_.AddQuadFilled(at(-half_low, low), at(half_low, low), at(half_high, high), at(-half_high, high),
                            colour);
    }
    // A window with a round head.
    void window(float x, float y, bool lit) const {
        constexpr float kHalf = 0.017f, kTall = 0.05f;
        if (lit) {
            for (const float glow : {0.075f, 0.05f, 0.032f}) {
                draw_.AddCircleFilled(at(x, y + 0.5f * kTall), glow * height_, lamplight(0.1f), 32);
            }
        }
        const ImU32 pane = lit ? lamplight() : IM_COL32(34, 36, 48, 255);
        draw_.AddRectFilled(at(x - kHalf, y + kTall), at(x + kHalf, y), pane);
        draw_.AddCircleFilled(at(x, y + kTall), kHalf * height_, pane, 20);
    }

  private:
    ImDrawList& draw_ = *ImGui::GetBackgroundDrawList();
    ImVec2 foot_;
    float height_;
};

}  // namespace

void draw_tower(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    if (size.x < (lanthorn::ui::kColumnUnits + 180) * u || size.y < 300 * u || model.levels.empty()) {
        return;
    }
    const float height = 0.86f * size.y;
    const Drawing tower({size.x - std::max(0.2f * height, 0.14f * size.x), size.y}, height);
    constexpr ImU32 stone = IM_COL32(14, 13, 20, 244), edge = IM_COL32(30, 28, 38, 250);
    tower.band(0, kWall, kFoot, kNeck, stone);
    for (const float y : {0.0f, 0.25f, 0.5f}) {
        tower.band(y, y + 0.008f, half_at(y) + 0.006f, half_at(y) + 0.006f, edge);
    }
    tower.band(kWall, kWall + 0.03f, kGallery, kGallery, edge);
    const auto solved = static_cast<std::size_t>(std::ranges::count(model.levels, true, &LevelCard::solved));
    const bool all = solved == model.levels.size();
    tower.band(kWall + 0.03f, kRoof, kLamp, kLamp, all ? lamplight() : stone);
    for (const float x : {-kLamp, -0.3f * kLamp, 0.3f * kLamp, kLamp}) {
        const ImVec2 low = tower.at(x - 0.004f, kWall + 0.03f), high = tower.at(x + 0.004f, kRoof);
        ImGui::GetBackgroundDrawList()->AddRectFilled({low.x, high.y}, {high.x, low.y}, edge);
    }
    tower.band(kRoof, kTop, kLamp + 0.03f, 0.004f, edge);
    // They wind about the tower, the first one lowest.
    constexpr std::array kTurn = {-0.5f, 0.0f, 0.5f};
    const auto count = static_cast<float>(model.levels.size());
    for (std::size_t i = 0; i < model.levels.size(); ++i) {
        const float y = 0.06f + (kWall - 0.14f) * static_cast<float>(i) / std::max(count - 1, 1.0f);
        tower.window(kTurn[i % kTurn.size()] * half_at(y), y, model.levels[i].solved);
    }
}

}  // namespace lanthorn::game::ui
