// lanthorn edit without a script: the editor's window.
#pragma once

#include <string>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/editor/window/beside_shown.h"

namespace lanthorn::tools {

struct EditWindowChoice {
    std::string scene;  // empty: the start screen
    workbench::SceneView view;
    std::string technique, preset;         // empty: as usual
    std::string size = "1280x720";         // of the window, pixels
    int text = 0;                          // percent; 0: as the screen asks
    std::string report;                    // file of lines of JSON; empty: none
    std::string at;                        // FILE:STEP of a recording of the scene; empty: as the file has it
    edit_window::BesideShown beside = {};  // what was expected there; empty: nothing
};

// Until the person closes it. Throws Error(ExitCode::no_gl) without a display or usable OpenGL.
ExitCode open_edit_window(const EditWindowChoice& choice);

}  // namespace lanthorn::tools
