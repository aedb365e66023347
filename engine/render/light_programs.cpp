#include "lanthorn/render/light_programs.h"

namespace lanthorn::render {

const gpu::Program& LightPrograms::bind(const LightMaps& light_maps, GLuint first_unit) {
    const bool few = light_maps.light_count() <= static_cast<int>(kMaxUniformLights);
    std::vector<std::string> defines;
    if (few) {
        defines.push_back("UNIFORM_LIGHTS");
    }
    if (light_maps.punctual_count() > 0) {
        defines.push_back("WITH_PUNCTUAL");
    }
    if (light_maps.light_count() > light_maps.punctual_count()) {
        defines.push_back("WITH_AREA");
    }
    auto entry = programs_.find(defines);
    if (entry == programs_.end()) {
        entry = programs_.emplace(defines, gpu::Program(stages_, defines)).first;
    }
    const gpu::Program& program = entry->second;
    program.set("light_count", light_maps.light_count());
    program.set("punctual_count", light_maps.punctual_count());
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
        light_maps.lights().bind_uniform(kLightsBinding);
    } else {
        light_maps.lights().bind_storage(kLightsBinding);
    }
    return program;
}

}  // namespace lanthorn::render
