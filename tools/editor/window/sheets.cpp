// What lies over the panels: the start, files, what saving changes, keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <ctime>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/sheets.h"

namespace lanthorn::edit_window {

namespace fs = std::filesystem;

bool begin_sheet(EditorState& state, const char* title, float width, float height) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(width * state.unit, window.x - 20),
                      std::min(height * state.unit, window.y - 20));
    ImGui::SetNextWindowPos({(window.x - size.x) / 2, (window.y - size.y) / 2});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(16 * state.unit, 12 * state.unit));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    const bool open =
        ImGui::Begin(title, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
    return open;
}

namespace {

// Folders and glTF files of a folder, by name.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
    std::vector<fs::directory_entry> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        const std::string ending = at->path().extension().string();
        std::error_code other;
        if (!name.starts_with('.') && (at->is_directory(other) || ending == ".glb" || ending == ".gltf")) {
            entries.push_back(*at);
        }
    }
    std::ranges::sort(entries, [](const fs::directory_entry& a, const fs::directory_entry& b) {
        std::error_code other;
        const bool da = a.is_directory(other), db = b.is_directory(other);
        return da != db ? da : a.path().filename() < b.path().filename();
    });
    return entries;
}

void draw_files(EditorState& state, bool saves) {
    begin_sheet(state, "files", 560, 420);
    ImGui::TextUnformatted(saves ? "Save as" : "Open");
    std::array<char, 1024> folder{};
    std::strncpy(folder.data(), state.open_folder.c_str(), folder.size() - 1);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::InputText("##folder", folder.data(), folder.size(), ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code error;
        if (fs::is_regular_file(folder.data(), error) && !saves) {
            state.open(folder.data());
        } else {
            state.open_folder = folder.data();
        }
    }
    const float below = ImGui::GetFrameHeight() * 2.6f;
    ImGui::BeginChild("list", {0, -below}, true);
    const fs::path here = state.open_folder;
    if (ImGui::Selectable("..  (up)") && here.has_parent_path()) {
        state.open_folder = here.parent_path().string();
    }
    for (const fs::directory_entry& entry : entries_of(here)) {
        std::error_code error;
        const bool is_folder = entry.is_directory(error);
        const std::string name = entry.path().filename().string() + (is_folder ? "/" : "");
        if (ImGui::Selectable(name.c_str(), !is_folder && state.save_name == entry.path().filename(),
                              ImGuiSelectableFlags_AllowDoubleClick)) {
            if (is_folder) {
                state.open_folder = entry.path().string();
            } else {
                state.save_name = entry.path().filename().string();
                if (!saves && ImGui::IsMouseDoubleClicked(0)) {
                    state.open(entry.path());
                }
            }
        }
    }
    ImGui::EndChild();
    std::array<char, 256> name{};
    std::strncpy(name.data(), state.save_name.c_str(), name.size() - 1);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    bool go = false;
    if (ImGui::InputText("##name", name.data(), name.size(), ImGuiInputTextFlags_EnterReturnsTrue)) {
        go = true;
    }
    state.save_name = name.data();
    if (ImGui::Button(saves ? "Save" : "Open") || go) {
        if (!state.save_name.empty()) {
            fs::path file = here / state.save_name;
            if (saves) {
                if (file.extension() != ".glb" && file.extension() != ".gltf") {
                    file += ".glb";
                }
                state.sheet = Sheet::none;
                state.desk.act([file](editor::EditSession& session) { session.save(file); });
            } else {
                state.open(file);
            }
        }
    }
    ImGui::SameLine();
    if (ImGui::Button("Back")) {
        state.sheet = state.session.is_open() ? Sheet::none : Sheet::start;
    }
    ImGui::End();
}

