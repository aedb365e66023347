// Programs that include shining_lights.glsl, made for the kinds of light that a scene has.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/render/light_maps.h"

namespace lanthorn::render {

inline constexpr GLuint kLightMapUnits = 4;

class LightPrograms {
  public:
    explicit LightPrograms(std::vector<std::filesystem::path> stages) : programs_(std::move(stages)) {}

    // The program for these lights, compiled when first asked for, with lights and maps bound and set; the
    // maps take texture units first_unit..first_unit + kLightMapUnits - 1.
    const gpu::Program& bind(const LightMaps& light_maps, GLuint first_unit);

  private:
    gpu::ProgramVariants programs_;
};

}  // namespace lanthorn::render
