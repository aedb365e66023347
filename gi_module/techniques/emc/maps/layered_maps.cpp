#include "gi_module/techniques/emc/maps/layered_maps.h"

#include <algorithm>
#include <utility>

#include "lanthorn/core/frustum.h"

namespace lanthorn::gi {

LayeredMaps::LayeredMaps(MapUse use, int slots, int resolution)
    : use_(use),
      maps_(slots, resolution, use),
      still_(slots, resolution, use),
      renderer_(use),
      centres_(static_cast<std::size_t>(slots), vec3(0)),
      faces_(static_cast<std::size_t>(6 * slots)),
      look_of_(static_cast<std::size_t>(slots), 0) {}

void LayeredMaps::place(int slot, const vec3& centre) {
    centres_[static_cast<std::size_t>(slot)] = centre;
    forget(slot);
}

std::optional<CubeMaps> LayeredMaps::still(int slot) const {
    const auto first = faces_.begin() + 6 * slot;
    if (!std::all_of(first, first + 6, [](const Face& face) { return face.still_valid; })) {
        return {};
    }
    CubeMaps result(1, still_.resolution(), use_);
    for (int face = 0; face < 6; ++face) {
        result.copy(face, still_, 6 * slot + face);
    }
    return result;
}

void LayeredMaps::restore(int slot, const CubeMaps& still) {
    for (int face = 0; face < 6; ++face) {
        still_.copy(6 * slot + face, still, face);
        // As if movers had been there: `maps_` is to show it.
        faces_[static_cast<std::size_t>(6 * slot + face)] = {true, true};
    }
}

void LayeredMaps::forget_strangers(const std::vector<int>& slots, int look) {
    for (int slot = 0; slot < maps_.slots(); ++slot) {
        const bool asked = std::ranges::find(slots, slot) != slots.end();
        int& its_look = look_of_[static_cast<std::size_t>(slot)];
        if (asked != (its_look == look)) {
            forget(slot);
        }
        its_look = asked ? look : its_look;
    }
}

void LayeredMaps::update(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const std::vector<int>& slots, int look) {
    motions_.resize(std::max(motions_.size(), static_cast<std::size_t>(look) + 1));
    SceneMotion& motion = motions_[static_cast<std::size_t>(look)];
    motion.compare(scene);
    if (motion.restarted()) {
        std::ranges::for_each(slots, [&](int slot) { forget(slot); });
    }
    forget_strangers(slots, look);
    struct Work {
        int layer;
        vec3 centre;
        Frustum frustum;
        bool redraw;  // what stands still
    };
    std::vector<Work> work;
    for (const int slot : slots) {
        const vec3& centre = centres_[static_cast<std::size_t>(slot)];
        for (int layer = 6 * slot; layer < 6 * slot + 6; ++layer) {
            Work w{layer, centre, Frustum::of_cube_face(centre, layer % 6), false};
            Face& face = faces_[static_cast<std::size_t>(layer)];
            const SceneMotion::Seen seen =
                motion.seen([&](const Aabb& box) { return w.frustum.touches(box); });
            w.redraw = !face.still_valid || seen.left || (seen.painted && use_ == MapUse::tracing);
            if (w.redraw || seen.rested || seen.moving || face.has_movers) {
                work.push_back(w);
            }
            face = {true, seen.moving};
        }
    }
    LayerList still;
    LayerList movers;
    // Blended surfaces take no part: light passes them as if they were not there.
    std::vector<std::pair<std::uint32_t, const Work*>> seen_at;  // level
    for (const std::uint32_t i : gpu_scene.instances(render::DrawSet::opaque_and_mask)) {
        const bool moving = motion.moving(i);
        seen_at.clear();
        for (const Work& w : work) {
            if ((moving || motion.rested(i) || w.redraw) && w.frustum.touches(motion.bounds(i))) {
                seen_at.emplace_back(gpu_scene.level(i, maps_.texel(w.centre)), &w);
            }
        }
        std::ranges::stable_sort(seen_at, {}, [](const auto& at) { return at.first; });
        for (const auto& [level, w] : seen_at) {
            if (level != render::GpuScene::kTooSmall) {
                (moving ? movers : still).add(i, level, w->centre, w->layer);
            }
        }
    }
    for (const Work& w : work) {
        if (w.redraw) {
            still_.clear(w.layer);
        }
    }
    renderer_.draw(still_, gpu_scene, still, scene.diagonal());
    for (const Work& w : work) {
        maps_.copy(w.layer, still_);
    }
    renderer_.draw(maps_, gpu_scene, movers, scene.diagonal());
    faces_touched_ = static_cast<int>(work.size());
}

}  // namespace lanthorn::gi
