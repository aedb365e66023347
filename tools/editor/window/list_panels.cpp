// History, warnings and settings.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "lanthorn/core/error.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

void draw_history(EditorState& state) {
    const std::vector<editor::HistoryRow> rows = state.session.history();
    static std::size_t shown = 0;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(6, 0));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), ImGui::GetFrameHeight());
    std::size_t current = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        current = rows[i].current ? i : current;
    }
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            const auto i = static_cast<std::size_t>(k);
            ImGui::PushID(k);
            const bool undone = i > current;
            ImGui::PushStyleColor(ImGuiCol_Text, undone ? colour::faint : colour::words);
            const std::string words = fmt::format("{} {}{}", rows[i].current ? ">" : "  ", rows[i].text,
                                                  rows[i].saved ? "   (saved)" : "");
            if (ImGui::Selectable(words.c_str(), rows[i].current, 0, {0, ImGui::GetFrameHeight()})) {
                state.desk.act([i](editor::EditSession& session) { session.go_to(i); });
                state.pace.changed(0, false);
            }
            ImGui::PopStyleColor();
            ImGui::PopID();
        }
    }
    clipper.End();
    if (shown != current) {
        shown = current;
        ImGui::SetScrollY(std::max(
            0.0f, ImGui::GetFrameHeight() * static_cast<float>(current) - ImGui::GetWindowHeight() / 2));
    }
    ImGui::PopStyleVar();
}

void draw_warnings(EditorState& state) {
    bool any = false;
    int id = 0;
    for (const editor::EditWarning& warning : state.warnings) {
        if (state.never_mind.contains(warning.kind)) {
            continue;
        }
        any = true;
        ImGui::PushID(id++);
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, colour::warning);
        ImGui::TextUnformatted("!");
        ImGui::PopStyleColor();
        ImGui::SameLine();
        if (warning.node != kNone) {
            if (ImGui::SmallButton("go to")) {
                state.reveal = warning.node;
                state.select({warning.node});
                state.act(Act::frame_selection);
            }
            ImGui::SameLine();
        }
        if (!warning.fix.empty()) {
            if (ImGui::SmallButton("fix")) {
                std::vector<std::string> lines;
                std::string rest = warning.fix;
                for (std::size_t at = 0; !rest.empty();) {
                    at = rest.find('\n');
                    lines.push_back(rest.substr(0, at));
                    rest = at == std::string::npos ? "" : rest.substr(at + 1);
                }
                if (lines.size() == 1) {
                    state.desk.act(
                        [line = lines.front()](editor::EditSession& session) { session.run(line); });
                    state.pace.changed(0, false);
                } else {
                    state.run("fix: " + warning.kind, std::move(lines));
                }
            }
            if (ImGui::IsItemHovered()) {
                ImGui::SetTooltip("%s", warning.fix.c_str());
            }
            ImGui::SameLine();
        }
        if (ImGui::SmallButton("never mind")) {
            state.never_mind.insert(warning.kind);
        }
        ImGui::SameLine();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(warning.text.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopID();
    }
    for (const editor::LeftCommand& left : state.session.left()) {
        any = true;
        ImGui::PushStyleColor(ImGuiCol_Text, colour::warning);
        ImGui::TextWrapped("kept aside: %s - %s", left.command.text.c_str(), left.why.c_str());
        ImGui::PopStyleColor();
    }
    for (const std::string& note : state.session.notes()) {
        any = true;
        ImGui::TextWrapped("on reading: %s", note.c_str());
    }
    if (!state.muted.empty() || !state.solo.empty() || state.exposure_locked) {
        any = true;
        ImGui::TextWrapped("This preview is not the game's: %s%s",
                           state.muted.empty() && state.solo.empty() ? "" : "lights are muted. ",
                           state.exposure_locked ? "The exposure is held." : "");
    }
    if (!any) {
        ImGui::TextDisabled("Nothing to warn of.");
    }
}

void draw_settings(EditorState& state) {
    ImGui::TextDisabled("How it is drawn here: preview only. Whole frame %.0f ms.", state.picture.facts().ms);
    ImGui::BeginChild("settings");
    const auto entry_reads = [&](const std::string& name) {
        const std::string technique = state.settings.text("gi.technique");
        return name.starts_with("render.") || name == "gi.bounces" || name == "gi.photons" ||
               name == "gi.accumulate" || name == "gi.target_error" ||
               name.starts_with("gi." + technique + ".") || name.starts_with("gi.specular") ||
               (technique == "emc" && name.starts_with("gi.gather."));
    };
    state.fields.begin(ImGui::GetContentRegionAvail().x * 0.5f, state.unit);
    std::vector<std::pair<std::string, std::string>> changes;
    for (const SettingInfo& info : state.settings.schema().all()) {
        if (!entry_reads(info.name)) {
            continue;
        }
        const std::string words = info.words + (info.cost.empty() ? "" : "\ncost: " + info.cost);
        const std::string now = state.settings.text(info.name);
        if (info.type == SettingType::boolean) {
            bool on = now == "true";
            if (state.fields.flag(info.name, on, words)) {
                changes.emplace_back(info.name, on ? "true" : "false");
            }
        } else if (info.type == SettingType::choice) {
            int chosen = static_cast<int>(std::ranges::find(info.choices, now) - info.choices.begin());
            if (state.fields.choice(info.name, info.choices, chosen, words)) {
                changes.emplace_back(info.name, info.choices[static_cast<std::size_t>(chosen)]);
            }
        } else {
            NumberRow row{.label = info.name, .value = std::atof(now.c_str()), .unit = info.unit};
            row.lower = info.lower;
            row.upper = info.upper;
            row.initial = info.initial;
            row.words = words;
            row.step = info.type == SettingType::integer ? 0.1 : 0.01;
            const NumberChange change = state.fields.number(row);
            if (change.doing == Doing::done) {
                changes.emplace_back(info.name, info.type == SettingType::integer
                                                    ? fmt::format("{:.0f}", change.value)
                                                    : fmt::format("{}", static_cast<float>(change.value)));
            }
        }
    }
    for (const auto& [name, value] : changes) {
        try {
            state.settings.set_from_text(name, value);
            state.settings_changed = true;
        } catch (const Error& error) {
            state.problem = error.what();
        }
    }
    ImGui::EndChild();
}

}  // namespace lanthorn::edit_window
