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
    const bool trees = !shining.nodes.empty();
    if (trees) {
        defines.push_back("LAMP_TREES");
    }
    if (trees || light_maps.shares_maps()) {
        defines.push_back("SHARED_MAPS");
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
    if (trees) {
        const auto end = [&](LightKind kind) { return shining.node_ends[static_cast<std::size_t>(kind)]; };
        program.set("point_nodes_end", end(LightKind::point));
        program.set("spot_nodes_end", end(LightKind::spot));
        program.set("other_nodes_end", end(LightKind::other));
        program.set("lamp_closeness", shining.closeness * shining.closeness);
        program.set("lamp_texel", 2.0f / static_cast<float>(light_maps.resolution()));
        nodes_.bind(kLampNodesUnit, light_maps.nodes_buffer(), GL_RGBA32F);
        program.set("lamp_nodes", static_cast<int>(kLampNodesUnit));
        lights_.bind(kLampNodesUnit - 1, light_maps.shining_buffer(), GL_RGBA32UI);
        program.set("lamp_lights", static_cast<int>(kLampNodesUnit - 1));
    }
    if (shining.has(LightKind::area)) {
        if (light_maps.emitter_nodes()) {
            emitter_nodes_.bind(kEmitterNodesUnit, light_maps.emitter_nodes(), GL_RGBA32F);
        }
        program.set("emitter_nodes", static_cast<int>(kEmitterNodesUnit));
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
