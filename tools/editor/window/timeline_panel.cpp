// The clips of the file: which is shown, and at which moment.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/editor/core/node_path.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

namespace {

std::string shown_name(const editor::ClipRow& clip) {
    return clip.name.empty() ? "clip " + clip.key : clip.name;
}

// The clips, those first that move what is chosen.
std::vector<const editor::ClipRow*> ordered(const EditorState& state, std::size_t& of_chosen) {
    std::vector<const editor::ClipRow*> rows;
    const auto moves_chosen = [&](const editor::ClipRow& clip) {
        return std::ranges::any_of(state.chosen, [&](std::uint32_t node) {
            return state.session.model().find(node) != nullptr && moves(clip, state.session.model(), node);
        });
    };
    for (const editor::ClipRow& clip : state.timeline.clips) {
        rows.push_back(&clip);
    }
    const auto others = std::stable_partition(rows.begin(), rows.end(),
                                              [&](const auto* clip) { return moves_chosen(*clip); });
    of_chosen = static_cast<std::size_t>(others - rows.begin());
    return rows;
}

void clip_choice(EditorState& state, const std::vector<const editor::ClipRow*>& rows, std::size_t of_chosen) {
    TimelineShown& line = state.timeline;
    const editor::ClipRow* shown = line.shown();
    ImGui::SetNextItemWidth(std::min(150 * state.unit, ImGui::GetContentRegionAvail().x));
    if (ImGui::BeginCombo("##clip", shown != nullptr ? shown_name(*shown).c_str() : "none")) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i == of_chosen && i > 0) {
                ImGui::Separator();
            }
            ImGui::PushID(static_cast<int>(i));
            const std::string words = fmt::format("{}  {:.2f} s", shown_name(*rows[i]), rows[i]->seconds);
            if (ImGui::Selectable(words.c_str(), rows[i] == shown)) {
                line.clip = rows[i]->key;
                line.go_to(0);
            }
            ImGui::PopID();
        }
        if (ImGui::Selectable("none", shown == nullptr)) {
            line.clip = "none";
            line.playing = false;
            line.go_to(0);
        }
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("which clip is shown here; the file is as it was");
    }
}

// A bar to drag on, with a mark for each key.
void scrub_bar(EditorState& state, const editor::ClipRow& clip) {
    TimelineShown& line = state.timeline;
    const float u = state.unit, height = 22 * u;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = std::max(40 * u, ImGui::GetContentRegionAvail().x);
    ImGui::InvisibleButton("scrub", {width, height});
    const float pad = 5 * u, inner = width - 2 * pad;
    const double length = std::max(1e-9, clip.seconds);
    if (ImGui::IsItemActive()) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - from.x - pad) / inner, 0.0f, 1.0f);
        // To whole frames: what one sees can be gone to again.
        const double frame = std::round(static_cast<double>(share) * length * clip.rate);
        if (ImGui::IsItemActivated() || frame / clip.rate != line.second()) {
            line.playing = false;
            line.go_to(frame / clip.rate);
        }
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = from.y + height / 2;
    list.AddRectFilled({from.x, from.y + 5 * u}, {from.x + width, from.y + height - 5 * u}, colour::bar);
    const auto at = [&](double second) { return from.x + pad + inner * static_cast<float>(second / length); };
    float last = -1e9f;
    for (const float key : clip.keys) {
        const float x = at(static_cast<double>(key));
        if (x - last >= 3 * u) {
            list.AddLine({x, middle - 3 * u}, {x, middle + 3 * u}, colour::faint);
            last = x;
        }
    }
    const float x = at(line.second());
    list.AddRectFilled({x - 1.5f * u, from.y}, {x + 1.5f * u, from.y + height}, colour::chosen);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("drag: another moment; ticks are keys");
    }
}

