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

// A folder that goes with what is in it.
class Scratch {
  public:
    // Made if it is not there. Throws as make_folder().
    explicit Scratch(std::filesystem::path folder);
    // One among the system's temporary folders, whose name begins so.
    static Scratch temporary(const std::string& name);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path at(const char* name) const { return folder_ / name; }

  private:
    std::filesystem::path folder_;
};

}  // namespace lanthorn::suite
