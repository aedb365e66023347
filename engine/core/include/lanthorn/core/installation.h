// Where an installation keeps what its programs read at run time: the folder share/lanthorn with shaders and
// scenes.
#pragma once

#include <filesystem>

namespace lanthorn {

// The folder beside the running program (PREFIX/bin/program, PREFIX/share/lanthorn), else the one that
// name_installation() was given, else empty: the program runs from a build folder. Looks at the disk; not for
// inner loops.
std::filesystem::path installed_share();

// What installed_share() answers where nothing lies beside the program. Returns true. Programs that find
// Lanthorn by find_package() do this by including lanthorn/gpu/context.h.
bool name_installation(const char* share);

}  // namespace lanthorn