void start_choice(EditorState& state) {
    const TimelineShown& line = state.timeline;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("The file begins with");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(std::min(150 * state.unit, ImGui::GetContentRegionAvail().x));
    const auto found = std::ranges::find(line.clips, line.starts_with, &editor::ClipRow::key);
    std::optional<std::string> chosen;
    if (ImGui::BeginCombo("##start", found == line.clips.end() ? "none" : shown_name(*found).c_str())) {
        for (const editor::ClipRow& clip : line.clips) {
            if (ImGui::Selectable((shown_name(clip) + "##" + clip.key).c_str(),
                                  clip.key == line.starts_with)) {
                chosen = clip.key;
            }
        }
        if (ImGui::Selectable("none", line.starts_with == "none")) {
            chosen = "none";
        }
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("an edit: start_clip.clip of a node, which the game and `render` obey");
    }
    if (chosen && *chosen != line.starts_with) {
        state.run(fmt::format("begin with {}", *chosen), {start_clip_line(state.session, *chosen)});
        state.timeline.clip.reset();
        state.timeline.go_to(0);
    }
}

}  // namespace

void draw_timeline(EditorState& state) {
    TimelineShown& line = state.timeline;
    if (line.clips.empty()) {
        ImGui::TextDisabled("No clip in this file: nothing moves by itself.");
        ImGui::TextWrapped(
            "Clips come with a glTF: animate in Blender, export, and the file is read again here.");
        return;
    }
    std::size_t of_chosen = 0;
    const std::vector<const editor::ClipRow*> rows = ordered(state, of_chosen);
    const editor::ClipRow* clip = line.shown();
    ImGui::BeginDisabled(clip == nullptr);
    if (ImGui::Button("|<")) {
        line.playing = false;
        line.go_to(0);
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("to the beginning, which is what the file shows");
    }
    ImGui::SameLine(0, 2);
    if (ImGui::Button(line.playing ? "Pause" : "Play ", {52 * state.unit, 0})) {
        state.act(Act::play_clip);
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("Space");
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool narrow = ImGui::GetWindowContentRegionMax().x < 430 * state.unit;
    clip_choice(state, rows, of_chosen);
    if (!narrow) {
        ImGui::SameLine();
    }
    ImGui::SetNextItemWidth(64 * state.unit);
    if (ImGui::BeginCombo("##speed", fmt::format("{:g} x", line.speed).c_str())) {
        for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, -1.0}) {
            if (ImGui::Selectable(fmt::format("{:g} x", speed).c_str(), speed == line.speed)) {
                line.speed = speed;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(104 * state.unit);
    constexpr std::array kLoops = {"once", "loop", "there and back"};
    const auto loop = static_cast<std::size_t>(line.loop);
    if (ImGui::BeginCombo("##loop", kLoops.at(loop))) {
        for (std::size_t i = 0; i < kLoops.size(); ++i) {
            if (ImGui::Selectable(kLoops.at(i), i == loop)) {
                const double second = line.second();
                line.loop = static_cast<LoopMode>(i);
                line.time = second;
            }
        }
        ImGui::EndCombo();
    }
    if (clip != nullptr) {
        std::string when =
            fmt::format("{:.2f} of {:.2f} s   frame {} of {}", line.second(), clip->seconds,
                        std::lround(line.second() * clip->rate), std::lround(clip->seconds * clip->rate));
        const std::string rate = fmt::format(" ({:g} a second)", clip->rate);
        ImGui::SameLine();
        const float wide = ImGui::CalcTextSize((when + rate).c_str()).x;
        if (wide > ImGui::GetContentRegionAvail().x) {
            ImGui::NewLine();
        }
        when += wide > ImGui::GetContentRegionAvail().x ? "" : rate;
        ImGui::TextUnformatted(when.c_str());
        scrub_bar(state, *clip);
    }
    start_choice(state);
    if (!state.chosen.empty() && of_chosen == 0 &&
        state.session.model().find(state.chosen.front()) != nullptr) {
        ImGui::TextDisabled("No clip moves %s; these are the scene's.",
                            editor::called(state.session.model(), state.chosen.front()).c_str());
    } else if (clip != nullptr) {
        ImGui::TextDisabled("%s moves %zu node%s%s.", shown_name(*clip).c_str(), clip->nodes.size(),
                            clip->nodes.size() == 1 ? "" : "s",
                            of_chosen > 0 ? ", what is chosen among them" : "");
    }
}

}  // namespace lanthorn::edit_window
