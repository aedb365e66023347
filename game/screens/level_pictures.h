// The pictures of the level choice as textures.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <map>

#include "lanthorn/gpu/texture.h"

namespace lanthorn::game::ui {

class LevelPictures {
  public:
    // The picture of that file; null if there is none or it cannot be read. Each is read once.
    ImTextureID find(const std::filesystem::path& file);

  private:
    std::map<std::filesystem::path, gpu::Texture> pictures_;
};

}  // namespace lanthorn::game::ui
