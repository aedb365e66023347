#include "tools/editor/window/editor_window.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <utility>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/shell/kept_file.h"
#include "lanthorn/shell/window.h"
#include "lanthorn/ui/overlay.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"
#include "tools/editor/core/same_as_game.h"
#include "tools/editor/window/edit_report.h"
#include "tools/editor/window/editor_state.h"
#include "tools/editor/window/file_watch.h"
#include "tools/editor/window/input_queue.h"
#include "tools/editor/window/panels.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

using editor::EditSession;
using editor::EditStep;

namespace {

constexpr int kSettlingFrames = 3;    // of the panels after something happened: popups need two to size
constexpr double kMovesEvery = 0.03;  // seconds between panels drawn in a 3D frame for a pointer that moved
constexpr double kSmallestText = 0.75, kLargestText = 2;
constexpr std::size_t kRecent = 10;
constexpr double kMostPixelsOnCpu = 1280 * 720;  // of a picture

double ms_since(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

shell::WindowOptions window_options(const EditorOptions& options) {
    return {.title = "Lanthorn",
            .size = options.size,
            .vsync = false,
            .loop = shell::Loop::on_events,
            .frame_ms = 0};
}

// OpenGL's state that Dear ImGui's drawing expects and does not keep: for panels that are drawn between two
// passes of a frame.
class KeptState {
  public:
    KeptState() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask_);
        srgb_ = glIsEnabled(GL_FRAMEBUFFER_SRGB);
        discard_ = glIsEnabled(GL_RASTERIZER_DISCARD);
        scissor_ = glIsEnabled(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_RASTERIZER_DISCARD);
        glDisable(GL_SCISSOR_TEST);
    }
    ~KeptState() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
        glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
        enable(GL_FRAMEBUFFER_SRGB, srgb_);
        enable(GL_RASTERIZER_DISCARD, discard_);
        enable(GL_SCISSOR_TEST, scissor_);
    }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;

  private:
    static void enable(GLenum what, GLboolean on) { on == GL_TRUE ? glEnable(what) : glDisable(what); }
    GLint draw_ = 0, read_ = 0;
    GLboolean mask_[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    GLboolean srgb_ = GL_FALSE, discard_ = GL_FALSE, scissor_ = GL_FALSE;
};

}  // namespace

struct EditorWindow::State {
    explicit State(EditorOptions given)
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
          recent(options.recent, "list of files", [](const std::string&) {}) {}

    EditorOptions options;
    shell::Window window;
    ui::Overlay overlay;
    InputQueue input;
    SettingsSchema schema;
    EditSession session;
    std::unique_ptr<EditorState> editor;
    std::unique_ptr<Viewport> viewport;
    EditReport report;
    std::atomic<bool> woken{false};
    FileWatch watch;
    shell::KeptFile recent;

    int settling = kSettlingFrames;      // frames of the panels that are due
    bool popup = false, typing = false;  // as of the last frame of the panels
    double last_ui = 0, last_turn = 0;
    bool first_picture = true, asleep = false;
    double hand_at = 0;  // when the hand did what the next picture shows; 0: nothing
    std::filesystem::path shown_path;
    std::string title;
    bool dimmed_any = false;
    std::filesystem::path drop_again;

    void begin();
    void act(Act act);
    void take_events();
    void take_key(const Happening& happening);
    void settle();
    void scene_opened();
    void apply_preview();
    void draw_picture();
    void breathe();
    void draw_panels(bool in_frame);
    void make_panels();
    void clear_grounds() const;
    std::vector<std::pair<Box, ImU32>> grounds;  // of the panels of this frame
    void keep_recent(const std::filesystem::path& file);
    void follow_title();
    void check_game();
    double now() const { return glfwGetTime(); }
};

