#include "gi_module/techniques/emc/gather/gather_links.h"

#include "engine/gpu/pass_end.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void GatherLinks::find(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                       const GiSettings& settings, const gpu::Buffer& points, ivec2 grid) {
    if (!sharpest_map_) {
        sharpest_map_ = gpu::Program({"gi_module/techniques/emc/gather/gather_crossings.comp"}, {"FIRST 1"});
        all_maps_ = gpu::Program({"gi_module/techniques/emc/gather/gather_crossings.comp"}, {"FIRST 0"});
        first_level_ = gpu::Program({"gi_module/techniques/emc/gather/gather_cuts.comp"}, {"FIRST 1"});
        next_level_ = gpu::Program({"gi_module/techniques/emc/gather/gather_cuts.comp"}, {"FIRST 0"});
    }
    if (grid.x * grid.y != count_) {
        count_ = grid.x * grid.y;
        const auto bytes = static_cast<std::size_t>(count_) * sizeof(std::uint32_t);
        crossings_ = gpu::Buffer(bytes);
        walls_ = gpu::Buffer(bytes);
        cuts_[0] = gpu::Buffer(bytes);
        cuts_[1] = gpu::Buffer(bytes);
        unseen_.resize(2 * static_cast<std::size_t>(count_));
    }
    const auto use = [&](const gpu::Program& program) {
        program.use();
        points_view_.bind(2, points, GL_RGBA32F);
        program.set("points", 2);
        program.set("grid", grid);
    };
    unseen_.clear();
    use(sharpest_map_);
    maps.bind(sharpest_map_, 0, 1, settings, inputs.scene);
    crossings_.bind_storage(4);
    unseen_.bind_storage(7);
    dispatch_items(count_);
    wait_for_shaders();
    gpu::PassEnd::tell();
    use(all_maps_);
    inputs.camera.set(all_maps_);
    maps.bind(all_maps_, 0, 1, settings, inputs.scene);
    unseen_.bind_storage(6);
    unseen_.dispatch();
    wait_for_shaders();
    gpu::PassEnd::tell();
    static_assert(kLevels % 2 == 0, "cuts() are those of the last level");
    for (int level = 0; level < kLevels; ++level) {
        const gpu::Program& program = level == 0 ? first_level_ : next_level_;
        use(program);
        crossings_view_.bind(3, crossings_, GL_R32UI);
        cuts_view_.bind(4, cuts_[(level + 1) % 2], GL_R32UI);
        program.set("crossings", 3);
        program.set("before", 4);
        program.set("level", level);
        cuts_[level % 2].bind_storage(4);
        walls_.bind_storage(5);
        dispatch_items(count_);
        wait_for_shaders();
        gpu::PassEnd::tell();
    }
}

}  // namespace lanthorn::gi
