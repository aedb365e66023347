#include "gi_module/emc/layered_maps.h"

#include <algorithm>
#include <tuple>

#include "engine/core/frustum.h"

namespace lanthorn::gi {

LayeredMaps::LayeredMaps(MapUse use, int slots, int resolution)
    : maps_(slots, resolution, use),
      still_(slots, resolution, use),
      renderer_(use),
      centres_(static_cast<std::size_t>(slots), vec3(0)),
      faces_(static_cast<std::size_t>(6 * slots)) {}

void LayeredMaps::place(int slot, const vec3& centre) {
    centres_[static_cast<std::size_t>(slot)] = centre;
    std::fill_n(faces_.begin() + 6 * slot, 6, Face{});
}

void LayeredMaps::compare(const FrameScene& scene) {
    left_.clear();
    rested_.clear();
    if (scene.assets->serial != serial_ || scene.origin != origin_) {
        std::ranges::fill(faces_, Face{});
        known_.clear();
        serial_ = scene.assets->serial;
        origin_ = scene.origin;
    }
    const bool first = known_.empty();
    std::vector<Known> now;
    now.reserve(scene.instances.size());
    auto before = known_.begin();
    const auto leave = [&] {
        if (!before->moving) {
            left_.push_back(before->bounds);
        }
        ++before;
    };
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const std::tuple key(instance.id, instance.mesh);
        while (before != known_.end() && std::tuple(before->id, before->mesh) < key) {
            leave();
        }
        Known known{instance.id,        instance.mesh,   instance.version,
                    instance.transform, instance.bounds, !first};
        if (before != known_.end() && std::tuple(before->id, before->mesh) == key) {
            const bool moves = before->transform != known.transform || before->version != known.version ||
                               before->bounds != known.bounds;
            known.moving = moves || (before->moving && !instance.is_static);
            if (known.moving) {
                leave();
            } else {
                if (before->moving) {
                    rested_.push_back(i);
                }
                ++before;
            }
        }
        now.push_back(known);
    }
    while (before != known_.end()) {
        leave();
    }
    known_ = std::move(now);
}

void LayeredMaps::forget_other_slots(const std::vector<int>& slots) {
    for (int slot = 0; slot < maps_.slots(); ++slot) {
        if (std::ranges::find(slots, slot) == slots.end()) {
            std::fill_n(faces_.begin() + 6 * slot, 6, Face{});
        }
    }
}

void LayeredMaps::update(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const std::vector<int>& slots) {
    compare(scene);
    forget_other_slots(slots);
    struct Work {
        int layer;
        vec3 centre;
        Frustum frustum;
        bool redraw;  // what stands still
    };
    std::vector<Work> work;
    const auto sees_any = [&](const Work& w, const auto& boxes, const auto& box_of) {
        return std::ranges::any_of(boxes, [&](const auto& b) { return w.frustum.touches(box_of(b)); });
    };
    for (const int slot : slots) {
        const vec3& centre = centres_[static_cast<std::size_t>(slot)];
        for (int layer = 6 * slot; layer < 6 * slot + 6; ++layer) {
            Work w{layer, centre, Frustum::of_cube_face(centre, layer % 6), false};
            Face& face = faces_[static_cast<std::size_t>(layer)];
            w.redraw = !face.still_valid || sees_any(w, left_, [](const Aabb& b) { return b; });
            const bool rested = sees_any(w, rested_, [&](std::uint32_t i) { return known_[i].bounds; });
            const bool movers =
                sees_any(w, known_, [](const Known& k) { return k.moving ? k.bounds : Aabb{}; });
            if (w.redraw || rested || movers || face.has_movers) {
                work.push_back(w);
            }
            face = {true, movers};
        }
    }
    LayerList still;
    LayerList movers;
    for (const std::uint32_t i : gpu_scene.instances(render::DrawSet::all)) {
        const Known& known = known_[i];
        const bool rested = std::ranges::find(rested_, i) != rested_.end();
        for (const Work& w : work) {
            if ((known.moving || rested || w.redraw) && w.frustum.touches(known.bounds)) {
                (known.moving ? movers : still).add(i, w.centre, w.layer);
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
