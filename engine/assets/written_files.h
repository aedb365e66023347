// Several output files that appear together or, as far as the file system allows, not at all.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "lanthorn/core/atomic_file.h"

namespace lanthorn {

// Fills a temporary beside every target; commit() renames them all. Without commit() the destructor removes
// them, and the folders that were made for them.
class WrittenFiles {
  public:
    WrittenFiles() = default;
    ~WrittenFiles();
    WrittenFiles(const WrittenFiles&) = delete;
    WrittenFiles& operator=(const WrittenFiles&) = delete;

    // FOLDER/NAME; folders that `name` leads through are made. Throws InputError as AtomicFile does.
    void add(const std::filesystem::path& folder, const std::filesystem::path& name, std::string_view bytes);
    // Renames in order. Throws InputError if that fails.
    void commit();

  private:
    std::vector<std::unique_ptr<AtomicFile>> files_;
    std::vector<std::filesystem::path> folders_;
    bool committed_ = false;
};

}  // namespace lanthorn
