#include "tests/support/repository.h"

namespace lanthorn::support {

std::string repository_file(std::string_view path) {
    return LANTHORN_SOURCE_DIR "/" + std::string(path);
}

}  // namespace lanthorn::support
