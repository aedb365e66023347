// A scene's images as GL textures with mipmaps, and which of them a material binds.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lanthorn/gpu/texture.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

inline constexpr std::size_t kMaterialTextures = 8;  // units 0..7, in the order of Material::textures()

class SceneTextures {
  public:
    // An image larger than the GL allows is averaged down; one used both as colour and as data exists twice.
    explicit SceneTextures(const SceneAssets& assets);
    ~SceneTextures();
    SceneTextures(const SceneTextures&) = delete;
    SceneTextures& operator=(const SceneTextures&) = delete;

    void bind(std::uint32_t material) const;  // units 0..7; a white texture where the material has none
    static void unbind();                     // the samplers of those units

  private:
    struct Binding {
        std::array<GLuint, kMaterialTextures> textures{};
        std::array<GLuint, kMaterialTextures> samplers{};
    };
    std::vector<gpu::Texture> textures_;
    std::vector<GLuint> samplers_;
    std::vector<Binding> materials_;
};

}  // namespace lanthorn::render
