// "Why is this light here?": the card.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/editor/window/panels.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::edit_window {

using reference::LampPart;
using reference::LightKind;
using reference::LightSplit;
using reference::Straight;
using workbench::hidden_words;
using workbench::lamp_name;
using workbench::lux_text;
using workbench::straight_words;

namespace {

constexpr double kWorthSaying = 0.002;  // share of the sum
constexpr double kHardly = 0.02;        // of it: reflections that are told as one
constexpr int kMostHidden = 4, kMostSurfaces = 6;

double whole(const LightSplit& split) {
    return split.direct.value() + split.reflected.value() + split.sky.value();
}

// "12.3 lx on floor: direct 4.1, reflected once 6.2, twice 1.8, sky 0.2 (emc shows 7.9 of 8.2 indirect)".
std::string heading(const WhyShown& why) {
    const LightSplit& split = why.answer.split;
    std::string words = fmt::format("{} lx on {}: direct {}", lux_text(whole(split)),
                                    why.name(why.answer.point.entity), lux_text(split.direct.value()));
    std::vector<double> reflected;
    for (const LampPart& lamp : split.lamps) {
        reflected.resize(std::max(reflected.size(), lamp.reflected.size()));
        for (std::size_t n = 0; n < lamp.reflected.size(); ++n) {
            reflected[n] += lamp.reflected[n].value();
        }
    }
    for (std::size_t n = 0; n < reflected.size(); ++n) {
        const double rest =
            std::accumulate(reflected.begin() + static_cast<std::ptrdiff_t>(n), reflected.end(), 0.0);
        if (n > 1 && rest < kHardly * whole(split)) {
            words += ", more often " + lux_text(rest);
            break;
        }
        words += fmt::format(", {} {}",
                             n == 0   ? "reflected once"
                             : n == 1 ? "twice"
                                      : fmt::format("{} times", n + 1),
                             lux_text(reflected[n]));
    }
    if (split.sky.value() > 0) {
        words += ", sky " + lux_text(split.sky.value());
    }
    if (why.shown >= 0) {
        words += fmt::format("; {} shows {} of {} +- {} indirect", why.technique, lux_text(why.shown),
                             lux_text(split.indirect().value()), lux_text(split.indirect().noise));
    }
    return words;
}

// A row that selects what it speaks of.
bool row(EditorState& state, std::uint32_t node, const std::string& words, ImU32 shade) {
    ImGui::PushStyleColor(ImGuiCol_Text, shade);
    const bool pressed = ImGui::Selectable(words.c_str(), node != kNone && state.selected(node));
    ImGui::PopStyleColor();
    if (pressed && node != kNone) {
        state.reveal = node;
        state.select({node});
    }
    return ImGui::IsItemHovered();
}

void draw_lamps(EditorState& state, const WhyShown& why) {
    const LightSplit& split = why.answer.split;
    const double sum = whole(split);
    for (const LampPart& lamp : split.lamps) {
        const bool punctual = lamp.source.kind == LightKind::punctual;
        if (!punctual && lamp.sum.value() < kWorthSaying * sum) {
            continue;
        }
        double reflected = 0;
        for (const reference::Lux& lux : lamp.reflected) {
            reflected += lux.value();
        }
        std::string words = fmt::format("{:>8} lx {:>3.0f} %  {}: ", lux_text(lamp.sum.value()),
                                        sum > 0 ? 100 * lamp.sum.value() / sum : 0,
                                        lamp_name(lamp.source, lamp.entity, why.name));
        if (lamp.straight == Straight::lit) {
            words += "direct " + lux_text(lamp.direct.value()) + ", ";
        } else if (punctual) {
            words += fmt::format("{}, ", straight_words(lamp.straight));
        }
        words += "reflected " + lux_text(reflected);
        row(state, why.node_of(lamp.entity), words, lamp.sum.value() > 0 ? colour::words : colour::faint);
    }
    int count = 0;
    for (const reference::HiddenPart& hidden : split.hidden) {
        if (++count <= kMostHidden && hidden.direct.value() + hidden.reflected.value() >= 0.01 * sum) {
            std::string without;
            for (const std::uint32_t entity : hidden.occluders) {
                without += (without.empty() ? "" : " and ") + why.name(entity);
            }
            const std::string words = fmt::format("{:>8} lx more:  {} without {}",
                                                  lux_text(hidden.direct.value() + hidden.reflected.value()),
                                                  lamp_name(hidden.source, hidden.entity, why.name), without);
            ImGui::PushID(count);
            if (row(state, why.node_of(hidden.occluders.front()), words, colour::warning)) {
                ImGui::SetTooltip("%s", hidden_words(hidden, why.name).c_str());
            }
            ImGui::PopID();
        }
    }
}

void draw_ways(EditorState& state, WhyShown& why) {
    const LightSplit& split = why.answer.split;
    int pointed = -1;
    for (std::size_t i = 0; i < split.ways.size(); ++i) {
        const reference::LightWay& way = split.ways[i];
        std::string words =
            fmt::format("{:>8} lx  {} > ", lux_text(way.lux), lamp_name(way.source, way.entity, why.name));
        for (auto entity = way.entities.rbegin(); entity != way.entities.rend(); ++entity) {
            words += why.name(*entity) + " > ";
        }
        words += "here";
        ImGui::PushID(static_cast<int>(i));
        if (row(state, way.entities.empty() ? kNone : why.node_of(way.entities.front()), words,
                colour::words)) {
            pointed = static_cast<int>(i);
        }
        ImGui::PopID();
    }
    why.pointed_way = pointed;
}

}  // namespace

void draw_why(EditorState& state) {
    if (!state.why) {
        ImGui::TextDisabled(
            "Point at a surface and press %s: where its light comes from, and what is in the way.",
            key_name(state.keymap, Act::why_light).c_str());
        return;
    }
    WhyShown& why = *state.why;
    const bool old = why.version != state.session.version();
    ImGui::PushStyleColor(ImGuiCol_Text, old ? colour::faint : colour::words);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(((old ? "was, before the last edit: " : "") + heading(why)).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    std::string from;
    const double reflected = why.answer.split.reflected.value();
    int count = 0;
    for (const reference::SurfacePart& surface : why.answer.split.surfaces) {
        if (++count <= kMostSurfaces && reflected > 0 && surface.reflected.value() >= 0.01 * reflected) {
            from += fmt::format("{}{} {:.0f} %", from.empty() ? "reflected by " : ", ",
                                why.name(surface.entity), 100 * surface.reflected.value() / reflected);
        }
    }
    if (!from.empty()) {
        ImGui::TextDisabled("%s", from.c_str());
    }
    if (ImGui::BeginTable("why", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("lamps", 0, 1.3f);
        ImGui::TableSetupColumn("ways", 0, 1);
        ImGui::TableNextColumn();
        draw_lamps(state, why);
        ImGui::TableNextColumn();
        draw_ways(state, why);
        ImGui::EndTable();
    }
}

}  // namespace lanthorn::edit_window
