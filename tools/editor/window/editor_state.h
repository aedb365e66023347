// What the panels share: the session, what waits to be done to it, and how it is looked at. All of the second
// kind is the editor's alone: nothing of it is saved.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/statistics.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/edit_warnings.h"
#include "tools/editor/core/lights_table.h"
#include "tools/editor/core/recovery_log.h"
#include "tools/editor/core/traced_samples.h"
#include "tools/editor/window/beside_shown.h"
#include "tools/editor/window/card_pictures.h"
#include "tools/editor/window/command_desk.h"
#include "tools/editor/window/handles.h"
#include "tools/editor/window/kept_views.h"
#include "tools/editor/window/keymap.h"
#include "tools/editor/window/layout.h"
#include "tools/editor/window/other_side.h"
#include "tools/editor/window/pace.h"
#include "tools/editor/window/picture.h"
#include "tools/editor/window/played_shown.h"
#include "tools/editor/window/refinement.h"
#include "tools/editor/window/rest_watch.h"
#include "tools/editor/window/solve_shown.h"
#include "tools/editor/window/style.h"
#include "tools/editor/window/timeline_shown.h"
#include "tools/editor/window/value_field.h"
#include "tools/editor/window/why_shown.h"
#include "tools/editor/window/wishes_shown.h"

namespace lanthorn::edit_window {

// What lies over the panels, if anything.
enum class Sheet { none, start, open, save, save_as, help, quit, file_changed };

// What the drawer below the picture shows.
enum DrawerTab {
    kLightsTab,
    kWarningsTab,
    kWhyTab,
    kWishesTab,
    kTimelineTab,
    kSolveTab,
    kSettingsTab,
    kPlayedTab,
    kBesideTab
};

// What a light gives to this view and costs in a frame of it.
struct LightGain {
    double share = 0;          // 0..1 of all light that falls on what is seen
    std::optional<double> ms;  // processor time where the CPU draws; none: not measured yet
    double ms_noise = 0;       // its standard error
    bool tells() const { return ms && *ms > 2 * ms_noise; }
};

// What was drawn and how long it took, for the status bar and for tests.
struct Figures {
    int ui_frames = 0;  // drawn since the start
    double ui_ms = 0;   // of the last one, made and drawn
};

struct EditorState {
    explicit EditorState(editor::EditSession& edited, const Settings& chosen)
        : session(edited), settings(chosen) {}

    editor::EditSession& session;
    CommandDesk desk;
    Picture picture;
    Pace pace;
    Refinement refinement;  // of a picture that is still
    bool refines = true;    // it is wanted
    // Of a technique whose samples grow (`path`): how far the picture has come, and A.
    editor::TracedSamples traced, other_traced;
    Box cancel_button;             // where the bar of `traced` is left
    std::string technique_before;  // that drawing goes back to then; empty: the first that there is
    Figures figures;
    std::uint64_t other_pictures = 0;  // grows when a texture beside those of `picture` shows something else

    // How it is drawn: preview only.
    Settings settings;
    std::string preset = "low";
    bool settings_changed = true;
    bool exposure_locked = false;
    float locked_ev = 0;
    std::set<std::uint32_t> muted, solo;  // nodes of lights

    // The window.
    Splits splits;
    Layout layout;
    float unit = 1;         // pixels; text of 13 units
    double text_scale = 1;  // what the user asked for
    bool fonts_changed = true;
    EditorFonts fonts;
    Sheet sheet = Sheet::start;
    int side_tab = 0, drawer_tab = kLightsTab;

    Keymap keymap = Keymap::standard;

