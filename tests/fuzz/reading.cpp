#include "tests/fuzz/reading.h"

#include <unistd.h>

#include <fstream>

#include "tests/fuzz/target.h"

namespace lanthorn::fuzz {

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("lanthorn-fuzz-" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

std::string without(std::string text, const std::string& part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) {
        text.erase(at, part.size());
    }
    return text;
}

}  // namespace

const fs::path& folder() {
    static const Folder one;
    return one.path;
}

fs::path write_input(std::string_view name, std::string_view bytes) {
    const fs::path path = folder() / name;
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path;
}

void check_refusal(const Error& refusal) {
    const std::string line = without(refusal.what(), folder().string());
    if (line.empty() || line.size() > 500) {
        throw Finding("a refusal of " + std::to_string(line.size()) +
                      " characters, expected 1 to 500: " + line);
    }
}

}  // namespace lanthorn::fuzz
