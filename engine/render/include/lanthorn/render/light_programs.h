// Programs that include shining_lights.glsl, made for the kinds of light that a scene has.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/render/light_maps.h"

namespace lanthorn::render {

inline constexpr GLuint kLightMapUnits = 4;
// Texture unit of trees of lamps, behind all others but for the one before it, which has the lamps.
inline constexpr GLuint kLampNodesUnit = 79;
// That of the nodes of area samples.
inline constexpr GLuint kEmitterNodesUnit = kLampNodesUnit - 2;

class LightPrograms {
  public:
    explicit LightPrograms(std::vector<std::filesystem::path> stages) : programs_(std::move(stages)) {}

    // The program for these lights, compiled when first asked for, with lights and maps bound and set; the
    // maps take texture units first_unit..first_unit + kLightMapUnits - 1, and trees of many lamps
    // kLampNodesUnit and the one before, area samples kEmitterNodesUnit.
    const gpu::Program& bind(const LightMaps& light_maps, GLuint first_unit);

  private:
    gpu::ProgramVariants programs_;
    gpu::BufferTexture nodes_, lights_, emitter_nodes_;
};

}  // namespace lanthorn::render
