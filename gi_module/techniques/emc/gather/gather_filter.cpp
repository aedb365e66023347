#include "gi_module/techniques/emc/gather/gather_filter.h"

#include "gi_module/techniques/emc/gather/surface_points.h"

namespace lanthorn::gi {

namespace {

constexpr int kWideLevels = 4;  // filter_levels() of gather_trust.glsl at most
constexpr int kNarrowLevels = 2;
// A point's rays, where Width::by_rays: from which on it begins to become narrow, and with which it is.
constexpr float kFirstRays = 16, kNarrowRays = 32;
constexpr float kNoRays = 1e9f;  // more than any has

}  // namespace

void GatherFilter::allocate(int count) {
    if (!filter_program_) {
        prefilter_programs_[0] =
            gpu::Program({"gi_module/techniques/emc/gather/gather_prefilter.comp"}, {"FIRST 1"});
        prefilter_programs_[1] =
            gpu::Program({"gi_module/techniques/emc/gather/gather_prefilter.comp"}, {"FIRST 0"});
        filter_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_filter.comp"});
    }
    if (count != count_) {
        count_ = count;
        const auto points = static_cast<std::size_t>(count);
        for (gpu::Buffer& guide : guides_) {
            guide = gpu::Buffer(points * sizeof(vec2));
        }
        for (gpu::Buffer& filtered : filtered_) {
            filtered = gpu::Buffer(points * sizeof(vec4));
        }
    }
}

void GatherFilter::use(const gpu::Program& program, const Points& points, const gpu::Buffer& irradiance) {
    program.use();
    points_view_.bind(0, points.points, GL_RGBA32F);
    irradiance_view_.bind(1, irradiance, GL_RGBA32F);
    known_view_.bind(4, points.known, GL_R32F);
    program.set("points", 0);
    program.set("irradiance", 1);
    program.set("known", 4);
    cuts_view_.bind(5, points.cuts, GL_R32UI);
    program.set("cuts", 5);
    program.set("grid", points.grid);
}

const gpu::Buffer& GatherFilter::run(const Points& points, Width width) {
    allocate(points.grid.x * points.grid.y);
    width_ = width;
    pooled_ = width.narrow < 1 ? 2 : 1;
    for (int level = 0; level < pooled_; ++level) {
        const gpu::Program& program = prefilter_programs_[level];
        use(program, points, points.irradiance);
        guide_view_.bind(2, guides_[0], GL_RG32F);
        program.set("before", 2);
        program.set("level", level);
        guides_[level].bind_storage(4);
        dispatch_in_parts(program, count_);
    }
    return levels(points, points.irradiance, filtered_);
}

const gpu::Buffer& GatherFilter::again(const Points& points, const gpu::Buffer& values) {
    for (gpu::Buffer& filtered : again_) {
        if (filtered.bytes() != filtered_[0].bytes()) {
            filtered = gpu::Buffer(filtered_[0].bytes());
        }
    }
    return levels(points, values, again_);
}

const gpu::Buffer& GatherFilter::levels(const Points& points, const gpu::Buffer& values,
                                        gpu::Buffer (&filtered)[2]) {
    const gpu::Buffer* from = &values;
    for (int level = 0; level < (width_.narrow < 1 ? kWideLevels : kNarrowLevels); ++level) {
        use(filter_program_, points, *from);
        guide_view_.bind(2, guides_[pooled_ - 1], GL_RG32F);
        filter_program_.set("guide", 2);
        filter_program_.set("level", level);
        filter_program_.set("narrowed", width_.narrow);
        filter_program_.set("narrowing",
                            vec2(width_.by_rays ? kFirstRays : kNoRays, 1 / (kNarrowRays - kFirstRays)));
        filter_program_.set("narrows", level >= kNarrowLevels);
        filtered[level % 2].bind_storage(4);
        dispatch_in_parts(filter_program_, count_);
        from = &filtered[level % 2];
    }
    return *from;
}

}  // namespace lanthorn::gi
