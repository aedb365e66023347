#include "gi_module/shared/mirrors/mirror_view.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // nothing listed; groups x, y, z
constexpr int kGroup = 64;
constexpr int kRow = 16384;               // work_items.glsl
constexpr float kOriginOffset = 2e-5f;    // of the scene's diagonal
constexpr std::size_t kSampleBytes = 32;  // SpecularSample of specular.glsl
constexpr GLuint kSkyUnit = 4;            // after the light maps

}  // namespace

bool any_specular(const FrameScene& scene, float roughness) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Material& m = scene.material(instance);
        const bool smooth = m.roughness < roughness || m.metallic_roughness_texture.present();
        const bool reflects = m.metallic > 0 || m.specular > 0;
        return m.alpha_mode != AlphaMode::blend && !m.unlit && (m.transmission > 0 || (smooth && reflects));
    });
}

void MirrorView::allocate(ivec2 size) {
    if (!rays_program_) {
        list_program_ = gpu::Program({"gi_module/shared/mirrors/specular_list.comp"});
        rays_program_ = gpu::Program({"gi_module/shared/mirrors/specular_rays.comp"});
        resolve_program_ = gpu::Program({"gi_module/shared/mirrors/specular_resolve.comp"});
        header_ = gpu::Buffer(sizeof(kHeader));
    }
    if (size != size_) {
        size_ = size;
        const std::size_t rays = 2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        rays_ = gpu::Buffer(rays * sizeof(SpecularRay));
        pixels_ = gpu::Buffer(sizeof(kHeader) + rays / 2 * sizeof(std::uint32_t));
        samples_ = gpu::Buffer(rays * kSampleBytes);
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
}

void MirrorView::use(const gpu::Program& program, const render::FrameInputs& inputs, float roughness) {
    use_surfaces(program, inputs, 0);
    inputs.gbuffer.albedo().bind(2);
    inputs.gbuffer.material().bind(3);
    inputs.gbuffer.emissive().bind(4);
    program.set("gbuffer_albedo", 2);
    program.set("gbuffer_material", 3);
    program.set("gbuffer_emissive", 4);
    program.set("most_roughness", roughness);
    program.set("grid", grid_);
    table_.bind(program, 5);
}

void MirrorView::shoot(const render::FrameInputs& inputs, float roughness, int grid) {
    allocate(inputs.gbuffer.size());
    grid_ = grid;
    header_.write_bytes(0, kHeader, sizeof(kHeader));
    pixels_.write_bytes(0, kHeader, sizeof(kHeader));
    picture_.clear(vec4(0));
    use(list_program_, inputs, roughness);
    samples_.bind_storage(2);
    pixels_.bind_storage(3);
    list_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    use(rays_program_, inputs, roughness);
    rays_program_.set("origin_offset", kOriginOffset * inputs.scene.diagonal());
    header_.bind_storage(0);
    rays_.bind_storage(1);
    dispatch_pixels();
    wait_for_shaders();
}

std::uint32_t MirrorView::rays() const {
    return header_ ? header_.read<std::uint32_t>(1).front() : 0;
}

void MirrorView::set_hits(std::span<const SpecularHit> hits) {
    if (hits.size_bytes() > hits_.bytes()) {
        hits_ = gpu::Buffer(hits.size_bytes() + hits.size_bytes() / 4);
    }
    if (!hits.empty()) {
        hits_.write(0, hits);
    }
    hit_count_ = static_cast<int>(hits.size());
}

void MirrorView::find_hits() {
    const std::size_t bytes = rays_.bytes() / sizeof(SpecularRay) * sizeof(SpecularHit);
    if (bytes > hits_.bytes()) {
        hits_ = gpu::Buffer(bytes);
    }
    hit_count_ = -1;
    header_.bind_storage(0);
    rays_.bind_storage(1);
    hits_.bind_storage(3);
    dispatch_rays();
    wait_for_shaders();
}

void MirrorView::dispatch_rays() const {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, header_.id());
    glDispatchComputeIndirect(sizeof(std::uint32_t));
}

void MirrorView::dispatch_hits() const {
    if (hit_count_ < 0) {
        dispatch_rays();
    } else if (hit_count_ > 0) {
        const int groups = (hit_count_ + kGroup - 1) / kGroup;
        glDispatchCompute(static_cast<GLuint>(std::min(groups, kRow)),
                          static_cast<GLuint>((groups + kRow - 1) / kRow), 1);
    }
}

const gpu::Texture& MirrorView::shade(const render::FrameInputs& inputs, float roughness,
                                      const gpu::Buffer& bad_values,
                                      const std::function<void(const gpu::Program&)>& bind) {
    if (hits_) {  // else nothing has mirrored yet
        const gpu::PassTimer::Scope scope(inputs.timer, "specular_shade");
        shade_hits(inputs, bind);
        collect(inputs, bad_values);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "specular_resolve");
    resolve(inputs, roughness);
    return picture_;
}

// An invocation a hit and not a ray: rays end in one to five places, and a software rasteriser works for all
// of eight rays as long as for the one that has most.
void MirrorView::shade_hits(const render::FrameInputs& inputs,
                            const std::function<void(const gpu::Program&)>& bind) {
    if (const std::size_t bytes = hits_.bytes() / sizeof(SpecularHit) * sizeof(vec4);
        bytes > reflected_.bytes()) {
        reflected_ = gpu::Buffer(bytes);
    }
    const gpu::Program& program = shade_programs_.bind(inputs.light_maps, 0);
    program.use();
    bind(program);
    program.set("hit_count", hit_count_);
    program.set("has_sky", inputs.sky.empty() ? 0 : 1);
    // A unit of its own also where there is no sky: two samplers of different types in one unit see each
    // other's.
    program.set("sky_image", static_cast<int>(kSkyUnit));
    if (!inputs.sky.empty()) {
        inputs.sky.bind(program, kSkyUnit);
    }
    header_.bind_storage(0);
    hits_.bind_storage(3);
    reflected_.bind_storage(5);
    dispatch_hits();
    wait_for_shaders();
}

void MirrorView::collect(const render::FrameInputs& inputs, const gpu::Buffer& bad_values) {
    collect_programs_.bind(inputs.light_maps, 0).use();
    header_.bind_storage(0);
    rays_.bind_storage(1);
    hits_.bind_storage(3);
    reflected_.bind_storage(4);
    samples_.bind_storage(5);
    bad_values.bind_storage(7);
    dispatch_rays();
    wait_for_shaders();
}

void MirrorView::dispatch_pixels() const {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, pixels_.id());
    glDispatchComputeIndirect(sizeof(std::uint32_t));
}

// Of the pixels that are listed; the others are black since shoot().
void MirrorView::resolve(const render::FrameInputs& inputs, float roughness) {
    use(resolve_program_, inputs, roughness);
    samples_.bind_storage(2);
    pixels_.bind_storage(3);
    picture_.bind_image(0, GL_WRITE_ONLY);
    dispatch_pixels();
    wait_for_shaders();
}

}  // namespace lanthorn::gi
