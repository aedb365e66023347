#include "gi_module/techniques/emc/gather/gather_error.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kRows = 3;  // of a group's sums

}  // namespace

void GatherError::use(const gpu::Program& program, const Picture& picture) {
    program.use();
    filtered_view_.bind(0, picture.filtered, GL_RGBA32F);
    points_view_.bind(1, picture.points, GL_RGBA32F);
    program.set("filtered", 0);
    program.set("points", 1);
    program.set("grid", picture.grid);
    sums_.bind_storage(4);
}

GatherError::Parts GatherError::measure(const Picture& picture) {
    if (!mean_program_) {
        mean_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_error.comp"}, {"FIRST 1"});
        parts_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_error.comp"}, {"FIRST 0"});
        sums_ = gpu::Buffer(kGroups * kRows * sizeof(vec4));
    }
    use(mean_program_, picture);
    glDispatchCompute(kGroups, 1, 1);
    wait_for_shaders();
    dvec4 light(0);
    for (const vec4& sum : sums_.read<vec4>(kGroups)) {
        light += dvec4(sum);
    }
    Parts parts;
    parts.known = light.a > 0 && light.r + light.g + light.b > 0;
    if (!parts.known) {
        return parts;
    }
    use(parts_program_, picture);
    irradiance_view_.bind(2, picture.irradiance, GL_RGBA32F);
    halves_view_.bind(3, picture.halves, GL_RGBA32F);
    filtered_halves_view_.bind(4, picture.filtered_halves, GL_RGBA32F);
    parts_program_.set("irradiance", 2);
    parts_program_.set("halves", 3);
    parts_program_.set("filtered_halves", 4);
    parts_program_.set("mean", vec3(dvec3(light) / light.a));
    glDispatchCompute(kGroups, 1, 1);
    wait_for_shaders();
    dvec4 rows[kRows]{};
    const std::vector<vec4> sums = sums_.read<vec4>(kGroups * kRows);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        rows[i % kRows] += dvec4(sums[i]);
    }
    // What noise was taken off of may have come out below zero.
    const auto part = [&](const dvec4& row, double unknown) {
        const dvec4 mean = glm::max(row / rows[2].x, dvec4(0));
        return ErrorParts{mean.x, mean.y, mean.z, mean.w, unknown / rows[2].x};
    };
    parts.relrmse = part(rows[0], rows[2].y);
    parts.local = part(rows[1], rows[2].z);
    return parts;
}

}  // namespace lanthorn::gi
