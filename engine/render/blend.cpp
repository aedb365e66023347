#include "engine/render/blend.h"

#include <algorithm>
#include <functional>

#include "engine/render/scene_textures.h"

namespace lanthorn::render {

BlendPass::BlendPass() : programs_({"engine/render/gbuffer.vert", "engine/render/blend.frag"}) {}

void BlendPass::draw(const FrameScene& scene, const GpuScene& gpu_scene, const LightMaps& light_maps,
                     const CameraUniforms& camera, const gpu::Texture* irradiance,
                     const gpu::Framebuffer& target, ivec2 size) {
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
    program.set("lit_indirectly", irradiance != nullptr ? 1 : 0);
    if (irradiance != nullptr) {
        constexpr GLuint kUnit = static_cast<GLuint>(kMaterialTextures) + kLightMapUnits;
        irradiance->bind(kUnit);
        program.set("indirect_irradiance", static_cast<int>(kUnit));
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
