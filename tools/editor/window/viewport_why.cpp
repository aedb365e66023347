// The strongest ways of light to the point that was asked about, drawn in the picture.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "lanthorn/core/colour.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/editor/window/viewport.h"
#include "tools/editor/window/window_state.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::edit_window {

std::optional<vec2> Viewport::pointed_place() const {
    const Box& box = state_.layout.picture;
    if (box.empty() || !box.contains(last_)) {
        return std::nullopt;
    }
    return (last_ - vec2(box.x, box.y)) / vec2(box.width, box.height);
}

void Viewport::draw_why_ways() {
    if (!state_.why || state_.why->version != state_.session.version()) {
        return;
    }
    const WhyShown& why = *state_.why;
    const auto& ways = why.answer.split.ways;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double most = ways.empty() ? 0 : ways.front().lux;
    for (std::size_t i = ways.size(); i-- > 0;) {
        const bool on = why.pointed_way == static_cast<int>(i);
        const float share = most > 0 ? static_cast<float>(ways[i].lux / most) : 0;
        const int alpha = on ? 255 : why.pointed_way >= 0 ? 50 : 90 + static_cast<int>(130 * share);
        const ImU32 shade = on ? colour::chosen : IM_COL32(0xff, 0xe2, 0x9a, alpha);
        const auto& places = ways[i].places;
        for (std::size_t k = 0; k + 1 < places.size(); ++k) {
            const auto leg =
                eye_.line(why.answer.origin + dvec3(places[k]), why.answer.origin + dvec3(places[k + 1]));
            if (leg) {
                list.AddLine(im(leg->first), im(leg->second), IM_COL32(0, 0, 0, alpha / 2), on ? 4.0f : 3.0f);
                list.AddLine(im(leg->first), im(leg->second), shade, on ? 2.5f : 1.0f + share);
            }
            const auto bend = k > 0 ? eye_.at(why.answer.origin + dvec3(places[k])) : std::nullopt;
            if (bend) {
                list.AddCircleFilled(im(*bend), (on ? 4.0f : 2.5f) * state_.unit, shade, 10);
            }
        }
    }
    if (const auto here = eye_.at(why.answer.at)) {
        list.AddCircle(im(*here), 7 * state_.unit, IM_COL32(0, 0, 0, 220), 20, 4);
        list.AddCircle(im(*here), 7 * state_.unit, colour::chosen, 20, 2);
    }
}

void EditorWindow::State::ask_why(const vec2& place) {
    EditorState& e = *editor;
    const FrameScene* frame = session.world().try_resource<FrameScene>();
    const ivec2 size = e.picture.facts().size;
    if (frame == nullptr || size.x == 0) {
        return;
    }
    const ivec2 pixel = glm::clamp(ivec2(place * vec2(size)), ivec2(0), size - 1);
    std::optional<editor::WhyAnswer> answer = why_light.ask(*frame, e.settings, size, pixel);
    if (!answer) {
        e.why.reset();
        e.say("no surface is seen there", now());
        return;
    }
    WhyShown why;
    why.answer = std::move(*answer);
    why.name = editor::names_in(session);
    const std::vector<ecs::Entity> all = session.entities();
    for (std::uint32_t node = 0; node < all.size(); ++node) {
        if (all[node] != ecs::kNullEntity) {
            why.nodes[all[node].index] = node;
        }
    }
    why.technique = e.picture.facts().technique;
    const Renderer& renderer = session.world().resource<Renderer>();
    if (renderer.frame) {
        const ImageF indirect = renderer.frame->read(render::Aov::indirect);
        if (indirect.width == size.x && indirect.height == size.y) {
            why.shown = luminance(dvec3(indirect.at(pixel.x, pixel.y, 0), indirect.at(pixel.x, pixel.y, 1),
                                        indirect.at(pixel.x, pixel.y, 2)));
        }
    }
    why.version = session.version();
    why.pose = session.pose();
    why.place = place;
    e.why = std::move(why);
}

}  // namespace lanthorn::edit_window
