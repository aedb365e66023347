// `coarse-path`: path tracing from a coarse grid of the picture with Embree, filtered over time and along
// surfaces (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering") and up-sampled. What a user would
// pick instead of `emc`, and what `emc` is held against.
#pragma once

#include <memory>
#include <tuple>
#include <utility>

#include "gi_module/shared/coarse_grid/coarse_grid.h"
#include "gi_module/shared/stamps.h"
#include "gi_module/techniques/coarse-path/coarse_plan.h"
#include "gi_module/techniques/coarse-path/coarse_settings.h"
#include "gi_module/techniques/coarse-path/coarse_statistics.h"
#include "gi_module/techniques/coarse-path/coarse_upsampling.h"
#include "gi_module/techniques/coarse-path/point_history.h"
#include "gi_module/techniques/coarse-path/point_paths.h"
#include "gi_module/techniques/coarse-path/svgf_filter.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class CoarsePathTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    // Follows what moved.
    void update(const render::LightInputs& inputs) override;
    // Points, paths, filters. Waits for the GPU: rays start from what the G-buffer shows.
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    GiStatistics statistics(bool count_photons) override;

  private:
    void find_movers(const FrameScene& scene);
    void trace();

    // What of the settings samples, and what the filter makes of them, are made from.
    enum class Input { sampling, size, filter };
    using Made = Stamps<Input, 3>;
    using Sampling = std::tuple<Spacing, float, int, int, int, std::uint32_t, int>;

    void follow(const GiSettings& settings, ivec2 size);

    struct Placed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        mat4 transform{1};
    };

    GiSettings settings_;
    CoarsePlan plan_;
    Versioned<Sampling> sampling_;
    Versioned<ivec2> size_;
    Versioned<std::pair<int, float>> filtering_;
    Made::Versions now_{};
    Made sampled_{Input::sampling, Input::size};
    Made filtered_{Input::filter};
    CoarseGrid grid_;
    PointPaths paths_;
    PointHistory history_;
    SvgfFilter filter_;
    CoarseUpsampling upsampling_;
    std::unique_ptr<reference::TileWorkers> workers_;
    std::vector<Placed> placed_;  // of the last frame, in FrameScene's order
    std::vector<MovedInstance> movers_;
    gpu::Buffer estimates_;
    CoarseStatistics statistics_;
    std::uint32_t frames_ = 0;  // traced
    const gpu::Texture* irradiance_ = nullptr;
};

}  // namespace lanthorn::gi
