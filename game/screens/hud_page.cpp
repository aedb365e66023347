#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/screens/pages.h"
#include "game/screens/symbols.h"
#include "lanthorn/ui/label_places.h"

namespace lanthorn::game::ui {

namespace {

// Words on the picture, in the fonts and units of the model.
class Plates {
  public:
    explicit Plates(const Model& model) : u_(model.page.unit), font_(model.page.fonts.text) {}

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

    // Lines in the middle, over what reaches up to `lowest`.
    void hint(const std::string& words, float lowest) const {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        const float wrap = std::max(60.0f, std::min(size.x - 60 * u_, 680 * u_));
        const ImVec2 box = extent(words, wrap);
        const ImVec2 low{0.5f * (size.x - box.x), std::max(lowest - box.y - 26 * u_, 24 * u_)};
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

// What a prompt is done with: its keys, or what a stick does.
std::string keys_of(const Model& model, const Prompt& prompt) {
    if (prompt.actions.empty()) {
        return model.say(model.looks_by);
    }
    if (prompt.actions.front() == Action::forward && prompt.actions.size() > 1 && model.by_pad) {
        return model.say("left stick");
    }
    std::string keys;
    for (const Action action : prompt.actions) {
        keys += keys.empty() ? model.key(action) : fmt::format(" {}", model.key(action));
    }
    return keys;
}

// Lines of key plates from the lower left upwards, as many as a third of the picture takes. Returns how high
// they reach.
float draw_prompts(const Model& model, const Plates& plates) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit, left = std::min(24 * u, 0.05f * size.x), line = plates.line() + 6 * u;
    ImVec2 at{left, size.y - 34 * u};
    float top = size.y;
    for (const Prompt& prompt : model.prompts) {
        const std::string keys = keys_of(model, prompt), words = model.say(prompt.words);
        const float width = plates.width(keys, words);
        if (at.x > left && at.x + width > size.x - left) {
            at = {left, at.y - line};
        }
        if (at.x + width > size.x || at.y < 0.66f * size.y) {
            continue;
        }
        at.x += plates.key(at, keys, words, prompt.strength) + 10 * u;
        top = at.y - 0.5f * line;
    }
    return top;
}

// `lowest`: of the room for them.
void draw_labels(const Model& model, const Plates& plates, float lowest) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit, line = plates.line();
    const float low = 0.5f * line;
    const float high = std::max({low, lowest - line, std::min(line, size.y - low)});
    std::vector<lanthorn::ui::LabelPlace> placed;
    for (const HudLabel& label : model.hud.labels) {
        const std::string &key = model.key(label.action), words = model.say(label.words);
        const float width = plates.width(key, words);
        const float room = std::max(4 * u, size.x - width - 10 * u);
        lanthorn::ui::LabelPlace at{std::clamp(label.place.x * size.x, 4 * u, room), label.place.y * size.y,
                                    width};
        // The nearest things come first: where there is no room it is for what is far.
        if (const std::optional<float> y = lanthorn::ui::free_height(placed, at, line, low, high)) {
            at.y = *y;
            placed.push_back(at);
            plates.key({at.x, at.y}, key, words, 1);
        }
    }
}

// Symbols where they are asked for; how far a crystal has come, for all.
void draw_marks(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const HudMark& mark : model.hud.marks) {
        const float radius = model.page.unit * std::clamp(60 / std::max(mark.distance, 0.1f), 11.0f, 20.0f);
        const ImVec2 at{mark.place.x * size.x, mark.place.y * size.y};
        if (model.symbols) {
            // Beside it, so that it can be seen itself.
            const float aside = at.x + 5 * radius < size.x ? 3 * radius : -3 * radius;
            draw_symbol(draw, mark.symbol, {at.x + aside, at.y}, radius, mark.awake ? 1 : mark.charge);
        } else if (mark.charge > 0 && !mark.awake) {
            draw_charge(draw, at, 1.6f * radius, mark.charge);
        }
    }
}

// A ring of light that goes out from a crystal that has woken, and how many have.
void draw_reveal(const Model& model, const RevealMark& reveal) {
    constexpr float kRingSeconds = 1.3f, kAfter = 0.35f, kBegin = 0.9f;  // seconds
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (int ring = 0; reveal.place && ring < 2; ++ring) {
        const float t = (reveal.seconds - kBegin - kAfter * static_cast<float>(ring)) / kRingSeconds;
        if (t > 0 && t < 1) {
            const float out = 1 - (1 - t) * (1 - t);
            draw.AddCircle({reveal.place->x * size.x, reveal.place->y * size.y},
                           (0.04f + 0.5f * out) * size.y, lamplight(0.55f * (1 - t)), 96,
                           std::max(1.5f, (1 - t) * 7 * u));
        }
    }
    if (reveal.all < 2) {
        return;
    }
    const std::string words = fill_in(model.say("{awake} of {all} are awake"), [&](std::string_view name) {
        return std::to_string(name == "awake" ? reveal.awake : reveal.all);
    });
    ImFont* font = model.page.fonts.heading;
    const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.c_str());
    const ImVec2 low{0.5f * (size.x - extent.x), size.y - extent.y - 60 * u};
    draw.AddRectFilled({low.x - 22 * u, low.y - 10 * u},
                       {low.x + extent.x + 22 * u, low.y + extent.y + 12 * u}, night(0.7f), 10 * u);
    draw.AddText(font, font->FontSize, low, lamplight(), words.c_str());
}

}  // namespace

void draw_hud(const Model& model) {
    const Plates plates(model);
    if (model.reveal) {
        draw_reveal(model, *model.reveal);
        return;
    }
    draw_marks(model);
    const float lowest = draw_prompts(model, plates);
    draw_labels(model, plates, lowest);
    if (!model.hint.empty()) {
        plates.hint(model.say_with_keys(model.hint), lowest);
    } else if (!model.story.empty()) {
        plates.hint(model.say(model.story), 0);  // at the top, where it hides nothing that can be taken
    }
}

void draw_captions(const Model& model) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = model.page.unit;
    ImFont* font = model.page.fonts.text;
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    float y = 20 * u;
    for (const std::string& line : model.captions) {
        const std::string words = fmt::format("[{}]", model.say(line));
        const float wrap = std::max(60.0f, std::min(0.45f * size.x, 420 * u));
        const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, wrap, words.c_str());
        const ImVec2 low{24 * u, y};
        draw.AddRectFilled({low.x - 10 * u, low.y - 5 * u},
                           {low.x + extent.x + 10 * u, low.y + extent.y + 7 * u}, night(0.8f), 7 * u);
        draw.AddText(font, font->FontSize, low, parchment(), words.c_str(), nullptr, wrap);
        y += extent.y + 18 * u;
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
