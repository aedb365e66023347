// Traces rays that are listed, through the environment maps or exactly, and finds the lit texels of what they
// meet (remembered_hits.h).
#pragma once

#include <functional>

#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/emc/gather/close_hits.h"
#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/gather/swept_boxes.h"
#include "gi_module/techniques/emc/lit_maps/lit_texels.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/maps/map_rounds.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

// Of EnvironmentMaps::extent(): how far off its surface a ray starts (scatter.glsl).
inline constexpr float kRayOriginOffset = 2e-5f;

// What rays travel through, and what they may meet.
struct RayScene {
    const EnvironmentMaps& maps;
    const LitTexels& texels;
    const SweptBoxes& movers;
    ExactRays* exact;  // null: rays march through the maps
    const GiSettings& settings;
    const FrameScene& scene;
    gpu::PassTimer& timer;
    CloseHits* close = nullptr;             // of exact rays: what they meet too near for a lit texel
    const gpu::Buffer* nearness = nullptr;  // LitMaps::nearness(), beside it
};

class RememberedTrace {
  public:
    // Of one list: entries, their results, and what gives a program the uniforms of remembered.glsl.
    struct Listed {
        const EntryList& entries;
        EntryList& left;            // as large, overwritten: what a second look at the maps is for
        const gpu::Buffer& texels;  // by entry, as RememberedHits has them
        const gpu::Buffer& flights;
        std::function<void(const gpu::Program&)> use;
    };

    void build_programs(Search search);
    Search search() const { return search_; }
    void resize(std::size_t entries) { rounds_.resize(entries); }
    // A ray each. Exact ones wait for the GPU.
    void trace(const RayScene& rays, const Listed& listed);

  private:
    void march(const RayScene& rays, const Listed& listed);
    void trace_exactly(const RayScene& rays, const Listed& listed);

    Search search_ = Search::march;
    gpu::Program one_map_, every_map_, requests_;
    gpu::Program nobody_, each_map_, nearest_;     // for MapRounds::EachMap
    gpu::Program arrivals_[2], left_arrivals_[2];  // with close hits or without
    gpu::Buffer request_list_, arrival_list_;
    MapRounds rounds_;
    gpu::BufferTexture lit_points_view_, arrivals_view_;
};

}  // namespace lanthorn::gi
