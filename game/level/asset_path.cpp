#include "game/level/asset_path.h"

#include <cstdlib>
#include <filesystem>

#include "lanthorn/core/installation.h"

namespace lanthorn::game {

std::string asset_path(std::string_view file) {
    namespace fs = std::filesystem;
    if (const char* folder = std::getenv("LANTHORN_ASSETS")) {
        return (fs::path(folder) / file).string();
    }
    const fs::path share = installed_share();
    return ((share.empty() ? fs::path(LANTHORN_SOURCE_ASSETS) : share / "assets") / file).string();
}

}  // namespace lanthorn::game
