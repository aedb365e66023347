#include "tools/editor/window/editor_window.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/present_plugin.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {

shell::WindowOptions window_options(const EditorOptions& options) {
    return {.title = "Lanthorn",
            .size = options.size,
            .vsync = false,
            .loop = shell::Loop::on_events,
            .frame_ms = 0};
}

}  // namespace

EditorWindow::State::State(EditorOptions given)
    : options(std::move(given)),
      window(window_options(options)),
      overlay(window.context().handle()),
      input(window.context().handle()),
      session(options.session),
      report(options.report),
      watch([this] {
          woken = true;
          window.request_frame();
      }),
      recent(options.recent, "list of files", [](const std::string&) {}),
      views(options.recent.empty() ? options.recent : options.recent.parent_path() / "scene-views",
            "kept views",
            [this](const std::string& line) {
                if (editor) {
                    editor->problem = line;
                }
            }),
      keys(options.recent.empty() ? options.recent : options.recent.parent_path() / "editor-keys",
           "choice of keys",
           [this](const std::string& line) {
               if (editor) {
                   editor->problem = line;
               }
           }),
      alarm([this] { window.request_frame(); }),
      rest_watch([this] { window.request_frame(); }),
      wish_solver([this] { window.request_frame(); }),
      solver([this] { window.request_frame(); }),
      solver_alarm([this] { window.request_frame(); }),
      game([this] { window.request_frame(); }),
      costs_alarm([this] { window.request_frame(); }) {}

void EditorWindow::State::begin() {
    window.set_playing(false);  // the mouse stays free
    gi::declare_settings(schema);
    Settings settings(schema);
    const std::string preset =
        options.preset.empty() ? shell::usual_preset(window.info().software) : options.preset;
    settings.apply_preset(preset);
    settings.set_from_text("render.upscale", "temporal");  // while a hand drags and fewer pixels are drawn
    if (!options.technique.empty()) {
        settings.set_from_text("gi.technique", options.technique);
    }
    editor = std::make_unique<EditorState>(session, settings);
    editor->preset = preset;
    editor->refines = options.refine;
    editor->splits.drawer_open = !lay_out(options.size, 1, {}).low;
    editor->act = [this](Act what) { act(what); };
    editor->compare = [this](std::shared_ptr<const OtherSide> with) {
        editor->desk.act(
            [this, with = std::move(with)](editor::EditSession&) { viewport->compare(with, now()); });
        settling = kSettlingFrames;
    };
    editor->rest_watch = &rest_watch;
    editor->levels = options.levels;
    editor->cards = CardPictures(options.recent.empty() ? options.recent
                                                        : options.recent.parent_path() / "scene-pictures");
    editor->can_solve = options.solve != nullptr;
    editor->left_logs = options.session.recovery.empty() ? std::vector<editor::LeftLog>()
                                                         : editor::left_logs(options.session.recovery);
    float scale_x = 1, scale_y = 1;
    glfwGetWindowContentScale(window.context().handle(), &scale_x, &scale_y);
    editor->text_scale = options.text_scale > 0
                             ? options.text_scale
                             : std::clamp(static_cast<double>(scale_x), kSmallestText, kLargestText);
    std::error_code error;
    editor->open_folder = std::filesystem::current_path(error).string();
    read_recent();
    editor->views = views.read_as(KeptViews::parse);
    editor->keymap = kept_keymap = keys.read_as(keymap_named);
    viewport = std::make_unique<Viewport>(*editor);
    App& app = session.app();
    gi::add_picture_plugins(app, editor->settings);
    app.add<PresentPlugin>();
    if (!options.scene.empty()) {
        session.open(options.scene);
        if (options.opened) {
            options.opened(session);
        }
        scene_opened();
        if (!options.beside.empty()) {
            editor->show_beside(options.beside);
        }
        const auto is_ours = [&](const editor::LeftLog& log) { return log.edited == session.path(); };
        if (std::ranges::any_of(editor->left_logs, is_ours)) {
            editor->sheet = Sheet::start;  // edits of it were left behind: they are offered first
        }
    }
}

EditorWindow::EditorWindow(EditorOptions options) : state_(std::make_unique<State>(std::move(options))) {
    state_->begin();
}

EditorWindow::~EditorWindow() = default;

void EditorWindow::run() {
    while (turn()) {
    }
}

bool EditorWindow::asleep() const {
    return state_->asleep;
}

void EditorWindow::wake() {
    state_->window.request_frame();
}

const EditorState& EditorWindow::state() const {
    return *state_->editor;
}

bool EditorWindow::turn() {
    State& s = *state_;
    EditorState& e = *s.editor;
    if (!s.window.next_frame()) {
        return false;
    }
    const double now = s.now();
    s.take_events();
    const bool flies = s.viewport->move_on(now, now - s.last_turn, s.input);
    s.last_turn = now;
    s.settle();
    const ivec2 size = s.window.framebuffer_size();
    if (size.x > 0 && size.y > 0) {
        if (std::exchange(s.first_picture, false)) {
            // The window stands before the first picture does, which may take seconds.
            e.toast =
                s.session.is_open() ? "the first picture of " + s.session.path().filename().string() : "";
            e.toast_until = s.session.is_open() ? 1e18 : 0;
            s.draw_panels(false);
            s.window.flush();
            e.toast_until = 0;
        }
        if (s.input.urgent() && s.session.is_open() && (e.pace.due() || s.refines_now())) {
            // A click or a key is answered before a picture is begun.
            s.draw_panels(false);
            s.window.context().swap_buffers();
        }
        const double hand_at = e.pace.due() ? std::exchange(s.hand_at, 0) : 0;
        const int pictures = e.picture.frames();
        if (e.pace.due()) {
            s.draw_picture();
        } else if (s.refines_now()) {
            s.refine_picture();
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, size.x, size.y);
        s.draw_panels(false);
        if (hand_at > 0 && e.picture.frames() > pictures) {
            s.report.followed(1000 * (s.now() - hand_at));
        }
        const bool more = e.cards.next_turn();
        e.other_pictures += more ? 1 : 0;
        s.settling = std::max(more ? 1 : 0, s.settling - 1);
    }
    s.follow_rest();
    s.follow_wishes();
    s.follow_play();
    s.follow_solving();
    s.report.line(e);
    if (e.close) {
        s.window.close();
    }
    const bool draws = e.pace.due() && s.session.is_open() && size.x > 0;
    s.set_alarm();
    s.asleep = !flies && s.settling == 0 && !draws && !s.refines_now() && !e.desk.waiting() &&
               !s.input.dirty() && !e.close && !e.timeline.playing;
    if (!s.asleep) {
        s.window.request_frame();
    }
    return true;
}

}  // namespace lanthorn::edit_window
