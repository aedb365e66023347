// A program that draws the scene, in a variant for each kind of material.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/gpu/program.h"

namespace lanthorn::render {

// What a material asks of a shader. A software rasteriser samples every texture that a shader names, and a
// shader that may discard tests depth late: so materials get no more than they need. Bits 0..7: the textures
// it has (MaterialData::flags); bit 8: holes are cut out.
using MaterialVariant = std::uint32_t;
inline constexpr MaterialVariant kMaskedVariant = 1u << 8;

class SceneProgram {
  public:
    // `fragment` includes material.glsl; it is built with TEXTURES (the variant's texture bits) and, where
    // alone it needs to discard, with MASKED; and with `defines`.
    SceneProgram(std::filesystem::path vertex, std::filesystem::path fragment,
                 std::vector<std::string> defines = {});

    // Builds those that are missing. Call before set() with what the scene has (GpuScene::variants()).
    void prepare(std::span<const MaterialVariant> variants);
    // The program of a variant that has been prepared; std::out_of_range for another.
    const gpu::Program& variant(MaterialVariant variant) const { return variants_.at(variant); }

    // Sets a uniform of all variants.
    template <class T>
    void set(const char* name, const T& value) const {
        for (const auto& [variant, program] : variants_) {
            program.set(name, value);
        }
    }

  private:
    std::filesystem::path vertex_;
    std::filesystem::path fragment_;
    std::vector<std::string> defines_;
    std::map<MaterialVariant, gpu::Program> variants_;
};

}  // namespace lanthorn::render
