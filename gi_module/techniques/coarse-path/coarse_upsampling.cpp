#include "gi_module/techniques/coarse-path/coarse_upsampling.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kGroup = 64;
constexpr int kMostReach = 6;  // pixels that extra points look about for each other

void wait_for_images() {
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace

const gpu::Texture& CoarseUpsampling::irradiance(const render::FrameInputs& inputs, const CoarseGrid& grid,
                                                 const gpu::Texture& light, const gpu::Buffer& estimates) {
    const GridPoints& points = grid.points();
    if (!place_program_) {
        place_program_ = gpu::Program({"gi_module/techniques/coarse-path/place_points.comp"});
        extras_program_ = gpu::Program({"gi_module/techniques/coarse-path/extra_points.comp"});
        level_program_ = gpu::Program({"gi_module/techniques/coarse-path/coarse_upsampling.comp"});
    }
    if (!irradiance_ || ivec2(irradiance_.size()) != points.size) {
        irradiance_ = gpu::Texture::make_2d(GL_RGBA32F, points.size);
        extras_ = gpu::Texture::make_2d(GL_R32UI, points.size);
    }
    const GLuint none = 0;
    glClearTexImage(extras_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    irradiance_.clear(vec4(0));  // where nothing is seen

    const int count = static_cast<int>(points.points.size());
    place_program_.use();
    points_.bind(2, grid.buffer(), GL_RGBA32F);
    light.bind(3);
    place_program_.set("points", 2);
    place_program_.set("light", 3);
    place_program_.set("cells", points.cells);
    place_program_.set("count", count);
    irradiance_.bind_image(0, GL_WRITE_ONLY);
    extras_.bind_image(1, GL_WRITE_ONLY);
    place_program_.dispatch(count, kGroup);
    wait_for_images();

    const int extra_count = static_cast<int>(points.extras().size());
    if (extra_count > 0) {
        use_surfaces(extras_program_, inputs);
        estimates_.bind(4, estimates, GL_RGBA32F);
        extras_.bind(5);
        extras_program_.set("points", 2);
        extras_program_.set("light", 3);
        extras_program_.set("estimates", 4);
        extras_program_.set("extras", 5);
        extras_program_.set("cells", points.cells);
        extras_program_.set("spacing", points.spacing);
        extras_program_.set("extra_count", extra_count);
        extras_program_.set("reach", std::min(points.spacing, kMostReach));
        extras_program_.dispatch(extra_count, kGroup);
        wait_for_images();
    }
    level_program_.use();
    grid.fits().bind(0);
    level_program_.set("fits", 0);
    level_program_.set("image_size", points.size);
    irradiance_.bind_image(0, GL_READ_WRITE);
    for (int lattice = points.spacing / 2; lattice >= 1; lattice /= 2) {
        level_program_.set("lattice", lattice);
        level_program_.dispatch((points.size + 2 * lattice - 1) / (2 * lattice), ivec2(8));
        wait_for_images();
    }
    return irradiance_;
}

}  // namespace lanthorn::gi
