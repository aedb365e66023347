// The level that a recording was made in: found, read, and held against what the recording says of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "lanthorn/replay/recording.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

struct LevelFile {
    std::string path;
    std::uint64_t hash = 0;  // of its bytes
    SceneData scene;
};

// The file of the recorded name and contents that lies beside the recording or among the project's levels;
// where none has the contents, one of that name, which playing will refuse. Throws InputError where there is
// none. Reads what it finds.
std::filesystem::path level_of(const std::string& recording, const replay::RecordingHeader& header);

// From `level` if that is not empty, else from level_of(). Throws InputError as that and import_gltf() do.
std::shared_ptr<const LevelFile> read_level(const std::string& recording,
                                            const replay::RecordingHeader& header, const std::string& level);

}  // namespace lanthorn::tools
