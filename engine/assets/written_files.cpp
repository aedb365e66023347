#include "engine/assets/written_files.h"

#include <system_error>

#include "lanthorn/core/error.h"

namespace lanthorn {

namespace fs = std::filesystem;

WrittenFiles::~WrittenFiles() {
    files_.clear();
    if (!committed_) {
        for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder) {
            std::error_code ignored;
            fs::remove(*folder, ignored);
        }
    }
}

void WrittenFiles::add(const fs::path& folder, const fs::path& name, std::string_view bytes) {
    fs::path made = folder;
    for (const fs::path& part : name.parent_path()) {
        made /= part;
        std::error_code error;
        if (fs::create_directory(made, error)) {
            folders_.push_back(made);
        } else if (error) {
            throw InputError((folder / name).string(), "", "cannot be written: " + error.message());
        }
    }
    files_.push_back(std::make_unique<AtomicFile>(folder / name));
    files_.back()->write(bytes);
    files_.back()->finish();
}

void WrittenFiles::commit() {
    for (const auto& file : files_) {
        file->commit();
    }
    committed_ = true;
}

}  // namespace lanthorn
