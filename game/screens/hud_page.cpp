#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "game/screens/pages.h"
#include "game/screens/symbols.h"
#include "lanthorn/ui/label_places.h"

namespace lanthorn::game::ui {

namespace {

// Words on the picture, in the fonts and units of the model.
class Words {
  public:
    explicit Words(const Model& model) : u_(model.page.unit), font_(model.page.fonts.text) {}

    float line() const { return font_->FontSize + 20 * u_; }
    ImVec2 extent(const std::string& words, float wrap = 0) const {
        return font_->CalcTextSizeA(font_->FontSize, 1e9f, wrap, words.c_str());
    }
    float width(const std::string& key, const std::string& words) const {
        return plate(key) + 28 * u_ + extent(words).x;
    }

    // A key on a small lit plate, and words after it; `at`: the middle of the left edge. Returns its width.
    float key(const ImVec2& at, const std::string& key, const std::string& words, float alpha) const {
        ImDrawList& draw = *ImGui::GetBackgroundDrawList();
        const float height = font_->FontSize, plate_width = plate(key);
        const ImVec2 low{at.x + 6 * u_, at.y - 0.5f * height - 4 * u_};
        draw.AddRectFilled({at.x, low.y - 4 * u_}, {at.x + width(key, words), low.y + height + 12 * u_},
                           night(0.66f * alpha), 9 * u_);
        draw.AddRectFilled(low, {low.x + plate_width, low.y + height + 8 * u_}, lamplight(0.92f * alpha),
                           6 * u_);
        draw.AddText(font_, height, {low.x + 0.5f * (plate_width - extent(key).x), low.y + 4 * u_},
                     night(alpha), key.c_str());
        draw.AddText(font_, height, {low.x + plate_width + 10 * u_, low.y + 4 * u_}, parchment(alpha),
                     words.c_str());
        return width(key, words);
    }

    // Lines in the middle of the picture's lower edge.
    void hint(const std::string& words) const {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float wrap = std::max(60.0f, std::min(size.x - 60 * u_, 680 * u_));
        const ImVec2 box = extent(words, wrap);
        const ImVec2 low{0.5f * (size.x - box.x), size.y - box.y - 84 * u_};
        ImDrawList& draw = *ImGui::GetBackgroundDrawList();
        draw.AddRectFilled({low.x - 22 * u_, low.y - 14 * u_},
                           {low.x + box.x + 22 * u_, low.y + box.y + 14 * u_}, night(0.8f), 10 * u_);
        draw.AddText(font_, font_->FontSize, low, parchment(), words.c_str(), nullptr, wrap);
    }

  private:
    float plate(const std::string& key) const {
        return std::max(extent(key).x + 14 * u_, font_->FontSize + 8 * u_);
    }

    float u_;
    ImFont* font_;
};

void draw_labels(const Model& model, const Words& words) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit, line = words.line();
    // Below are the keys of always, if the picture has room for both.
    const float low = 0.5f * line, high = std::max({low, size.y - 2 * line, std::min(line, size.y - low)});
    std::vector<lanthorn::ui::LabelPlace> placed;
    for (const HudLabel& label : model.hud.labels) {
        const std::string& key = model.key(label.action);
        const float width = words.width(key, label.words);
        const float room = std::max(4 * u, size.x - width - 10 * u);
        lanthorn::ui::LabelPlace at{std::clamp(label.place.x * size.x, 4 * u, room), label.place.y * size.y,
                                    width};
        // The nearest things come first: where there is no room it is for what is far.
        if (const std::optional<float> y = lanthorn::ui::free_height(placed, at, line, low, high)) {
            at.y = *y;
            placed.push_back(at);
            words.key({at.x, at.y}, key, label.words, 1);
        }
    }
}

void draw_marks(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    for (const HudMark& mark : model.hud.marks) {
        const float radius = model.page.unit * std::clamp(60 / std::max(mark.distance, 0.1f), 11.0f, 20.0f);
        draw_symbol(*ImGui::GetBackgroundDrawList(), mark.symbol,
                    {mark.place.x * size.x, mark.place.y * size.y}, radius, mark.awake ? 1 : mark.charge);
    }
}

// The keys of always: for a while, then they leave the picture to the light.
void draw_keys(const Model& model, const Words& words) {
    const float alpha = std::clamp(0.4f * (10 - model.page.shown_seconds), 0.0f, 0.9f);
    if (alpha <= 0) {
        return;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    ImVec2 at{24 * u, size.y - 34 * u};
    const auto add = [&](Action action, const char* what) {
        if (at.x + words.width(model.key(action), what) < size.x) {
            at.x += words.key(at, model.key(action), what, alpha) + 10 * u;
        }
    };
    if (model.hud.carries) {
        add(Action::carry, "put down");
        add(Action::light, "light");
        add(Action::colour, "colour");
    }
    add(Action::hint, "hint");
    add(Action::menu, "menu");
}

}  // namespace

void draw_hud(const Model& model) {
    const Words words(model);
    if (model.symbols) {
        draw_marks(model);
    }
    draw_labels(model, words);
    draw_keys(model, words);
    if (!model.hint.empty()) {
        words.hint(model.hint);
    }
}

void draw_notices(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    ImFont* font = model.page.fonts.text;
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
