#include "gi_module/techniques/emc/caustics/caustic_splats.h"

#include <algorithm>
#include <bit>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// A splat is no narrower than so many pixels where it lies: else it may fall between their centres.
constexpr float kLeastPixels = 1.5f;

}  // namespace

void CausticSplats::allocate(ivec2 size) {
    if (!splat_program_) {
        splat_program_ = gpu::Program({"gi_module/techniques/emc/caustics/caustic_splat.comp"});
        add_program_ = gpu::Program({"gi_module/techniques/emc/caustics/caustic_add.comp"});
    }
    if (size != size_) {
        size_ = size;
        tiles_.resize(size);
        caustics_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        sum_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
}

void CausticSplats::upload(const render::FrameInputs& inputs, std::vector<PhotonHit> hits) {
    const CameraView& view = inputs.scene.camera;
    const float height = static_cast<float>(size_.y);
    const float pixel = view.camera.orthographic ? 2 * view.camera.y_mag / height
                                                 : 2 * std::tan(0.5f * view.camera.y_fov) / height;
    photons_.h_max = 0;
    for (PhotonHit& hit : hits) {
        const float distance = view.camera.orthographic ? 1.0f : glm::distance(hit.position, view.position);
        hit.radius = std::max(hit.radius, kLeastPixels * pixel * distance);
        photons_.h_max = std::max(photons_.h_max, hit.radius);
    }
    const int places = static_cast<int>(std::bit_ceil(std::max<std::size_t>(hits.size(), 1024)));
    if (photons_.capacity < places) {
        photons_.allocate(places);
    }
    const auto count = static_cast<std::uint32_t>(hits.size());
    photons_.hits.write(0, std::span<const PhotonHit>(hits));
    photons_.count.write(0, std::span<const std::uint32_t>(&count, 1));
}

void CausticSplats::splat(const render::FrameInputs& inputs, const std::vector<PhotonHit>& hits,
                          bool surfaces_changed, float local_length, const gpu::Buffer& bad_values) {
    surfaces_changed = surfaces_changed || inputs.gbuffer.size() != size_;
    allocate(inputs.gbuffer.size());
    upload(inputs, hits);
    tiles_.sort(inputs, photons_, surfaces_changed);
    runs_.find(tiles_, static_cast<int>(hits.size()), size_);
    use_surfaces(splat_program_, inputs, 2);
    splat_program_.set("local_length", local_length);
    hits_texture_.bind(4, photons_.hits, GL_RGBA32F);
    tiles_.bind(splat_program_, 5);
    splat_program_.set("photon_hits", 4);
    bad_values.bind_storage(4);
    caustics_.bind_image(0, GL_READ_WRITE);
    runs_.dispatch(splat_program_);
}

const gpu::Texture& CausticSplats::with(const gpu::Texture* base) {
    add_program_.use();
    (base != nullptr ? *base : caustics_).bind(0);
    caustics_.bind(1);
    add_program_.set("base", 0);
    add_program_.set("caustics", 1);
    add_program_.set("has_base", base != nullptr ? 1 : 0);
    sum_.bind_image(0, GL_WRITE_ONLY);
    add_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    return sum_;
}

}  // namespace lanthorn::gi
