// What an EditorWindow holds, and what its parts share.
#pragma once

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/shell/kept_file.h"
#include "lanthorn/shell/window.h"
#include "lanthorn/ui/overlay.h"
#include "tools/editor/window/alarm.h"
#include "tools/editor/window/child_program.h"
#include "tools/editor/window/edit_report.h"
#include "tools/editor/window/editor_state.h"
#include "tools/editor/window/editor_window.h"
#include "tools/editor/window/file_watch.h"
#include "tools/editor/window/input_queue.h"
#include "tools/editor/window/panel_painter.h"
#include "tools/editor/window/viewport.h"
#include "tools/editor/window/wish_solver.h"
#include "tools/workbench/measure/light_costs.h"

namespace lanthorn::edit_window {

constexpr int kSettlingFrames = 3;  // of the panels after something happened: popups need two to size
constexpr double kSmallestText = 0.75, kLargestText = 2;

inline double ms_since(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

struct EditorWindow::State {
    explicit State(EditorOptions given);

    EditorOptions options;
    shell::Window window;
    ui::Overlay overlay;
    InputQueue input;
    SettingsSchema schema;
    editor::EditSession session;
    std::unique_ptr<EditorState> editor;
    std::unique_ptr<Viewport> viewport;
    EditReport report;
    std::atomic<bool> woken{false};
    FileWatch watch;
    shell::KeptFile recent, views, keys;
    Keymap kept_keymap = Keymap::standard;  // as `keys` has it
    Alarm alarm;                            // a line that is said is to vanish
    double alarm_for = 0;                   // GLFW's time

    int settling = kSettlingFrames;      // frames of the panels that are due
    bool popup = false, typing = false;  // as of the last frame of the panels
    double last_ui = 0, last_turn = 0;
    bool first_picture = true, asleep = false;
    double hand_at = 0;  // when the hand did what the next picture shows; 0: nothing
    std::filesystem::path shown_path;
    std::string views_of;  // EditorState::views_file() of it
    std::string title;
    bool dimmed_any = false;
    std::filesystem::path drop_again;

    void begin();
    // window_acts.cpp
    void act(Act act);
    bool act_on_scene(Act act);
    bool act_on_file(Act act);
    bool act_on_shown_view(Act act);
    bool act_on_window(Act act);
    void leave_reference();
    void enter_reference();
    void step_history(bool back);
    std::vector<std::string> of_chosen(const char* command) const;
    void run_and_choose(const char* name, std::vector<std::string> lines);  // what that makes
    void group_chosen();
    void show_all();
    void step_back();  // out of what is going on: a drag, a sheet, a choice
    void show_view(const std::string& name);
    void show_debug_view(bool next);  // or the one of coverage
    void compare_technique();
    void play_clip();
    void copy_render_line();
    void ask_why_there();  // where the mouse points
    void lock_exposure();
    void scale_text(Act what);
    // window_input.cpp
    void take_events();
    void take_key(const Happening& happening);
    void take_drop(const Happening& happening);
    // window_files.cpp
    void read_recent();
    void keep_recent(const std::filesystem::path& file);
    void scene_opened();
    void keep_views();
    void keep_keymap();
    void reload();
    void follow_title();
    // window_frame.cpp
    void settle();
    void apply_preview();
    // Settings as they are drawn with here: an exposure that is held, and what refining needs.
    Settings shown_settings(const Settings& chosen);
    void follow_hand(Quality quality);  // of the next picture
    bool coarse_light = false;          // shown_settings() have smaller maps of lamps
    void hide_other_side();             // until the next picture: others draw in the session's App
    // window_compare.cpp
    void follow_other_side(bool settings_changed);
    std::optional<ViewId> other_view;             // of the session's App, while two ways are compared
    std::shared_ptr<const OtherSide> shown_side;  // that it follows
    void check_game();
    void write_review_page();
    // viewport_why.cpp
    void ask_why(const vec2& place);
    editor::WhyLight why_light;
    // window_rest.cpp
    void follow_rest();
    void take_rest_figures(RestFigures figures);
    void measure_costs(ivec2 size);
    std::uint32_t node_with(std::uint32_t entity);
    RestWatch rest_watch;
    std::filesystem::path carded;  // the file whose picture has been kept for the start screen
    int measured_frame = -1;       // that the watch looks at, or has looked at; -1: none
    double rest_since = 0;
    std::unique_ptr<workbench::LightCosts> costs;  // being measured
    // window_wishes.cpp
    void take_wishes(WishSolver::Answer answer);
    void follow_wishes();
    WishSolver wish_solver;
    std::uint64_t asked_wishes = 0, asked_version = 0;  // that the solver has
    void follow_timeline();                             // window_timeline.cpp
    // window_solve.cpp
    void ask_solvable();  // or no more
    void follow_solving();
    std::filesystem::path solver_folder;
    bool solve_dropped = false;
    double solve_looked = 0;  // GLFW's time
    ChildProgram solver;
    Alarm solver_alarm;
    // window_play.cpp
    void play_here();
    void follow_play();
    void look_at_played();
    std::filesystem::path played_folder;
    std::future<PlayedScene> played;  // being looked at
    ChildProgram game;
    Alarm costs_alarm;  // they are due
    void draw_picture();
    bool refines_now() const;
    void refine_picture();
    void follow_samples();
    bool samples_due() const { return editor->traced.due() || editor->other_traced.due(); }
    bool resumed = false;  // frames have been added to the picture since it was still
    glm::dvec2 whole_size();
    gi::ErrorEstimate estimate_error();
    void breathe();
    // window_panels.cpp
    void draw_panels(bool in_frame);
    void set_alarm();
    void make_panels();
    void paint_panels(ivec2 size);
    std::vector<PanelPainter::Ground> grounds;  // of the panels of this frame
    PanelPainter painter;
    double now() const { return glfwGetTime(); }
};

}  // namespace lanthorn::edit_window
