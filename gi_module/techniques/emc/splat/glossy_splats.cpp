#include "gi_module/techniques/emc/splat/glossy_splats.h"

#include <algorithm>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr GLuint kFirstFree = 6;  // texture unit after those of use_pixels()

}  // namespace

void GlossySplats::allocate(ivec2 size) {
    if (!list_program_) {
        list_program_ = gpu::Program({"gi_module/techniques/emc/splat/glossy_list.comp"});
        boundaries_program_ =
            gpu::Program({"gi_module/techniques/emc/splat/splat_boundaries.comp"}, {"LISTED 1"});
        splat_program_ = gpu::Program({"gi_module/techniques/emc/splat/glossy_splat.comp"});
        add_program_ = gpu::Program({"gi_module/techniques/emc/splat/glossy_add.comp"});
        dispatches_ = gpu::Buffer(sizeof(SplatDispatches));
    }
    if (size != size_) {
        size_ = size;
        glossy_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        sum_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        pixels_ = gpu::Buffer(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              sizeof(std::uint32_t));
    }
}

// The uniforms of specular_pixel.glsl.
void GlossySplats::use_pixels(const gpu::Program& program, const render::FrameInputs& inputs,
                              const GiSettings& settings) {
    use_surfaces(program, inputs, 0);
    inputs.gbuffer.albedo().bind(2);
    inputs.gbuffer.material().bind(3);
    inputs.gbuffer.emissive().bind(4);
    program.set("gbuffer_albedo", 2);
    program.set("gbuffer_material", 3);
    program.set("gbuffer_emissive", 4);
    program.set("most_roughness", settings.specular_roughness);
    program.set("grid", 1);
    table_.bind(program, 5);
}

void GlossySplats::splat(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                         const PhotonSet& photons, const GiSettings& settings, Splatting& splatting,
                         const gpu::Buffer& bad_values) {
    const gpu::PassTimer::Scope scope(inputs.timer, "glossy_splats");
    allocate(inputs.gbuffer.size());
    const SplatDispatches none;
    dispatches_.write_bytes(0, &none, sizeof(none));
    use_pixels(list_program_, inputs, settings);
    glossy_.bind_image(0, GL_WRITE_ONLY);
    pixels_.bind_storage(4);
    dispatches_.bind_storage(6);
    list_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();

    use_surfaces(boundaries_program_, inputs, 2);
    boundaries_program_.set("stride", 1);
    boundaries_program_.set("bandwidth_max", photons.h_max);
    maps.bind(boundaries_program_, 0, 1, settings, inputs.scene);
    splatting.boundaries().bind_image(0, GL_WRITE_ONLY);
    splatting.weights().bind_image(1, GL_WRITE_ONLY);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, dispatches_.id());
    glDispatchComputeIndirect(static_cast<GLintptr>(offsetof(SplatDispatches, new_groups)));
    wait_for_shaders();

    runs_.find(splatting.tiles(), photons.capacity, size_);
    use_surfaces(splat_program_, inputs, 2);
    splat_program_.set("stride", 1);
    splat_program_.set("bandwidth_max", photons.h_max);
    splat_program_.set("local_length", maps.extent(inputs.scene));
    const bool fixed = settings.of<EmcSettings>().splat_glossy == GlossyBandwidth::fixed;
    splat_program_.set("fixed_radius", fixed ? photons.h_fixed : 0.0f);
    hits_texture_.bind(4, photons.hits, GL_RGBA32F);
    splatting.tiles().bind(splat_program_, 5);
    directions_texture_.bind(6, photons.directions, GL_R32UI);
    splatting.boundaries().bind(7);
    splatting.weights().bind(8);
    inputs.gbuffer.albedo().bind(9);
    inputs.gbuffer.material().bind(10);
    splat_program_.set("photon_hits", 4);
    splat_program_.set("photon_directions", 6);
    splat_program_.set("boundaries", 7);
    splat_program_.set("weights", 8);
    splat_program_.set("gbuffer_albedo", 9);
    splat_program_.set("gbuffer_material", 10);
    bad_values.bind_storage(4);
    glossy_.bind_image(0, GL_READ_WRITE);
    runs_.dispatch(splat_program_);
}

const gpu::Texture& GlossySplats::with(const render::FrameInputs& inputs, const gpu::Texture* traced,
                                       const gpu::Texture& glossy, const gpu::Texture* caustics,
                                       const GiSettings& settings) {
    use_pixels(add_program_, inputs, settings);
    glossy.bind(kFirstFree);
    (traced != nullptr ? *traced : glossy).bind(kFirstFree + 1);
    (caustics != nullptr ? *caustics : glossy).bind(kFirstFree + 2);
    add_program_.set("glossy", static_cast<int>(kFirstFree));
    add_program_.set("traced", static_cast<int>(kFirstFree + 1));
    add_program_.set("caustics", static_cast<int>(kFirstFree + 2));
    add_program_.set("has_traced", traced != nullptr ? 1 : 0);
    add_program_.set("has_caustics", caustics != nullptr ? 1 : 0);
    sum_.bind_image(0, GL_WRITE_ONLY);
    add_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    return sum_;
}

}  // namespace lanthorn::gi
