#include "lanthorn/render/light_programs.h"

#include <array>
#include <string>
#include <vector>

namespace lanthorn::render {

const gpu::Program& LightPrograms::bind(const LightMaps& light_maps, GLuint first_unit) {
    struct Kind {
        LightKind kind;
        const char* define;
        const char* end;  // uniform
    };
    constexpr std::array<Kind, kLightKinds> kKinds = {
        {{LightKind::directional, "WITH_DIRECTIONAL", "directional_end"},
         {LightKind::point, "WITH_POINT", "point_end"},
         {LightKind::spot, "WITH_SPOT", "spot_end"},
         {LightKind::other, "WITH_OTHER", "punctual_end"},
         {LightKind::area, "WITH_AREA", "light_end"}}};
    const ShiningLights& shining = light_maps.shining();
    const bool few = shining.lights.size() <= kMaxUniformLights;
    std::vector<std::string> defines;
    if (few) {
        defines.push_back("UNIFORM_LIGHTS");
    }
    for (const Kind& kind : kKinds) {
        if (shining.has(kind.kind)) {
            defines.push_back(kind.define);
        }
    }
    const gpu::Program& program = programs_.with(defines);
    for (const Kind& kind : kKinds) {
        program.set(kind.end, shining.ends[static_cast<std::size_t>(kind.kind)]);
    }
    struct Map {
        const char* name;
        const gpu::Texture* texture;
    };
    const Map maps[] = {{"light_map_distance", &light_maps.distance()},
                        {"light_map_normals", &light_maps.normals()},
                        {"area_map_distance", &light_maps.area_distance()},
                        {"area_map_normals", &light_maps.area_normals()}};
    GLuint unit = first_unit;
    for (const Map& map : maps) {
        map.texture->bind(unit);
        program.set(map.name, static_cast<int>(unit++));
    }
    if (few) {
        light_maps.shining_buffer().bind_uniform(kLightsBinding);
    } else {
        light_maps.shining_buffer().bind_storage(kLightsBinding);
    }
    return program;
}

}  // namespace lanthorn::render
