#include "gi_module/techniques/emc/maps/layered_maps.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "engine/gpu/pass_end.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

// A triangle drawn costs a fifth to a tenth of what a ray does (llvmpipe, Embree), and the usual scenes are
// drawn as they always were.
constexpr std::size_t kManyATexel = 8;
constexpr std::uint32_t kFew = 64;  // of so few triangles an instance is drawn whole
// Between two answers to a window's user, about 40 ms on llvmpipe: faces that rays look at, and triangles.
constexpr std::size_t kFacesAtOnce = 32, kTrianglesAtOnce = 40'000;

}  // namespace

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
        faces_[6 * static_cast<std::size_t>(slot) + static_cast<std::size_t>(face)] = {true, true};
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

std::vector<LayeredMaps::Work> LayeredMaps::work_on(const std::vector<int>& slots,
                                                    const SceneMotion& motion) {
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
    return work;
}

std::vector<LayeredMaps::Drawing> LayeredMaps::drawings(const render::GpuScene& gpu_scene,
                                                        const SceneMotion& motion,
                                                        const std::vector<Work>& work) const {
    std::vector<Drawing> result;
    std::vector<std::pair<std::uint32_t, const Work*>> seen_at;  // level
    for (const std::uint32_t i : gpu_scene.instances(render::DrawSet::all)) {
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
                result.push_back({i, level, w, moving});
            }
        }
    }
    return result;
}

LayerList LayeredMaps::seen_alone(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                  TriangleSight& sight, const SceneMotion& motion,
                                  const std::vector<Work>& work, std::vector<Drawing>& drawings) const {
    // What stands still, as rays meet it.
    std::vector<std::uint8_t> stands(scene.instances.size(), 0);
    for (std::uint32_t i = 0; i < stands.size(); ++i) {
        stands[i] = !motion.moving(i) && !motion.rested(i) && sight.whole(i) ? 1 : 0;
    }
    std::vector<CubeFace> faces;
    std::vector<const Work*> work_of;
    for (const Work& w : work) {
        if (w.redraw) {
            faces.push_back({w.centre, w.layer % 6, maps_.resolution()});
            work_of.push_back(&w);
        }
    }
    const auto many = [&](std::uint32_t instance) {
        return stands[instance] != 0 && gpu_scene.triangle_count(instance, 0) >= kFew;
    };
    std::vector<std::vector<SeenTriangle>> seen;
    for (std::size_t f = 0; f < faces.size(); f += kFacesAtOnce) {
        const auto some = std::span(faces).subspan(f, std::min(kFacesAtOnce, faces.size() - f));
        std::ranges::move(sight.see(some, stands), std::back_inserter(seen));
        gpu::PassEnd::tell();
    }
    std::erase_if(drawings, [&](const Drawing& d) { return d.work->redraw && many(d.instance); });

    struct Run {
        std::size_t face, first;  // in `seen`
    };
    std::vector<std::vector<Run>> runs(scene.instances.size());
    for (std::size_t f = 0; f < seen.size(); ++f) {
        for (std::size_t k = 0; k < seen[f].size(); ++k) {
            if ((k == 0 || seen[f][k].instance != seen[f][k - 1].instance) && many(seen[f][k].instance)) {
                runs[seen[f][k].instance].push_back({f, k});
            }
        }
    }
    LayerList list;
    for (const std::uint32_t i : gpu_scene.instances(render::DrawSet::all)) {
        const std::span<const std::uint32_t> indices = InstanceShape(scene, scene.instances[i]).indices();
        for (const Run& run : runs[i]) {
            list.begin_some(i, work_of[run.face]->centre, work_of[run.face]->layer);
            const std::vector<SeenTriangle>& triangles = seen[run.face];
            for (std::size_t k = run.first; k < triangles.size() && triangles[k].instance == i; ++k) {
                const std::size_t at = 3 * std::size_t{triangles[k].primitive};
                list.add_triangle(indices[at], indices[at + 1], indices[at + 2]);
            }
        }
    }
    return list;
}

void LayeredMaps::update(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const std::vector<int>& slots, int look, TriangleSight* sight) {
    motions_.resize(std::max(motions_.size(), static_cast<std::size_t>(look) + 1));
    SceneMotion& motion = motions_[static_cast<std::size_t>(look)];
    motion.compare(scene);
    if (motion.restarted()) {
        std::ranges::for_each(slots, [&](int slot) { forget(slot); });
    }
    forget_strangers(slots, look);
    const std::vector<Work> work = work_on(slots, motion);
    std::vector<Drawing> all = drawings(gpu_scene, motion, work);
    std::size_t triangles = 0;
    std::size_t texels = 0;
    for (const Drawing& d : all) {
        triangles += !d.moving && d.work->redraw ? gpu_scene.triangle_count(d.instance, d.level) : 0;
    }
    for (const Work& w : work) {
        texels += w.redraw ? static_cast<std::size_t>(maps_.resolution() * maps_.resolution()) : 0;
    }
    LayerList seen;
    if (sight != nullptr && triangles > kManyATexel * texels) {
        seen = seen_alone(scene, gpu_scene, *sight, motion, work, all);
    }
    for (const Work& w : work) {
        if (w.redraw) {
            still_.clear(w.layer);
        }
    }
    renderer_.draw(still_, gpu_scene, seen, scene.diagonal());
    const auto draw = [&](const CubeMaps& maps, bool moving) {
        LayerList list;
        std::size_t drawn = 0;
        for (const Drawing& d : all) {
            if (d.moving != moving) {
                continue;
            }
            list.add(d.instance, d.level, d.work->centre, d.work->layer);
            drawn += gpu_scene.triangle_count(d.instance, d.level);
            if (drawn >= kTrianglesAtOnce) {
                renderer_.draw(maps, gpu_scene, list, scene.diagonal());
                list.clear();
                drawn = 0;
                gpu::PassEnd::tell();
            }
        }
        renderer_.draw(maps, gpu_scene, list, scene.diagonal());
    };
    draw(still_, false);
    for (const Work& w : work) {
        maps_.copy(w.layer, still_);
    }
    draw(maps_, true);
    faces_touched_ = static_cast<int>(work.size());
}

}  // namespace lanthorn::gi
