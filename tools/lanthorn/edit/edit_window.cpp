#include "tools/lanthorn/edit/edit_window.h"

#include "game/level/campaign.h"
#include "game/rules/components.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/shell/kept_file.h"
#include "tools/editor/core/recovery_log.h"
#include "tools/editor/window/editor_window.h"
#include "tools/lanthorn/edit/play_level.h"
#include "tools/lanthorn/edit/recorded_state.h"
#include "tools/lanthorn/edit/solve_level.h"

namespace lanthorn::tools {

ExitCode open_edit_window(const EditWindowChoice& choice) {
    edit_window::EditorOptions options;
    options.scene = choice.scene;
    options.session.view = choice.view;
    options.session.view.declare = game::declare_components;
    options.session.recovery = editor::recovery_folder();
    options.size = parse_size("--size", choice.size, 320, 16384);
    options.text_scale = 0.01 * choice.text;
    options.technique = choice.technique;
    options.preset = choice.preset;
    options.report = choice.report;
    if (!choice.at.empty()) {
        options.opened = [at = choice.at](editor::EditSession& session) { show_recorded(session, at); };
    }
    options.beside = choice.beside;
    options.play = play_command;
    options.played = played_scene;
    options.solve = solve_command;
    options.solve_found = solve_found;
    options.recent = shell::data_file("lanthorn", "recent-scenes");
    for (const std::string_view stem : game::campaign()) {
        const std::filesystem::path file = game::level_path(stem);
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error)) {
            options.levels.push_back(file);
        }
    }
    edit_window::EditorWindow window(std::move(options));
    window.run();
    return ExitCode::ok;
}

}  // namespace lanthorn::tools