void draw_save(EditorState& state) {
    begin_sheet(state, "save", 640, 420);
    const std::string name = state.session.path().filename().string();
    if (!state.changes) {
        state.changes = state.session.changes();
    }
    const editor::TextChanges& changes = *state.changes;
    ImGui::TextUnformatted(
        fmt::format("Save {}: {}", name, editor::summary(changes, state.session.file_bytes())).c_str());
    ImGui::TextDisabled("All other bytes stay as they are in the file.");
    ImGui::BeginChild("lines", {0, -ImGui::GetFrameHeight() * 1.6f}, true);
    ImGui::PushFont(state.fonts.numbers);
    for (const editor::TextChanges::Line& line : changes.lines) {
        ImGui::PushStyleColor(ImGuiCol_Text, line.added ? colour::good : colour::bad);
        ImGui::TextUnformatted(
            fmt::format("{} {:>5}  {}", line.added ? '+' : '-', line.line, line.text).c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    ImGui::EndChild();
    const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
    if (ImGui::Button("Save (Enter)") || enter) {
        state.sheet = Sheet::none;
        state.changes.reset();
        state.desk.act([&state](editor::EditSession& session) {
            session.save();
            state.toast = "saved " + session.path().filename().string();
            state.toast_until = 1e18;
        });
    }
    ImGui::SameLine();
    if (ImGui::Button("Back (Esc)")) {
        state.sheet = Sheet::none;
        state.changes.reset();
    }
    ImGui::End();
}

void draw_changed_file(EditorState& state) {
    begin_sheet(state, "changed", 520, 150);
    ImGui::TextWrapped(
        "%s is another on disk than when it was opened, and there are edits that are not saved.",
        state.session.path().filename().c_str());
    ImGui::Spacing();
    if (ImGui::Button("Do my edits on theirs")) {
        state.sheet = Sheet::none;
        state.desk.act([&state](editor::EditSession& session) {
            const editor::Rebased done = session.reload();
            state.toast_until = 1e18;
            state.toast =
                fmt::format("read again: {} edits kept, {} no longer fit", done.kept, done.left.size());
        });
    }
    ImGui::SameLine();
    if (ImGui::Button("Write mine over it")) {
        state.sheet = Sheet::none;
        state.desk.act([](editor::EditSession& session) { session.save(); });
    }
    ImGui::SameLine();
    if (ImGui::Button("Both: save mine beside it")) {
        state.sheet = Sheet::none;
        state.desk.act([](editor::EditSession& session) {
            fs::path mine = session.path();
            mine.replace_filename(mine.stem().string() + "-mine" + mine.extension().string());
            session.save(mine);
        });
    }
    if (ImGui::Button("Back")) {
        state.sheet = Sheet::none;
    }
    ImGui::End();
}

void draw_help(EditorState& state) {
    begin_sheet(state, "help", 640, 500);
    ImGui::TextUnformatted("Keys");
    ImGui::SameLine();
    ImGui::TextDisabled("F1 or Esc closes this");
    ImGui::BeginChild("keys", {0, 0}, false);
    if (ImGui::BeginTable("table", 4)) {
        const auto line = [](const std::string& key, const char* words) {
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, colour::chosen);
            ImGui::TextUnformatted(key.c_str());
            ImGui::PopStyleColor();
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", words);
        };
        line("Alt+left, middle", "orbit");
        line("Shift+middle", "pan");
        line("wheel", "nearer, farther");
        line("right + WASD QE", "fly; wheel: speed, Shift: fast");
        line("click, Ctrl+click", "choose, add; again: what lies behind");
        line("drag on nothing", "choose what is in the frame");
        for (const KeyBinding& binding : bindings(state.keymap)) {
            line(key_name(binding), binding.words);
        }
        ImGui::EndTable();
    }
    ImGui::EndChild();
    ImGui::End();
}

void draw_quit(EditorState& state) {
    begin_sheet(state, "quit", 420, 110);
    ImGui::TextWrapped("There are edits that are not saved. They are kept, and offered at the next start.");
    ImGui::Spacing();
    if (ImGui::Button("Quit")) {
        state.close = true;
    }
    ImGui::SameLine();
    if (ImGui::Button("Back")) {
        state.sheet = Sheet::none;
    }
    ImGui::End();
}

}  // namespace

void draw_sheet(EditorState& state) {
    switch (state.sheet) {
        case Sheet::none:
            return;
        case Sheet::start:
            draw_start(state);
            return;
        case Sheet::open:
            draw_files(state, false);
            return;
        case Sheet::save_as:
            draw_files(state, true);
            return;
        case Sheet::save:
            draw_save(state);
            return;
        case Sheet::file_changed:
            draw_changed_file(state);
            return;
        case Sheet::help:
            draw_help(state);
            return;
        case Sheet::quit:
            draw_quit(state);
            return;
    }
}

}  // namespace lanthorn::edit_window
