#include "gi_module/shared/coarse_grid/coarse_grid.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

// The number of extra points, whether or not there was room for them.
std::uint32_t CoarseGrid::run(const render::FrameInputs& inputs) {
    use_surfaces(program_, inputs);
    program_.set("spacing", points_.spacing);
    program_.set("cells", points_.cells);
    program_.set("capacity", static_cast<unsigned>(capacity_));
    count_.clear();
    buffer_.bind_storage(0);
    count_.bind_storage(1);
    fits_.bind_image(0, GL_WRITE_ONLY);
    program_.dispatch(points_.size, ivec2(8));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
    return count_.read<std::uint32_t>(1)[0];
}

void CoarseGrid::find(const render::FrameInputs& inputs, int spacing) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/shared/coarse_grid/surface_points.comp"});
        count_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    points_.size = inputs.gbuffer.size();
    if (!fits_ || ivec2(fits_.size()) != points_.size) {
        fits_ = gpu::Texture::make_2d(GL_R32UI, points_.size);
    }
    points_.spacing = spacing;
    points_.cells = (points_.size + spacing - 1) / spacing;
    const std::size_t lattice = points_.lattice();
    const auto allocate = [&](std::size_t extras) {
        capacity_ = extras;
        buffer_ = gpu::Buffer((lattice + capacity_) * sizeof(SurfacePoint));
    };
    if (buffer_.bytes() != (lattice + capacity_) * sizeof(SurfacePoint)) {
        allocate(lattice / 2);
    }
    std::uint32_t extras = run(inputs);
    if (extras > capacity_) {
        allocate(extras + extras / 4);
        extras = run(inputs);
    }
    points_.points = buffer_.read<SurfacePoint>(lattice + extras);
    // Listed in any order; kept in one, so that every frame of the same picture is the same.
    const auto first = points_.points.begin() + static_cast<std::ptrdiff_t>(lattice);
    std::sort(first, points_.points.end(),
              [](const SurfacePoint& a, const SurfacePoint& b) { return a.pixel < b.pixel; });
    buffer_.write(lattice * sizeof(SurfacePoint), points_.extras());
}

}  // namespace lanthorn::gi
