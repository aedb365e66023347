#include "lanthorn/drm/mirror_view.h"

#include <span>
#include <vector>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // no rays; groups x, y, z
constexpr float kOriginOffset = 2e-5f;              // of the scene's diagonal
constexpr std::size_t kSampleBytes = 32;            // SpecularSample of specular.glsl
constexpr GLuint kSkyUnit = 4;                      // after the light maps

}  // namespace

void MirrorView::allocate(ivec2 size) {
    if (!rays_program_) {
        rays_program_ = gpu::Program({"gi_module/emc/specular_rays.comp"});
        resolve_program_ = gpu::Program({"gi_module/emc/specular_resolve.comp"});
        header_ = gpu::Buffer(sizeof(kHeader));
    }
    if (size != size_) {
        size_ = size;
        const std::size_t rays = 2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        rays_ = gpu::Buffer(rays * sizeof(SpecularRay));
        samples_ = gpu::Buffer(rays * kSampleBytes);
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
}

const gpu::Texture& MirrorView::radiance(const render::FrameInputs& inputs, const RadianceMap& map,
                                         ExactRays& exact, float roughness, DrmMirrors shows, bool shoot_anew,
                                         const gpu::Buffer& bad_values) {
    if (shoot_anew || inputs.gbuffer.size() != size_) {
        const gpu::PassTimer::Scope scope(inputs.timer, "mirror_rays");
        allocate(inputs.gbuffer.size());
        shoot(inputs, exact, roughness);
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "mirror_shade");
        shade(inputs, map, shows == DrmMirrors::all && map.samples() > 0, bad_values);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "mirror_resolve");
    use(resolve_program_, inputs);
    resolve_program_.set("most_roughness", roughness);
    samples_.bind_storage(2);
    picture_.bind_image(0, GL_WRITE_ONLY);
    resolve_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    // With no share of the lobe the mirror is lit by irradiance as well.
    const bool trick = shows == DrmMirrors::trick;
    glTextureParameteri(picture_.id(), GL_TEXTURE_SWIZZLE_A, trick ? GL_ZERO : GL_ALPHA);
    return picture_;
}

void MirrorView::use(const gpu::Program& program, const render::FrameInputs& inputs) {
    use_surfaces(program, inputs, 0);
    inputs.gbuffer.albedo().bind(2);
    inputs.gbuffer.material().bind(3);
    inputs.gbuffer.emissive().bind(4);
    program.set("gbuffer_albedo", 2);
    program.set("gbuffer_material", 3);
    program.set("gbuffer_emissive", 4);
    table_.bind(program, 5);
}

void MirrorView::shoot(const render::FrameInputs& inputs, ExactRays& exact, float roughness) {
    header_.write_bytes(0, kHeader, sizeof(kHeader));
    use(rays_program_, inputs);
    rays_program_.set("most_roughness", roughness);
    rays_program_.set("origin_offset", kOriginOffset * inputs.scene.diagonal());
    header_.bind_storage(0);
    rays_.bind_storage(1);
    samples_.bind_storage(2);
    rays_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    const std::vector<SpecularHit> hits = exact.trace(rays_.read<SpecularRay>(rays()));
    if (const std::size_t bytes = hits.size() * sizeof(SpecularHit); bytes > hits_.bytes()) {
        hits_ = gpu::Buffer(bytes + bytes / 4);
    }
    if (!hits.empty()) {
        hits_.write(0, std::span<const SpecularHit>(hits));
    }
}

std::uint32_t MirrorView::rays() const {
    return header_ ? header_.read<std::uint32_t>(1).front() : 0;
}

void MirrorView::shade(const render::FrameInputs& inputs, const RadianceMap& map, bool indirect,
                       const gpu::Buffer& bad_values) {
    if (!hits_) {
        return;  // nothing has mirrored yet
    }
    const gpu::Program& program = shade_programs_.bind(inputs.light_maps, 0);
    program.use();
    program.set("has_indirect", indirect ? 1 : 0);
    map.bind(program, false);
    program.set("has_sky", inputs.sky.empty() ? 0 : 1);
    program.set("sky_image", static_cast<int>(kSkyUnit));
    if (!inputs.sky.empty()) {
        inputs.sky.bind(program, kSkyUnit);
    }
    header_.bind_storage(0);
    rays_.bind_storage(1);
    hits_.bind_storage(3);
    samples_.bind_storage(6);
    bad_values.bind_storage(5);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, header_.id());
    glDispatchComputeIndirect(sizeof(std::uint32_t));
    wait_for_shaders();
}

}  // namespace lanthorn::gi
