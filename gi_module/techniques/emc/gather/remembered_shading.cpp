#include "gi_module/techniques/emc/gather/remembered_shading.h"

#include <cstdint>
#include <string>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

gpu::Program shade_program(bool in_picture, int slots, int rays, bool halves) {
    return gpu::Program({"gi_module/techniques/emc/gather/remembered_shade.comp"},
                        {in_picture ? "IN_PICTURE 1" : "IN_PICTURE 0", "SLOTS " + std::to_string(slots),
                         "RAYS " + std::to_string(rays), halves ? "HALVES 1" : "HALVES 0"});
}

}  // namespace

void RememberedShading::resize(bool in_picture, int points, int slots, int rays) {
    in_picture_ = in_picture;
    points_ = points;
    slots_ = slots;
    rays_ = rays;
    shade_ = shade_program(in_picture, slots, rays, false);
    shade_halves_ = {};
    halves_ = {};
    const auto count = static_cast<std::size_t>(points);
    if (in_picture) {
        if (!sort_) {
            empty_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_unserved.comp"});
            sort_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_sort.comp"});
            order_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_order.comp"});
        }
        offsets_.resize(count);
        // Until the next follow() a place that was given away stays empty.
        served_ = gpu::Buffer(2 * count * static_cast<std::size_t>(slots) * sizeof(std::uint32_t));
    }
    irradiance_ = gpu::Buffer(count * sizeof(vec4));
    known_ = gpu::Buffer(count * sizeof(float));
}

void RememberedShading::sort(const Hits& hits, int slots) {
    offsets_.add_up(hits.counts);
    const auto run = [&](const gpu::Program& program, gpu::BufferTexture& view, const gpu::Buffer& buffer,
                         GLenum format, const char* name, int rows) {
        hits.use(program);
        view.bind(0, buffer, format);
        offsets_view_.bind(1, offsets_.sums(), GL_R32UI);
        program.set(name, 0);
        program.set("offsets", 1);
        served_.bind_storage(2);
        dispatch_rows(points_, rows);
        wait_for_shaders();
    };
    run(empty_, counts_view_, hits.counts, GL_R32UI, "counts", 1);
    run(sort_, cells_view_, hits.cells, GL_RG32UI, "cells", slots);
    run(order_, counts_view_, hits.counts, GL_R32UI, "counts", 1);
}

void RememberedShading::shade_by(const gpu::Program& program, const Hits& hits, const SurfacePoints& points,
                                 const gpu::Buffer& radiosity) {
    hits.use(program);
    radiosity_view_.bind(0, radiosity, GL_RGBA32F);
    program.set("radiosity", 0);
    if (in_picture_) {
        served_view_.bind(1, served_, GL_R32UI);
        offsets_view_.bind(2, offsets_.sums(), GL_R32UI);
        counts_view_.bind(3, hits.counts, GL_R32UI);
        program.set("served", 1);
        program.set("offsets", 2);
        program.set("counts", 3);
    } else {
        keys_view_.bind(1, points.keys(), GL_R32UI);
        program.set("keys", 1);
    }
    points.bind_storage();
    irradiance_.bind_storage(1);
    known_.bind_storage(2);
    points.dispatch();
    wait_for_shaders();
}

const gpu::Buffer& RememberedShading::shade(const Hits& hits, const SurfacePoints& points,
                                            const gpu::Buffer& radiosity) {
    shade_by(shade_, hits, points, radiosity);
    return irradiance_;
}

const gpu::Buffer& RememberedShading::halves(const Hits& hits, const SurfacePoints& points,
                                             const gpu::Buffer& radiosity) {
    if (!shade_halves_) {
        shade_halves_ = shade_program(true, slots_, rays_, true);
        halves_ = gpu::Buffer(irradiance_.bytes());
    }
    halves_.bind_storage(6);
    shade_by(shade_halves_, hits, points, radiosity);
    return halves_;
}

}  // namespace lanthorn::gi
