#include "lanthorn/core/installation.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

// Not a path: set while static objects are still being made.
const char* named_share = nullptr;

}  // namespace

bool name_installation(const char* share) {
    named_share = share;
    return true;
}

fs::path installed_share() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path beside = (program.parent_path() / LANTHORN_SHARE_FROM_BIN).lexically_normal();
        if (fs::is_directory(beside, error)) {
            return beside;
        }
    }
    return named_share ? fs::path(named_share) : fs::path();
}

}  // namespace lanthorn
