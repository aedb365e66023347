// Where the files are that tests read: the project's own scenes, recordings and pictures.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn::support {

// The full path of a file of the repository: repository_file("assets/cornell.glb").
std::string repository_file(std::string_view path);

}  // namespace lanthorn::support
