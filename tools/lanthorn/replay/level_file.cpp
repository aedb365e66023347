#include "tools/lanthorn/replay/level_file.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/installation.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders(const std::string& recording) {
    std::vector<fs::path> all = {fs::path(recording).parent_path()};
    const auto add = [&](const fs::path& assets) {
        all.push_back(assets / "levels");
        all.push_back(assets);
    };
    if (const char* assets = std::getenv("LANTHORN_ASSETS")) {
        add(assets);
    }
    const fs::path share = installed_share();
    add(share.empty() ? fs::path(LANTHORN_SOURCE_ASSETS) : share / "assets");
    return all;
}

}  // namespace

std::filesystem::path level_of(const std::string& recording, const replay::RecordingHeader& header) {
    const fs::path name = fs::path(header.level).filename();
    std::optional<fs::path> other;
    for (const fs::path& folder : folders(recording)) {
        const fs::path file = folder / name;
        std::error_code ignored;
        if (name.empty() || !fs::is_regular_file(file, ignored)) {
            continue;
        }
        if (replay::hash_file(file.string()) == header.level_hash) {
            return file;
        }
        other = other ? other : file;
    }
    if (!other) {
        throw InputError(
            recording, "level",
            fmt::format("'{}' lies neither beside it nor among the levels, expected it there, or "
                        "--level to name the file",
                        header.level));
    }
    return *other;
}

std::shared_ptr<const LevelFile> read_level(const std::string& recording,
                                            const replay::RecordingHeader& header, const std::string& level) {
    auto result = std::make_shared<LevelFile>();
    result->path = level.empty() ? level_of(recording, header).string() : level;
    result->hash = replay::hash_file(result->path);
    result->scene = import_gltf(result->path);
    return result;
}

}  // namespace lanthorn::tools
