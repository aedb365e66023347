#include "engine/scene/scene_changes.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

namespace {

// As of an instance that is there in both: what its shape and its surface are made of.
bool other_shape(const FrameScene& before, const FrameScene& now, const Instance& instance) {
    const SceneAssets& was = *before.assets;
    return was.meshes.version(instance.mesh) != now.mesh_version(instance) ||
           was.materials.version(was.meshes[instance.mesh].material).surface !=
               now.material_version(instance).surface;
}

void compare_geometry(const FrameScene& before, const FrameScene& now, std::span<const std::uint32_t> earlier,
                      SceneChanges& changes) {
    const vec3 shift(before.origin - now.origin);  // what was at p is now at p + shift
    const auto shifted = [&](Aabb box) {
        return box.empty() ? box : Aabb{box.lower + shift, box.upper + shift};
    };
    const bool origin_moved = before.origin != now.origin;
    changes.replaced = true;
    bool removed = false;
    std::size_t old = 0;
    const auto remove_until = [&](std::size_t end) {
        for (; old < end; ++old) {
            changes.dirty.add(shifted(before.instances[old].bounds));
            removed = true;
        }
    };
    for (std::uint32_t i = 0; i < now.instances.size(); ++i) {
        const Instance& is = now.instances[i];
        bool moved = true;
        if (earlier[i] == kNone) {
            changes.arrived.push_back(i);
        } else {
            remove_until(earlier[i]);
            const Instance& was = before.instances[old++];
            changes.replaced = false;
            moved = origin_moved || was.transform != is.transform || was.bounds != is.bounds ||
                    was.version != is.version || (changes.assets && other_shape(before, now, is));
            if (moved) changes.dirty.add(shifted(was.bounds));
        }
        if (moved) {
            changes.dirty.add(is.bounds);
            changes.moved.push_back(i);
        }
    }
    remove_until(before.instances.size());
    changes.geometry = removed || !changes.moved.empty();
}

template <class T>
std::vector<std::uint32_t> occupied(const AssetTable<T>& table) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < table.size(); ++slot) {
        if (table.has(slot)) {
            slots.push_back(slot);
        }
    }
    return slots;
}

// Slots whose asset is not the one that `before` has there.
template <class T>
std::vector<std::uint32_t> differing(const AssetTable<T>& before, const AssetTable<T>& now) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < std::max(before.size(), now.size()); ++slot) {
        const std::uint64_t was = before.has(slot) ? before.version(slot).any : 0;
        const std::uint64_t is = now.has(slot) ? now.version(slot).any : 0;
        if (was != is) slots.push_back(slot);
    }
    return slots;
}

// Of instances that were there before: what came is new altogether.
void compare_assets(const SceneAssets& before, const FrameScene& now, SceneChanges& changes) {
    changes.meshes = differing(before.meshes, now.assets->meshes);
    changes.materials = differing(before.materials, now.assets->materials);
    changes.images = differing(before.images, now.assets->images);
    if (changes.materials.empty() && changes.meshes.empty()) return;
    auto arrived = changes.arrived.begin();
    for (std::uint32_t i = 0; i < now.instances.size(); ++i) {
        if (arrived != changes.arrived.end() && *arrived == i) {
            ++arrived;
            continue;
        }
        const Instance& instance = now.instances[i];
        const std::uint32_t material = before.meshes[instance.mesh].material;
        const AssetVersion<Material>& was = before.materials.version(material);
        const AssetVersion<Material>& is = now.material_version(instance);
        if (was.albedo != is.albedo) changes.painted.push_back(i);
        changes.pattern = changes.pattern || was.kept(material) != is.kept(material);
        changes.emission = changes.emission || was.emission != is.emission;
        changes.relief = changes.relief || was.relief != is.relief;
    }
}

}  // namespace

SceneChanges all_changed(const FrameScene& now) {
    SceneChanges changes;
    changes.replaced = true;
    changes.moved.resize(now.instances.size());
    std::iota(changes.moved.begin(), changes.moved.end(), 0u);
    changes.arrived = changes.moved;
    changes.dirty = now.bounds;
    changes.meshes = occupied(now.assets->meshes);
    changes.materials = occupied(now.assets->materials);
    changes.images = occupied(now.assets->images);
    return changes;
}

std::vector<std::uint32_t> earlier_instances(std::span<const Instance> before,
                                             std::span<const Instance> now) {
    const auto key = [](const Instance& i) { return std::tuple(i.id, i.mesh, i.generation); };
    std::vector<std::uint32_t> earlier(now.size(), kNone);
    std::uint32_t old = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto here = key(now[i]);
        while (old < before.size() && key(before[old]) < here) {
            ++old;
        }
        if (old < before.size() && key(before[old]) == here) {
            earlier[i] = old++;
        }
    }
    return earlier;
}

SceneChanges changes_between(const FrameScene& before, const FrameScene& now,
                             std::span<const std::uint32_t> earlier) {
    SceneChanges changes;
    changes.assets = before.assets->serial != now.assets->serial;
    compare_geometry(before, now, earlier, changes);
    if (changes.assets) compare_assets(*before.assets, now, changes);
    const bool moved_origin = before.origin != now.origin;
    changes.lights = moved_origin || before.lights != now.lights || before.sky != now.sky;
    changes.camera = moved_origin || before.camera != now.camera;
    return changes;
}

}  // namespace lanthorn
