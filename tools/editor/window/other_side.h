// A|B: what stands left of the picture's divider.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "lanthorn/gpu/texture.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/editor/core/two_sides.h"

namespace lanthorn::edit_window {

// A picture that is kept to be compared with.
struct KeptPicture {
    gpu::Texture texture;
    std::string words;  // what it was drawn as
    std::uint64_t version = 0;
    workbench::CameraPose pose;
};

// One of the two.
struct OtherSide {
    std::optional<KeptPicture> kept;    // of an earlier time
    std::optional<editor::DrawnAs> as;  // the scene of now, drawn in another way
};

// Where one looks from, and beside what: a step of the history of views.
struct LookedAt {
    workbench::CameraPose pose;
    std::shared_ptr<const OtherSide> beside = {};  // null: the picture alone
    bool operator==(const LookedAt&) const = default;
};

}  // namespace lanthorn::edit_window
