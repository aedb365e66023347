// What the camera sees first, by pixel: geometry and material, for direct light, indirect light and AOVs. Of
// blended surfaces (alphaMode BLEND) that lie over it, a second one holds the nearest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gpu_scene.h"
#include "lanthorn/render/scene_program.h"

namespace lanthorn::render {

struct Looks;

class GBuffer {
  public:
    // `of`: the instances that it is to hold, DrawSet::solid or blend.
    explicit GBuffer(ivec2 size, DrawSet of = DrawSet::solid);

    // Draws the opaque and masked instances that the camera sees, far figures by coarser triangles
    // (GpuScene::picture_level()). `looks`: which of them look otherwise than they are; null: none.
    void draw(const GpuScene& gpu_scene, const CameraUniforms& camera, const Looks* looks = nullptr) {
        draw_all(gpu_scene, camera, nullptr, looks);
    }
    // Draws the nearest of what is blended before `solid`, of the same size and camera; parts that are as
    // good as clear are left out. For a G-buffer of DrawSet::blend.
    void draw_before(const GBuffer& solid, const GpuScene& gpu_scene, const CameraUniforms& camera) {
        draw_all(gpu_scene, camera, &solid, nullptr);
    }
    // Those that the last draw drew, in its order.
    std::span<const DrawnInstance> drawn() const { return drawn_; }
    int instances_drawn() const { return static_cast<int>(visible_.size()); }  // by the last draw

    ivec2 size() const { return size_; }  // pixels
    // R32F: metres from the camera's position (orthographic: from its plane); 0 where nothing is seen.
    const gpu::Texture& distance() const { return distance_; }
    // RGBA16_SNORM: octahedral shading normal in xy, octahedral geometric normal in zw, both facing the
    // viewer.
    const gpu::Texture& normals() const { return normals_; }
    // RGBA16, linear: base colour (less what is transmitted) in rgb, metallic in a; diffuse albedo = rgb * (1
    // - a). Not an sRGB format: drivers encode those by their own approximations, and 16 bits hold every
    // 8-bit sRGB value, dark ones too.
    const gpu::Texture& albedo() const { return albedo_; }
    // RGBA8: roughness, dielectric F0, occlusion, flags / 255 (1: unlit; 2 and more: what colour of light
    // goes through; 255: covered with fuzz; gbuffer_flags.glsl).
    const gpu::Texture& material() const { return material_; }
    // RGBA16F: emitted radiance divided by emissive_scale(); what share of the light that is not reflected
    // goes through (transmission less metallic) in a.
    const gpu::Texture& emissive() const { return emissive_; }
    float emissive_scale() const { return emissive_scale_; }  // nits a stored 1 stands for
    const gpu::Texture& depth() const { return depth_; }  // reversed hardware depth, for forward passes alone

  private:
    void draw_all(const GpuScene& gpu_scene, const CameraUniforms& camera, const GBuffer* behind,
                  const Looks* looks);
    // The last of drawn_, from `first` on, each by its look.
    void draw_looked(const GpuScene& gpu_scene, const CameraUniforms& camera, std::size_t first,
                     const Looks& looks);

    ivec2 size_;
    DrawSet of_;
    gpu::Texture distance_;
    gpu::Texture normals_;
    gpu::Texture albedo_;
    gpu::Texture material_;
    gpu::Texture emissive_;
    gpu::Texture depth_;
    gpu::Framebuffer framebuffer_;
    SceneProgram program_;
    std::optional<SceneProgram> looked_;  // once something has a look
    std::vector<std::uint32_t> visible_;
    std::vector<DrawnInstance> drawn_;
    float emissive_scale_ = 1;
};

}  // namespace lanthorn::render
