// What the picture mirrors and what is seen through it, for every technique: a ray a pixel of smooth, glossy
// or transparent surfaces, followed to what sends light back along it, which is lit by the light maps and by
// the technique's own indirect light. Wide lobes are left to the irradiance
// (render::IndirectLight::specular).
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "gi_module/shared/mirrors/specular_ray.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::gi {

// Whether any surface of the scene mirrors, being less rough than `roughness`, or is transparent.
// O(instances).
bool any_specular(const FrameScene& scene, float roughness);

//   if (view or surfaces have changed || !view.has(size)) {
//       view.shoot(inputs, roughness);
//       view.set_hits(rays.trace(view.read_rays()));
//   }
//   view.shade(inputs, roughness, bad_values, [&](const gpu::Program& program) { ... });
class MirrorView {
  public:
    // `shade`: the technique's shader about specular_shade.glsl, which says what indirect light there is.
    explicit MirrorView(std::filesystem::path shade)
        : shade_programs_(std::vector<std::filesystem::path>{std::move(shade)}) {}

    // Rays for a picture of `size` have been shot.
    bool has(ivec2 size) const { return size == size_; }
    // Finds the pixels that mirror or are looked through, and a ray each. `roughness`: of the roughest lobe
    // that is traced. `grid`: of so many pixels a side that show one surface one alone has a ray.
    void shoot(const render::FrameInputs& inputs, float roughness, int grid = 1);
    std::uint32_t rays() const;  // of the last shoot(); waits for the GPU
    std::vector<SpecularRay> read_rays() const { return rays_.read<SpecularRay>(rays()); }  // likewise
    // Where they end: a hit a ray in their order, then those found by `next`.
    void set_hits(std::span<const SpecularHit> hits);
    // The other way: runs a program in use, 64 invocations a work group and one a ray, that writes a hit
    // each; header, rays and hits are storage buffers 0, 1 and 3 as in specular_trace.comp.
    void find_hits();

    // Texture units from here on and storage buffer 4 are free for the shader's own; so are 6 and from 8 on.
    static constexpr GLuint kFirstUnit = 5;
    static constexpr GLuint kOwnBinding = 4;
    // Radiance and share of the lobe, RGBA32F of the picture's size (IndirectLight::specular), of what those
    // hits send now. `bind` gives the shader in use what it reads of its own; `bad_values` counts what is not
    // finite. O(pixels + hits * lights).
    const gpu::Texture& shade(const render::FrameInputs& inputs, float roughness,
                              const gpu::Buffer& bad_values,
                              const std::function<void(const gpu::Program&)>& bind);
    // Of the last shade().
    const gpu::Texture& picture() const { return picture_; }

  private:
    void allocate(ivec2 size);
    void use(const gpu::Program& program, const render::FrameInputs& inputs, float roughness);
    void dispatch_rays() const;
    void dispatch_hits() const;
    void dispatch_pixels() const;
    void shade_hits(const render::FrameInputs& inputs, const std::function<void(const gpu::Program&)>& bind);
    void collect(const render::FrameInputs& inputs, const gpu::Buffer& bad_values);
    void resolve(const render::FrameInputs& inputs, float roughness);

    ivec2 size_{0};
    int grid_ = 1;
    gpu::Program list_program_, rays_program_, resolve_program_;
    render::LightPrograms shade_programs_;
    render::LightPrograms collect_programs_{{"gi_module/shared/mirrors/specular_collect.comp"}};
    render::BrdfTable table_;
    gpu::Buffer header_;     // number of rays, groups of 64
    gpu::Buffer rays_;       // SpecularRay
    gpu::Buffer pixels_;     // that may mirror or be looked through: their number, groups of 64, and they
    gpu::Buffer hits_;       // SpecularHit
    int hit_count_ = 0;      // < 0: one a ray
    gpu::Buffer reflected_;  // nits, by hit
    gpu::Buffer samples_;    // two a pixel
    gpu::Texture picture_;
};

}  // namespace lanthorn::gi
