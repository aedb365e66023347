#include "tools/replay_suite/files.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "lanthorn/core/error.h"

namespace lanthorn::suite {

namespace fs = std::filesystem;

std::string read_whole(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad()) {
        throw InputError(file.string(), "", "cannot be read");
    }
    return text;
}

std::string read_if_there(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> files_of(const fs::path& folder, const std::string& ending) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const fs::path& path = at->path();
        if (path.extension() == ending && at->is_regular_file(error)) {
            found.push_back(path);
        }
    }
    if (error) {
        throw InputError(folder.string(), "", "found no folder that can be read: " + error.message());
    }
    std::ranges::sort(found);
    return found;
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw InputError(folder.string(), "", "cannot be made: " + error.message());
    }
}

Scratch::Scratch(fs::path folder) : folder_(std::move(folder)) {
    make_folder(folder_);
}

Scratch Scratch::temporary(const std::string& name) {
    std::string path = (fs::temp_directory_path() / (name + "-XXXXXX")).string();
    if (::mkdtemp(path.data()) == nullptr) {
        throw InputError(path, "", "cannot be made");
    }
    return Scratch(path);
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

}  // namespace lanthorn::suite
