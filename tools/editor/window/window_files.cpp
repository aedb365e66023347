// The files of an editor's window: which were open, which is, and what other programs do to it.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {
constexpr std::size_t kRecent = 10;
}

void EditorWindow::State::read_recent() {
    std::error_code error;
    if (const auto bytes = recent.read()) {
        std::string line;
        for (const char c : *bytes) {
            if (c == '\n') {
                if (std::filesystem::exists(line, error)) {
                    editor->recent.emplace_back(line);
                }
                line.clear();
            } else {
                line += c;
            }
        }
    }
}

void EditorWindow::State::keep_recent(const std::filesystem::path& file) {
    if (file.empty()) {
        return;
    }
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(file, error);
    std::erase(editor->recent, whole);
    editor->recent.insert(editor->recent.begin(), whole);
    editor->recent.resize(std::min(editor->recent.size(), kRecent));
    std::string bytes;
    for (const auto& each : editor->recent) {
        bytes += each.string() + "\n";
    }
    recent.write(bytes);
}

// Another file is shown than before.
void EditorWindow::State::scene_opened() {
    editor->sheet = Sheet::none;
    editor->problem.clear();
    editor->muted.clear();
    editor->solo.clear();
    editor->never_mind.clear();
    editor->why.reset();
    editor->wishes = {};
    editor->timeline = {};
    editor->solve = {};
    if (std::exchange(editor->solving, false)) {
        solver.stop();
    }
    editor->places.clear();
    editor->played.clear();
    editor->beside = {};
    why_light.forget();
    editor->error.reset();
    editor->other_side.reset();
    editor->gains.clear();
    editor->contracts.clear();
    shown_path = session.path();
    if (shown_path.empty()) {
        editor->views.forget("");  // those of the room before
    }
    watch.watch(shown_path);
    keep_recent(shown_path);
    if (!shown_path.empty()) {
        editor->open_folder =
            shown_path.parent_path().empty() ? editor->open_folder : shown_path.parent_path().string();
        editor->save_name = shown_path.filename().string();
    }
    editor->pace.forget();
    first_picture = true;
    viewport->look_from_session();
    settling = kSettlingFrames;
}

void EditorWindow::State::keep_views() {
    if (std::exchange(editor->views_changed, false)) {
        views.write(editor->views.text());
    }
}

void EditorWindow::State::keep_keymap() {
    if (kept_keymap != editor->keymap) {
        kept_keymap = editor->keymap;
        keys.write(std::string(name_of(kept_keymap)) + "\n");
    }
}

// Another program has written the file.
void EditorWindow::State::reload() {
    EditorState& e = *editor;
    try {
        if (session.changed_outside()) {
            const auto begun = std::chrono::steady_clock::now();
            const editor::Rebased done = session.reload();
            e.timeline.moved = true;  // it stays where it was
            const std::time_t clock = std::time(nullptr);
            std::tm local{};
            localtime_r(&clock, &local);
            e.reloaded = fmt::format("read again at {:02}:{:02}, {:.0f} ms", local.tm_hour, local.tm_min,
                                     ms_since(begun));
            e.say(fmt::format("{} has changed: read again{}", session.path().filename().string(),
                              session.is_dirty() ? fmt::format(", {} edits kept, {} no longer fit", done.kept,
                                                               done.left.size())
                                                 : ""),
                  now());
            e.problem.clear();
        }
    } catch (const Error& error) {
        e.problem = std::string(error.what()) + " (the last good scene is kept)";
    }
    e.pace.changed(now(), false);
    settling = kSettlingFrames;
}

void EditorWindow::State::follow_title() {
    const std::string name = session.path().empty() ? "new room" : session.path().filename().string();
    const std::string wanted =
        !session.is_open() ? "Lanthorn" : name + (editor->dirty ? " *" : "") + " - Lanthorn";
    if (wanted != title) {
        title = wanted;
        glfwSetWindowTitle(window.context().handle(), title.c_str());
    }
}

}  // namespace lanthorn::edit_window