    // The viewport.
    KeptViews views;
    bool views_changed = false;      // and are to be written
    std::string views_file() const;  // what they are kept by: the whole path of the scene
    Tool tool = Tool::move;
    // "lamp" or "spot": the next click in the picture puts one before the surface there; empty: none.
    std::string places;
    bool local_axes = false, snap_latched = false, helpers = true;
    SnapSteps steps;
    std::optional<double> lux_under_pointer;
    // Whether a fresh App of the same bytes draws the same: words of the badge, of one version and pose.
    std::string game_words;
    bool game_same = false;
    std::uint64_t game_version = 0;
    workbench::CameraPose game_pose;
    Box game_button;  // where the badge asks for it
    std::optional<WhyShown> why;
    WishesShown wishes;
    TimelineShown timeline;
    bool can_solve = false;  // the program knows how to find out
    bool solving = false;    // it is being found out
    SolveShown solve;
    std::uint64_t solve_version = 0;  // that it is of
    // How wrong the indirect light is: of the picture after so many frames.
    std::optional<gi::EstimatedError> estimate;  // local error of a picture that is not measured yet
    std::optional<editor::ErrorMap> error;
    int error_of_frame = -1;
    bool error_shown = false;  // as a tint over the picture
    // A|B: what stands left of the divider, which is at that share of the picture's width. Null: nothing.
    std::shared_ptr<const OtherSide> other_side;
    float divider = 0.5f;
    std::string compare_with = "coarse-path";  // by which technique, if it is asked for without a name
    Box compare_button;                        // where A's badge asks for another
    bool compare_menu = false;                 // it has been asked for
    const KeptPicture* kept_picture() const;   // null: none stands there
    // How the picture is drawn, as a side of A|B.
    editor::DrawnAs drawn_as() const { return {settings, preset}; }
    // Draws by that technique from the next frame on; the one of now is remembered for leave_reference().
    void set_technique(const std::string& name);
    // Where the reference draws (TechniqueEntry::is_reference), the technique before it does from now on.
    void leave_reference();
    bool draws_reference() const;
    // Beside the picture of now, that; null: nothing.
    std::function<void(std::shared_ptr<const OtherSide>)> compare;
    void compare_as(editor::DrawnAs as);
    const RestWatch* rest_watch = nullptr;
    // By node of a light: of gains_version, and what it costs of costs_version from costs_pose.
    std::map<std::uint32_t, LightGain> gains;
    std::uint64_t gains_version = 0, costs_version = 0;
    workbench::CameraPose costs_pose;
    std::vector<workbench::ContractVerdict> contracts;
    // Where the icons of lights are, by name: pixels of the window.
    std::vector<std::pair<std::string, vec2>> light_places;

    // Read from the session whenever its version is another.
    std::uint64_t read_version = ~std::uint64_t{0};
    std::vector<editor::LightRow> lights;
    std::vector<editor::EditWarning> warnings;
    std::set<std::string> never_mind;  // kinds of warnings
    std::size_t nodes = 0;

    // Said to the user: the newest thing done, and what went wrong where.
    std::string toast;
    double toast_until = 0;  // GLFW's time
    std::string problem;     // stays until something else is done
    std::string reloaded;    // "14:02: 2 meshes, 41 ms"

    std::string search;                          // of the tree
    std::uint32_t reveal = kNone;                // the tree scrolls there once
    std::uint32_t range_from = kNone;            // of Shift+click
    std::vector<std::filesystem::path> recent;   // files
    std::vector<editor::LeftLog> left_logs;      // of other runs
    std::vector<std::filesystem::path> levels;   // that are offered at the start
    CardPictures cards;                          // of both
    std::string open_folder, save_name;          // of the sheets
    std::optional<editor::TextChanges> changes;  // of the save sheet
    bool playing = false;                        // the game runs beside
    std::vector<PlayedRow> played;               // changed there, and offered
    BesideShown beside;                          // empty: nothing was expected
    bool close = false;
    bool opened = false;           // another scene is shown than before
    bool dirty = false;            // as EditSession::is_dirty(), which costs the file's text
    std::function<void(Act)> act;  // does what a key, menu or button stands for
    ValueFields fields;

    bool selected(std::uint32_t node) const;
    // At once: a selection is no edit of the world.
    void select(std::vector<std::uint32_t> nodes);
    std::vector<std::uint32_t> chosen;  // as the panels show it; the session's follows

    void say(const std::string& line, double now);  // for some seconds
    // Opens its rows, and chooses the first node among them: the inspector shows it.
    void show_beside(BesideShown shown);
    // Shows another file, once no frame is being drawn.
    void open(const std::filesystem::path& file);
    // Reads what the panels show where the session's version is another.
    void read();
    // A step of one line or more, and the picture follows.
    void run(const std::string& text, std::vector<std::string> lines);
    // A light of that name and type (point, spot, directional), which is chosen then; a spot or sun shines
    // that way.
    void add_light(const std::string& name, std::string_view type, const dvec3& at, const vec3& shines);
    void preview(const std::string& text, std::vector<std::string> lines);
    void finish(bool keep);
    // As a row's hand says: previews, commits or cancels.
    void follow(Doing doing, const std::string& text, std::vector<std::string> lines);
};

// "8 % +- 2".
std::string error_words(const editor::ErrorMap& map);

}  // namespace lanthorn::edit_window
