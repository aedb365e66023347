// A folder of a test's own, and the lines that are said about files in it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lanthorn/shell/kept_file.h"

namespace lanthorn::support {

class KeptFolder : public testing::Test {
  protected:
    KeptFolder() { std::filesystem::create_directories(folder); }
    ~KeptFolder() override {
        std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
        std::filesystem::remove_all(folder);
    }

    shell::KeptFile file(const std::string& name = "kept") {
        return {folder / name, "the file", [this](const std::string& line) { said.push_back(line); }};
    }
    void put(const std::string& bytes, const std::string& name = "kept") const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    std::string get(const std::string& name = "kept") const {
        std::ifstream stream(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool has(const std::string& name) const { return std::filesystem::exists(folder / name); }

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("lanthorn-kept-" + std::to_string(::getpid()));
    std::vector<std::string> said;
};

// `bytes` with some altered, cut off, doubled or put in: as a file may come back from a bad disk.
inline std::string damaged(std::string bytes, std::mt19937& random) {
    const auto any = [&](std::size_t below) { return random() % std::max<std::size_t>(below, 1); };
    for (std::size_t changes = 1 + any(4); changes > 0; --changes) {
        const std::size_t at = any(bytes.size());
        switch (any(4)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                bytes.insert(at, 1 + any(20), static_cast<char>(random()));
                break;
            case 2:
                bytes.insert(at, bytes.substr(any(bytes.size()), any(64)));
                break;
            default:
                if (!bytes.empty()) {
                    bytes[at] = static_cast<char>(random());
                }
        }
    }
    return bytes;
}

}  // namespace lanthorn::support