void EditorWindow::State::begin() {
    window.set_playing(false);  // the mouse stays free
    gi::declare_settings(schema);
    Settings settings(schema);
    const std::string preset =
        options.preset.empty() ? shell::usual_preset(window.info().software) : options.preset;
    settings.apply_preset(preset);
    if (!options.technique.empty()) {
        settings.set_from_text("gi.technique", options.technique);
    }
    editor = std::make_unique<EditorState>(session, settings);
    editor->preset = preset;
    editor->splits.drawer_open = !lay_out(options.size, 1, {}).low;
    editor->act = [this](Act what) { act(what); };
    editor->levels = options.levels;
    editor->left_logs = options.session.recovery.empty() ? std::vector<editor::LeftLog>()
                                                         : editor::left_logs(options.session.recovery);
    float scale_x = 1, scale_y = 1;
    glfwGetWindowContentScale(window.context().handle(), &scale_x, &scale_y);
    editor->text_scale = options.text_scale > 0
                             ? options.text_scale
                             : std::clamp(static_cast<double>(scale_x), kSmallestText, kLargestText);
    std::error_code error;
    editor->open_folder = std::filesystem::current_path(error).string();
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
    viewport = std::make_unique<Viewport>(*editor);
    App& app = session.app();
    gi::add_picture_plugins(app, editor->settings);
    app.add<PresentPlugin>();
    if (!options.scene.empty()) {
        session.open(options.scene);
        scene_opened();
        const auto is_ours = [&](const editor::LeftLog& log) { return log.edited == session.path(); };
        if (std::ranges::any_of(editor->left_logs, is_ours)) {
            editor->sheet = Sheet::start;  // edits of it were left behind: they are offered first
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
    shown_path = session.path();
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

void EditorWindow::State::act(Act what) {
    EditorState& e = *editor;
    const double at = now();
    if (what == Act::none || viewport->act(what, at)) {
        return;
    }
    const auto view = [&](const char* name) {
        e.picture.set_view(e.picture.view() == name ? "final" : name);
        e.pace.changed(at, false);
    };
    const auto paths = [&](const char* command) {
        std::vector<std::string> lines;
        for (const std::uint32_t node : e.chosen) {
            const bool within = std::ranges::any_of(e.chosen, [&](std::uint32_t other) {
                return other != node && session.model().is_within(node, other);
            });
            if (session.model().find(node) != nullptr && !within) {
                lines.push_back(fmt::format("{} {}", command, editor::word(session.path_of(node))));
            }
        }
        return lines;
    };
    const auto step = [&](bool back) {
        e.desk.act([&e, back, this](EditSession& edited) {
            const EditStep* done = back ? edited.undo() : edited.redo();
            e.say(done == nullptr ? (back ? "nothing to undo" : "nothing to redo")
                                  : fmt::format("{}: {}", back ? "undid" : "did again", done->text),
                  now());
            e.pace.changed(now(), false);
        });
    };
    const bool open = session.is_open();
    switch (what) {
        case Act::undo:
            if (open) {
                step(true);
            }
            break;
        case Act::redo:
            if (open) {
                step(false);
            }
            break;
        case Act::duplicate:
        case Act::group: {
            std::vector<std::string> lines = paths("duplicate");
            if (lines.empty()) {
                break;
            }
            if (what == Act::group) {
                std::string all = "group group";
                for (const std::uint32_t node : e.chosen) {
                    all += " " + editor::word(session.path_of(node));
                }
                lines = {all};
            }
            e.run(what == Act::group ? "group" : "duplicate", std::move(lines));
            e.desk.act([&e](EditSession& edited) {
                std::vector<std::uint32_t> made;
                const auto& steps = edited.steps();
                if (steps.position() > 0) {
                    for (const editor::Command& command : steps.steps()[steps.position() - 1].commands) {
                        if (!command.made.empty()) {
                            made.push_back(command.made.front());
                        }
                    }
                }
                edited.select(made);
                e.reveal = made.empty() ? kNone : made.back();
            });
            break;
        }
        case Act::remove:
            if (!e.chosen.empty()) {
                e.run(fmt::format("delete {}", e.chosen.size() == 1
                                                   ? editor::called(session.model(), e.chosen.front())
                                                   : fmt::format("{} things", e.chosen.size())),
                      paths("delete"));
                e.select({});
            }
            break;
        case Act::hide:
            if (!e.chosen.empty()) {
                e.run("hide", paths("hide"));
            }
            break;
        case Act::show_all: {
            std::vector<std::string> lines;
            for (const std::uint32_t node : session.model().in_order()) {
                if (!session.model().node(node).visible) {
                    lines.push_back("show " + editor::word(session.path_of(node)));
                }
            }
            if (!lines.empty()) {
                e.run("show all", std::move(lines));
            }
            break;
        }
        case Act::helpers:
            e.helpers = !e.helpers;
            break;
        case Act::save:
            if (open) {
                e.changes.reset();
                e.sheet = session.path().empty()      ? Sheet::save_as
                          : session.changed_outside() ? Sheet::file_changed
                                                      : Sheet::save;
                if (e.sheet == Sheet::save && !e.dirty) {
                    e.sheet = Sheet::none;
                    e.say("nothing to save: the file is as it was", at);
                }
            }
            break;
        case Act::save_as:
            if (open) {
                e.sheet = Sheet::save_as;
            }
            break;
        case Act::open:
            e.sheet = Sheet::open;
            e.save_name.clear();
            break;
        case Act::new_room:
            e.sheet = Sheet::none;
            e.desk.act([this](EditSession& edited) {
                edited.new_room();
                editor->opened = true;
            });
            break;
        case Act::quit:
            open&& e.dirty ? void(e.sheet = Sheet::quit) : void(e.close = true);
            break;
        case Act::select_all:
            e.select(session.model().in_order());
            break;
        case Act::deselect:
            if (e.fields.dragging()) {
                e.fields.let_go();
            } else if (e.desk.gesture() || viewport->gesture()) {
                viewport->cancel();
            } else if (e.sheet != Sheet::none && open) {
                e.sheet = Sheet::none;
            } else if (!e.problem.empty()) {
                e.problem.clear();
            } else {
                e.select({});
            }
            break;
        case Act::view_final:
            view("final");
            break;
        case Act::view_direct:
            view("direct");
            break;
        case Act::view_indirect:
            view("indirect");
            break;
        case Act::view_albedo:
            view("albedo");
            break;
        case Act::view_normals:
            view("normals");
            break;
        case Act::view_depth:
            view("depth");
            break;
        case Act::view_lux:
            view("lux");
            break;
        case Act::view_coverage:
        case Act::view_next_debug: {
            const gi::TechniqueEntry* entry = gi::find_technique(e.settings.text("gi.technique"));
            if (entry == nullptr || entry->debug_views.empty()) {
                e.say("this technique has no views of its own", at);
                break;
            }
            const auto& views = entry->debug_views;
            auto found = std::ranges::find(views, what == Act::view_coverage ? "coverage" : e.picture.view(),
                                           &gi::DebugView::name);
            if (what == Act::view_next_debug) {
                found = found == views.end() || found + 1 == views.end() ? views.begin() : found + 1;
            }
            if (found == views.end()) {
                e.say("this technique has no view of that kind", at);
                break;
            }
            view(found->name.c_str());
            break;
        }
        case Act::lock_exposure: {
            const Renderer& renderer = session.world().resource<Renderer>();
            if (!e.exposure_locked && renderer.frame) {
                const float stops = e.settings.get<float>("render.exposure.compensation");
                e.locked_ev =
                    std::log2(std::exp2(stops) / (1.2f * std::max(1e-12f, renderer.frame->exposure())));
            }
            e.exposure_locked = !e.exposure_locked && renderer.frame;
            e.settings_changed = true;
            break;
        }
        case Act::only_picture:
            e.splits.only_picture = !e.splits.only_picture;
            e.pace.changed(at, false);
            break;
        case Act::help:
            e.sheet = e.sheet == Sheet::help ? Sheet::none : Sheet::help;
            break;
        case Act::larger_text:
        case Act::smaller_text:
        case Act::usual_text:
            e.text_scale = what == Act::usual_text
                               ? 1
                               : std::clamp(e.text_scale + (what == Act::larger_text ? 0.25 : -0.25),
                                            kSmallestText, kLargestText);
            e.fonts_changed = true;
            break;
        case Act::check_game:
            if (open) {
                e.desk.act([this](EditSession&) { check_game(); });
            }
            break;
        case Act::screenshot:
            e.desk.act([this](EditSession&) {
                draw_panels(false);
                editor->say("kept " + window.keep_screenshot("lanthorn").string(), now());
            });
            break;
        default:
            break;
    }
    settling = kSettlingFrames;
}

void EditorWindow::State::take_key(const Happening& happening) {
    EditorState& e = *editor;
    const Act what = act_of(happening.code, happening.modifiers);
    if (what == Act::deselect) {
        act(what);
        return;
    }
    // What is typed is not meant for the picture; nor is what a sheet lies over.
    if (typing ||
        (e.sheet != Sheet::none && what != Act::help && what != Act::quit && what != Act::larger_text &&
         what != Act::smaller_text && what != Act::open && what != Act::new_room)) {
        return;
    }
    act(what);
}

void EditorWindow::State::take_events() {
    EditorState& e = *editor;
    while (const auto happening = input.next()) {
        settling = kSettlingFrames;
        const bool over =
            !popup && e.sheet == Sheet::none && session.is_open() && e.layout.picture.contains(happening->at);
        if (happening->kind == Happening::Kind::drop) {
            if (!happening->files.empty()) {
                const std::filesystem::path file = happening->files.front();
                if (session.is_open() && e.dirty && drop_again != file) {
                    drop_again = file;
                    e.say("there are unsaved edits: drop it once more to open it all the same", now());
                } else {
                    drop_again.clear();
                    e.open(file);
                }
            }
            continue;
        }
        if (over && happening->kind == Happening::Kind::press && e.game_button.contains(happening->at)) {
            act(Act::check_game);
            continue;
        }
        const bool was_gesture = viewport->gesture();
        if ((happening->kind != Happening::Kind::key || !typing) && viewport->take(*happening, over)) {
            if (viewport->gesture() && was_gesture && e.desk.waiting() && hand_at == 0) {
                hand_at = happening->time;
            }
            continue;
        }
        if (happening->kind == Happening::Kind::key) {
            take_key(*happening);
        }
    }
}

// What the preview has beside the scene: settings, held exposure, muted lights.
void EditorWindow::State::apply_preview() {
    EditorState& e = *editor;
    if (std::exchange(e.settings_changed, false)) {
        Settings shown = e.settings;
        if (e.exposure_locked) {
            try {
                shown.set_from_text("render.exposure.mode", "manual");
                shown.set_from_text("render.exposure.ev100", fmt::format("{}", e.locked_ev));
            } catch (const Error& error) {
                e.problem = error.what();
            }
        }
        gi::apply_settings(session.app(), shown);
        e.pace.forget();
    }
    if (!session.is_open() || (e.muted.empty() && e.solo.empty() && !dimmed_any)) {
        return;
    }
    // Muted lights are dark in the world, and the session's model knows nothing of it.
    dimmed_any = !e.muted.empty() || !e.solo.empty();
    ecs::World& world = session.world();
    for (const editor::LightRow& row : e.lights) {
        const Light* light = editor::light_of(session.model(), row.node);
        const ecs::Entity entity = light != nullptr ? session.entity_of(row.node) : ecs::kNullEntity;
        const LightComponent* now_shown =
            entity && world.alive(entity) ? world.try_get<LightComponent>(entity) : nullptr;
        if (now_shown == nullptr) {
            continue;
        }
        Light wanted = *light;
        if (e.solo.empty() ? e.muted.contains(row.node) : !e.solo.contains(row.node)) {
            wanted.intensity = 0;
        }
        if (!(now_shown->light == wanted)) {
            world.insert(entity, LightComponent{wanted});
        }
    }
}

// Between two frames: does what was asked for.
void EditorWindow::State::settle() {
    EditorState& e = *editor;
    if (woken.exchange(false) && watch.happened() && session.is_open() && !session.path().empty()) {
        try {
            if (session.changed_outside()) {
                const auto begun = std::chrono::steady_clock::now();
                const editor::Rebased done = session.reload();
                const std::time_t clock = std::time(nullptr);
                std::tm local{};
                localtime_r(&clock, &local);
                e.reloaded = fmt::format("read again at {:02}:{:02}, {:.0f} ms", local.tm_hour, local.tm_min,
                                         ms_since(begun));
                e.say(fmt::format("{} has changed: read again{}", session.path().filename().string(),
                                  session.is_dirty() ? fmt::format(", {} edits kept, {} no longer fit",
                                                                   done.kept, done.left.size())
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
    if (e.desk.waiting()) {
        e.desk.apply(session, [&](const std::string& line) { e.problem = line; });
        if (!session.in_gesture()) {
            e.dirty = session.is_open() && session.is_dirty();  // a save changes no version
        }
        settling = kSettlingFrames;
        if (e.toast_until > 1e17) {
            e.toast_until = now() + 4;
        }
    }
    if (std::exchange(e.opened, false)) {
        scene_opened();
    } else if (session.is_open() && session.path() != shown_path) {
        // Saved under another name: all that is looked at stays.
        shown_path = session.path();
        watch.watch(shown_path);
        keep_recent(shown_path);
    }
    e.read();
    apply_preview();
    follow_title();
}

// Draws what would be saved by a fresh App, and compares.
void EditorWindow::State::check_game() {
    EditorState& e = *editor;
    if (!e.muted.empty() || !e.solo.empty() || e.exposure_locked) {
        e.say("not the game's light: lights are muted or the exposure is held", now());
        return;
    }
    session.world().resource_mut<PresentTarget>().size = ivec2(0);
    const editor::SameAsGame found = editor::same_as_game(session, e.settings, {e.picture.facts().size, 4});
    window.context().make_current();
    e.game_same = found.same();
    e.game_words = found.same() ? fmt::format("= game {:06x}", found.game.final & 0xffffffu)
                                : fmt::format("not the game's: {} differs", found.first_difference);
    e.game_version = session.version();
    e.game_pose = session.pose();
    e.settings_changed = true;
    e.pace.changed(now(), false);
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

void EditorWindow::State::draw_picture() {
    EditorState& e = *editor;
    const Box& box = e.layout.picture;
    if (box.empty() || !session.is_open()) {
        return;
    }
    const double at = now();
    const Quality quality = e.pace.quality(at);
    const double scale = e.pace.scale(at);
    glm::dvec2 whole(box.width, box.height);
    if (window.info().software) {  // of more, a frame takes seconds
        whole *= std::min(1.0, std::sqrt(kMostPixelsOnCpu / (whole.x * whole.y)));
    }
    const ivec2 size = glm::max(ivec2(glm::round(scale * whole)), 16);
    const double shows_hand = std::exchange(hand_at, 0);
    try {
        const double changed = e.picture.draw(session.app(), size, [this] { breathe(); });
        PictureFacts& facts = e.picture.facts();
        facts.changed = changed;
        facts.quality = quality;
        facts.technique = e.settings.text("gi.technique");
        facts.preset = e.preset;
        e.pace.drew(quality, scale, facts.ms, changed);
        if (!e.pace.due()) {
            facts.quality = e.pace.quality(now());
        }
        viewport->picture_drawn();
        if (!e.pace.due() && e.settings.text("gi.technique") != "path") {
            viewport->read_light();
        }
        if (shows_hand > 0) {
            report.followed(1000 * (now() - shows_hand));
        }
    } catch (const Error& error) {
        e.problem = error.what();
        for (int i = 0; i < Pace::kFewest; ++i) {  // no picture comes of it: none is due
            e.pace.drew(Quality::rest, 1, 0, 0);
        }
    }
}

// In the middle of a frame, between two passes: answers what has happened over the picture before.
void EditorWindow::State::breathe() {
    glfwPollEvents();
    const bool moved = input.dirty() && now() - last_ui > kMovesEvery;
    if (!input.urgent() && !moved) {
        return;
    }
    try {
        take_events();
        const KeptState kept;
        draw_panels(true);
        window.context().swap_buffers();
    } catch (const std::exception& error) {
        editor->problem = error.what();
    }
}

void EditorWindow::State::make_panels() {
    EditorState& e = *editor;
    const float u = e.unit;
    const auto panel = [&](const char* name, const Box& box, ImU32 ground, auto&& fill, bool padded = true) {
        if (box.empty()) {
            return;
        }
        ImGui::SetNextWindowPos({box.x, box.y});
        ImGui::SetNextWindowSize({box.width, box.height});
        grounds.emplace_back(box, ground);
        if (!padded) {
            ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(6 * u, 2 * u));
        }
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                         ImGuiWindowFlags_NoBackground | (padded ? 0 : ImGuiWindowFlags_NoScrollWithMouse));
        if (!padded) {
            ImGui::PopStyleVar();
        }
        fill();
        ImGui::End();
    };
    const auto splitter = [&](const char* name, const Box& box, bool upright, float& size, float sign,
                              float usual) {
        if (box.empty()) {
            return;
        }
        ImGui::SetNextWindowPos({box.x, box.y});
        ImGui::SetNextWindowSize({box.width, box.height});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
        ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::bar);
        ImGui::Begin(
            name, nullptr,
            ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
        ImGui::InvisibleButton("grip", {box.width, box.height});
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        }
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
            size = usual;
            e.pace.changed(now(), false);
        } else if (ImGui::IsItemActive()) {
            const ImVec2 way = ImGui::GetIO().MouseDelta;
            const float by = sign * (upright ? way.x : way.y) / u;
            if (by != 0) {
                size += by;
                e.pace.changed(now(), true);
            }
        }
        ImGui::End();
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(2);
    };
    const Splits usual;
    grounds.clear();
    panel("picture", e.layout.picture, colour::surround, [&] { viewport->draw(now()); });
    panel(
        "toolbar", e.layout.toolbar, colour::bar, [&] { draw_toolbar(e); }, false);
    if (e.layout.narrow) {
        panel("side", e.layout.right, colour::panel, [&] {
            if (ImGui::BeginTabBar("tabs")) {
                if (ImGui::BeginTabItem("Scene")) {
                    draw_tree(e);
                    ImGui::EndTabItem();
                }
                if (ImGui::BeginTabItem("Inspector")) {
                    ImGui::BeginChild("inspector");
                    draw_inspector(e);
                    ImGui::EndChild();
                    ImGui::EndTabItem();
                }
                if (ImGui::BeginTabItem("History")) {
                    ImGui::BeginChild("history");
                    draw_history(e);
                    ImGui::EndChild();
                    ImGui::EndTabItem();
                }
                ImGui::EndTabBar();
            }
        });
    } else {
        panel("tree", e.layout.left, colour::panel, [&] { draw_tree(e); });
        panel("history", e.layout.history, colour::panel, [&] {
            ImGui::TextDisabled("History");
            ImGui::BeginChild("rows");
            draw_history(e);
            ImGui::EndChild();
        });
        panel("inspector", e.layout.right, colour::panel, [&] {
            ImGui::BeginChild("rows");
            draw_inspector(e);
            ImGui::EndChild();
        });
    }
    panel(
        "drawer", e.layout.drawer, colour::panel,
        [&] {
            const bool was_open = e.splits.drawer_open;
            // Tabs of buttons: ImGui's would take the room of a closed drawer.
            const std::string names[] = {fmt::format("Lights {}", e.lights.size()),
                                         fmt::format("Warnings {}", e.warnings.size()), "Settings"};
            for (int i = 0; i < 3; ++i) {
                const bool on = was_open && e.drawer_tab == i;
                ImGui::PushStyleColor(ImGuiCol_Button, on ? colour::chosen_row : colour::panel);
                if (ImGui::Button(names[i].c_str())) {
                    e.splits.drawer_open = !(was_open && e.drawer_tab == i);
                    e.drawer_tab = i;
                }
                ImGui::PopStyleColor();
                ImGui::SameLine(0, 2 * u);
            }
            ImGui::NewLine();
            if (!was_open) {
                return;
            }
            ImGui::BeginChild("rows");
            e.drawer_tab == 0   ? draw_lights_table(e)
            : e.drawer_tab == 1 ? draw_warnings(e)
                                : draw_settings(e);
            ImGui::EndChild();
        },
        false);
    panel(
        "status", e.layout.status, colour::bar, [&] { draw_status(e, now()); }, false);
    splitter("left splitter", e.layout.left_splitter, true, e.splits.left, 1, usual.left);
    splitter("right splitter", e.layout.right_splitter, true, e.splits.right, -1, usual.right);
    splitter("drawer splitter", e.layout.drawer_splitter, false, e.splits.drawer, -1, usual.drawer);
    splitter("history splitter", e.layout.history_splitter, false, e.splits.history, -1, usual.history);
    draw_sheet(e);
}

// The panels' own colours, by clearing: blending every pixel of a window takes longer than all that is in it.
void EditorWindow::State::clear_grounds() const {
    const int height = window.framebuffer_size().y;
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [box, ground] : grounds) {
        const int x = static_cast<int>(box.x), y = static_cast<int>(box.y);
        const int right = static_cast<int>(box.x + box.width), bottom = static_cast<int>(box.y + box.height);
        glScissor(x, height - bottom, right - x, bottom - y);
        const ImVec4 c = ImGui::ColorConvertU32ToFloat4(ground);
        glClearNamedFramebufferfv(0, GL_COLOR, 0, &c.x);
    }
    glDisable(GL_SCISSOR_TEST);
}

void EditorWindow::State::draw_panels(bool in_frame) {
    EditorState& e = *editor;
    const auto begun = std::chrono::steady_clock::now();
    const bool answers = input.urgent();
    const double asked = input.oldest();
    const ivec2 size = window.framebuffer_size();
    if (!in_frame && std::exchange(e.fonts_changed, false)) {
        e.unit = static_cast<float>(e.text_scale);
        e.fonts = apply_editor_style(e.unit);
        overlay.renew_fonts();
        e.pace.changed(now(), false);
    }
    const Layout before = e.layout;
    e.layout = lay_out(size, e.unit, e.splits);
    if (!(before.picture == e.layout.picture)) {
        e.pace.changed(now(), false);
    }
    overlay.begin();
    make_panels();
    popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    typing = ImGui::GetIO().WantTextInput;
    const bool fields_held = e.fields.dragging();
    if (fields_held != e.pace.held() && !viewport->gesture()) {
        e.pace.hold(fields_held, now());
    }
    glViewport(0, 0, size.x, size.y);
    clear_grounds();
    overlay.end();
    if (report.on()) {
        glFinish();
    }
    ++e.figures.ui_frames;
    e.figures.ui_ms = ms_since(begun);
    last_ui = now();
    input.drawn();
    if (answers) {
        report.answer(1000 * (last_ui - asked), in_frame);
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
        if (e.pace.due()) {
            s.draw_picture();
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, size.x, size.y);
        s.draw_panels(false);
        s.settling = std::max(0, s.settling - 1);
    }
    s.report.line(e);
    if (e.close) {
        s.window.close();
    }
    const bool draws = e.pace.due() && s.session.is_open() && size.x > 0;
    s.asleep = !flies && s.settling == 0 && !draws && !e.desk.waiting() && !s.input.dirty() && !e.close;
    if (!s.asleep) {
        s.window.request_frame();
    }
    return true;
}

}  // namespace lanthorn::edit_window
