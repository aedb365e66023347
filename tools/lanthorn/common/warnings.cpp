#include "tools/lanthorn/common/warnings.h"

#include <fmt/format.h>

#include "lanthorn/core/printable.h"

namespace lanthorn::tools {

SceneData tell_warnings(const std::string& file, SceneData scene) {
    for (const std::string& warning : scene.warnings) {
        fmt::print(stderr, "lanthorn: warning: {}: {}\n", file, printable(warning));
    }
    return scene;
}

}  // namespace lanthorn::tools
