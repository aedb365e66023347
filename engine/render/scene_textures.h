// A scene's images as GL textures with mipmaps, and which of them a material binds.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "lanthorn/gpu/texture.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

inline constexpr std::size_t kMaterialTextures = 8;  // units 0..7, in the order of Material::textures()

class SceneTextures {
  public:
    SceneTextures();
    ~SceneTextures();
    SceneTextures(const SceneTextures&) = delete;
    SceneTextures& operator=(const SceneTextures&) = delete;

    // Uploads the images that materials use and that are new or of another version; lets go of the others. An
    // image larger than the GL allows is averaged down; one used both as colour and as data exists twice.
    // O(materials + textures) and what is uploaded.
    void follow(const SceneAssets& assets);
    // Of pixels, by the last follow().
    std::size_t uploaded_bytes() const { return uploaded_bytes_; }

    // What is added to the levels of mipmaps that are read from here on. O(textures) where it is another.
    void set_bias(float levels);
    void bind(std::uint32_t material) const;  // units 0..7; a white texture where the material has none
    static void unbind();                     // the samplers of those units

  private:
    struct Binding {
        std::array<GLuint, kMaterialTextures> textures{};
        std::array<GLuint, kMaterialTextures> samplers{};
    };
    struct Uploaded {
        std::uint64_t version = 0;  // of the image
        bool used = false;
        gpu::Texture texture;
    };
    struct KeptSampler {
        std::uint64_t version = 0;  // of the texture
        GLuint id = 0;
    };
    void follow_samplers(const SceneAssets& assets);
    GLuint texture_of(const SceneAssets& assets, std::uint32_t image, bool colour);

    gpu::Texture white_;
    std::map<std::pair<std::uint32_t, bool>, Uploaded> images_;  // by slot and whether it is colour
    std::vector<KeptSampler> samplers_;                          // by slot of textures
    std::vector<Binding> materials_;                             // by slot
    std::size_t uploaded_bytes_ = 0;
    float bias_ = 0;
};

}  // namespace lanthorn::render
