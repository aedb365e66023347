// The image module's file: where it lies, and loading it.
#pragma once

#include <filesystem>
#include <string>

#include "engine/assets/image_module.h"

namespace lanthorn {

// $LANTHORN_IMAGE_MODULE, else beside the installation that installed_share() finds, else in the build
// folder.
std::filesystem::path image_module_path();

// What a module must say that it is: the project's version and the interface's.
const char* image_module_version();

// Loads a file as a module. Where that fails, nullptr, and `problem` says why in one line that names the
// package.
const ImageModule* load_image_module(const std::filesystem::path& path, std::string& problem);

// Loads the module once for the process, 0.3 to 0.5 s for the first that asks. Where that fails, as
// load_image_module(); asked again, it is tried again. Thread-safe.
const ImageModule* image_module(std::string& problem);

}  // namespace lanthorn
