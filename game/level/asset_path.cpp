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

std::string icon_path(int side) {
    namespace fs = std::filesystem;
    const fs::path share = installed_share();
    const std::string of_side = std::to_string(side);
    if (share.empty()) {
        return (fs::path(LANTHORN_SOURCE_ASSETS).parent_path() / "packaging/icons" /
                ("lamplighter-" + of_side + ".png"))
            .string();
    }
    return (share.parent_path() / "icons/hicolor" / (of_side + "x" + of_side) / "apps/lamplighter.png")
        .string();
}

}  // namespace lanthorn::game
