// Small reads of files and folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lanthorn::suite {

// All of a file. Throws InputError where it cannot be read.
std::string read_whole(const std::filesystem::path& file);

// The same, but empty where there is none or it cannot be read.
std::string read_if_there(const std::filesystem::path& file);

// Files of a folder whose names end so, by name. Throws InputError for what is no folder.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder, const std::string& ending);

// Makes a folder and those above it. Throws InputError where that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace lanthorn::suite
