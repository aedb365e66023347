#include "engine/render/blend.h"

#include <algorithm>
#include <functional>

#include "engine/render/scene_textures.h"

namespace lanthorn::render {

BlendPass::BlendPass() : programs_({"engine/render/gbuffer.vert", "engine/render/blend.frag"}) {}

void BlendPass::draw(const FrameScene& scene, const GpuScene& gpu_scene, const LightMaps& light_maps,
                     const CameraUniforms& camera, const Light& light, const gpu::Framebuffer& target,
                     ivec2 size) {
    gpu_scene.find_visible(DrawSet::blend, camera.frustum(), order_);
    if (order_.empty()) {
        return;
    }
    std::ranges::stable_sort(order_, std::greater{}, [&](std::uint32_t i) {
        const vec3 relative = scene.instances[i].bounds.centre() - camera.position;
        return camera.orthographic ? glm::dot(relative, camera.forward) : glm::length(relative);
    });
    // Behind the material's own texture units.
    const gpu::Program& program = programs_.bind(light_maps, static_cast<GLuint>(kMaterialTextures));
    camera.set(program);
    GLuint unit = static_cast<GLuint>(kMaterialTextures) + kLightMapUnits;
    const auto take = [&](const char* name, const gpu::Texture& texture) {
        texture.bind(unit);
        program.set(name, static_cast<int>(unit++));
    };
    program.set("lit_indirectly", light.behind == nullptr ? 0 : light.nearest == nullptr ? 1 : 2);
    if (light.behind != nullptr) {
        take("irradiance_behind", *light.behind);
    }
    if (light.behind != nullptr && light.nearest != nullptr) {
        take("irradiance_nearest", *light.nearest);
        take("distance_behind", *light.distance_behind);
        take("distance_nearest", *light.distance_nearest);
    }
    target.bind(size);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gpu_scene.draw(program, order_);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace lanthorn::render
