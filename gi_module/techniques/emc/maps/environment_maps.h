// The environment maps about the centres C (map_centres.h): drawn, kept up to date, kept when they leave, and
// faded when one is exchanged.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gi_module/techniques/emc/maps/kept_maps.h"
#include "gi_module/techniques/emc/maps/layered_maps.h"
#include "gi_module/techniques/emc/maps/map_centres.h"
#include "lanthorn/deformation/detail.h"

namespace lanthorn::gi {

inline constexpr int kMaxMaps = 40;  // MAX_MAPS of intersection.glsl: k up to 32, one to fade, some to spare

class EnvironmentMaps {
  public:
    // Before the work of each frame: who tells what of many triangles maps show, having followed the frame;
    // may be null (LayeredMaps::update).
    void see_by(TriangleSight* sight) {
        sight_ = sight;
        chosen_.see_by(sight);
    }

    // Chooses all centres (MapCentres::select) and draws their maps.
    void select(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                bool elsewhere = false);

    // MapCentres::follow; kept maps that are out of date are given up. Where all centres have moved, the next
    // redraw() draws all maps.
    using Reach = MapCentres::Reach;
    Reach follow(const FrameScene& scene, const GiSettings& settings);
    bool many_rooms() const { return chosen_.many_rooms(); }
    const Aabb& surroundings() const { return chosen_.surroundings(); }  // as MapCentres has it
    // The length that tolerances are relative to.
    float extent(const FrameScene& scene) const {
        return surroundings().empty() ? scene.diagonal() : surroundings().diagonal();
    }
    // Asked for what rays from a slot's lit texels have met when its map is about to leave.
    void keep_rays(std::function<KeptRays(int slot)> rays) { rays_of_ = std::move(rays); }
    // Slots whose maps have come back since the last call, and the rays that were kept with them.
    using Returned = std::vector<std::pair<int, std::shared_ptr<const KeptRays>>>;
    Returned take_returned() { return std::exchange(returned_, {}); }

    // The work of a progressive update, as MapCentres has it. What is exchanged is drawn and starts to fade
    // in.
    void look(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
              int share, int shares) {
        chosen_.look(scene, gpu_scene, settings, share, shares);
    }
    void take_answers() { chosen_.take_answers(); }
    void ask() { chosen_.ask(); }
    // Whether C has changed. A fade that is under way ends: exchanges do not wait for it.
    bool exchange(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings);

    // Centres of their own, with maps (drawn), for what the picture's rays have met and no map shows
    // (MapCentres::reserve). Whether there is another map now. Cost: ten candidates drawn; for a map more,
    // all maps.
    bool reserve(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                 const UnseenSurvey& survey);

    // Brings every map in use up to date: geometry has changed. `all`: also what shows nothing new.
    void redraw(const FrameScene& scene, const render::GpuScene& gpu_scene, bool all = false);

    // One frame further in a fade, if one is under way. It takes no longer than from one exchange to the
    // next.
    void advance_fade(const GiSettings& settings);
    bool fading() const { return fade_in_ >= 0; }

    // Binds the maps to two texture units and sets the uniforms of intersection.glsl.
    void bind(const gpu::Program& program, GLuint planes_unit, GLuint albedo_unit, const GiSettings& settings,
              const FrameScene& scene) const;

    // Those maps, by slot, and their centres.
    const CubeMaps& drawn() const { return maps_->maps(); }
    const std::vector<vec3>& centres() const { return centres_; }

    void add_eyes(DetailHints& hints, const dvec3& origin) const;

    int count() const { return static_cast<int>(selected().size()); }
    int faces_drawn() const { return maps_->faces_touched(); }  // when maps were drawn last
    std::uint64_t version() const { return version_; }          // grows when maps take the place of others
    // Where one map alone has taken the place of another since that version: its slot, and that of the map
    // that left.
    std::optional<ivec2> exchanged_since(std::uint64_t version) const;
    std::vector<vec4> slots_in_use() const;                          // by map, for shaders: x
    int slots() const { return static_cast<int>(centres_.size()); }  // one more: of a fade
    EmcStatistics statistics() const;
    ivec2 reserved_slots() const;  // -1: none
    const std::vector<vec3>& candidates() const { return chosen_.candidates(); }
    const std::vector<int>& selected() const { return chosen_.selected(); }  // as MapCentres has it
    vec3 centre(int index) const { return chosen_.centre(index); }           // of selected()

  private:
    vec3 centre_at(std::size_t place) const { return centre(selected()[place]); }
    // The slot gets the map about `centre`: a kept one, or at the next redraw() another. What it showed is
    // kept.
    void replace(int slot, const vec3& centre, const GiSettings& settings);
    void forget_outdated(const FrameScene& scene, const GiSettings& settings);
    // The member of C at `place` is another: it gets a map, drawn; the one before fades out.
    void fade_to(std::size_t place, const FrameScene& scene, const render::GpuScene& gpu_scene,
                 const GiSettings& settings);
    // The last `maps` members of C are new: maps of them, drawn at once.
    void add(int maps, const FrameScene& scene, const render::GpuScene& gpu_scene,
             const GiSettings& settings);

    MapCentres chosen_;
    std::optional<LayeredMaps> maps_;  // one slot more than maps: the one that fades
    TriangleSight* sight_ = nullptr;
    KeptMaps kept_;
    std::uint64_t brought_back_ = 0;  // kept maps
    std::function<KeptRays(int)> rays_of_;
    Returned returned_;
    std::vector<int> slot_of_;   // slot of selected()[i]
    std::vector<vec3> centres_;  // by slot
    int spare_slot_ = 0;         // the slot not in use, or fading out
    int fade_in_ = -1;           // slot fading in, or -1
    float fade_ = 1;             // share of photons that use the new map
    std::uint64_t version_ = 0;
    std::uint64_t faded_to_ = 0;  // version_ of the last fade
};

}  // namespace lanthorn::gi
