// Which pictures `lanthorn render` writes, and how files hold them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::tools {

struct AovKind {
    const char* name;
    render::Aov aov;
    bool fits_png;  // within 0..1
    bool fits_hdr;  // three channels, none negative
};

struct Output {
    const AovKind* kind = nullptr;        // null: a debug view
    const gi::DebugView* view = nullptr;  // of the technique
    std::filesystem::path path;
};

// One AOV goes to `file` itself, several to it with -NAME before the ending. Throws InputError for a name
// that is not known or is there twice, and for a file that cannot hold it or cannot be written.
std::vector<Output> plan_outputs(const std::vector<std::string>& aovs, const std::string& file,
                                 const gi::TechniqueEntry& technique);

// As the output's file holds it: PNG and its like display-encoded values, EXR and its like linear ones;
// `final` is rendered encoded, all others linear.
ImageF encode(ImageF image, const Output& output);

}  // namespace lanthorn::tools
