// lanthorn edit [SCENE]: the editor; with --script FILE its commands without a window.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/recovery_log.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/edit/beside.h"
#include "tools/lanthorn/edit/edit_window.h"
#include "tools/lanthorn/edit/recorded_state.h"
#include "tools/lanthorn/edit/solve_level.h"

namespace lanthorn::tools {

namespace {

struct EditOptions {
    std::string scene, script, at, against;
    bool beside = false;
    SettingsChoice settings;
    std::string technique;
    SceneView view;
    EditWindowChoice window;
};

ExitCode run(const EditOptions& options) {
    if (!options.at.empty() && options.scene.empty()) {
        throw InputError("--at: found no SCENE, expected the level that was recorded");
    }
    if (options.at.empty() && options.beside) {
        throw InputError("--beside: found no --at, expected FILE:STEP of a recording");
    }
    if (!options.beside && !options.against.empty()) {
        throw InputError("--against: expected --beside with it");
    }
    edit_window::BesideShown shown;
    if (options.beside) {
        shown = beside(options.scene, options.at, options.against);
        fmt::print("{}", beside_text(shown));
        std::fflush(stdout);
    }
    if (options.script.empty()) {
        EditWindowChoice window = options.window;
        window.scene = options.scene;
        window.view = options.view;
        window.technique = options.technique;
        window.preset = options.settings.preset;
        window.at = options.at;
        window.beside = std::move(shown);
        return open_edit_window(window);
    }
    ChosenSettings chosen(options.settings);
    if (!options.technique.empty()) {
        chosen.settings.set_from_text("gi.technique", options.technique);
    }
    editor::EditScript script({options.view, {}}, chosen.settings,
                              [](const std::string& line) { fmt::print("{}\n", line); });
    script.set_solver(solve_now);
    if (!options.scene.empty()) {
        script.session().open(options.scene);
    }
    if (!options.at.empty()) {
        show_recorded(script.session(), options.at);
    }
    script.run_file(options.script);
    return ExitCode::ok;
}

}  // namespace

Command add_edit(CLI::App& app) {
    auto options = std::make_shared<EditOptions>();
    CLI::App* command = app.add_subcommand("edit",
                                           "Edit a scene in a window, with the game's light; or by a script: "
                                           "the editor's commands, a line each, "
                                           "with undo, expectations and pictures. A script ends with 1 at "
                                           "the first expectation that is not met, "
                                           "with 2 at the first line that cannot be done.");
    add_scene_option(*command, options->scene)->required(false);
    command->add_option("--script", options->script, "commands to be run without a window (docs/editor.md)");
    command
        ->add_option("--at", options->at,
                     "as a recorded session of the level leaves it after that step: one step of edits, seen "
                     "by the player's eyes")
        ->type_name("FILE:STEP");
    command->add_flag("--beside", options->beside,
                      "with --at: also what was expected there, by the state that the recording has of that "
                      "step; where things were expected is drawn dashed");
    command
        ->add_option("--against", options->against,
                     "of --beside: another build of this program, that which recorded it say, says what was "
                     "expected")
        ->type_name("PROGRAM");
    command->add_option("--technique", options->technique,
                        "indirect light of pictures (gi.technique; default: emc)");
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "of no use here: pictures are of moment 0");
    add_settings_options(*command, options->settings);
    command->add_option("--size", options->window.size, "of the window, pixels (default: 1280x720)");
    command
        ->add_option("--text", options->window.text,
                     "size of the window's text, percent (default: as the screen asks)")
        ->check(CLI::Range(75, 200));
    command->add_option("--report", options->window.report,
                        "appends what the window draws to a file, lines of JSON");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
