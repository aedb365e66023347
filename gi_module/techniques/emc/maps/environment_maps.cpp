#include "gi_module/techniques/emc/maps/environment_maps.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/render/detail_hints.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

// Share of the photons that change over in a frame of a fade.
float fade_step(const GiSettings& settings) {
    const auto& emc = settings.of<EmcSettings>();
    return 1.0f / static_cast<float>(std::min(emc.fade_frames, emc.update_interval) + 1);
}

}  // namespace

EnvironmentMaps::Reach EnvironmentMaps::follow(const FrameScene& scene, const GiSettings& settings) {
    if (many_rooms()) {
        forget_outdated(scene, settings);
    }
    const Reach reach = chosen_.follow(scene, settings);
    if (reach.carried != vec3(0)) {
        kept_ = {};
        for (std::size_t slot = 0; slot < centres_.size(); ++slot) {
            centres_[slot] += reach.carried;
            maps_->place(static_cast<int>(slot), centres_[slot]);
        }
        ++version_;
    }
    return reach;
}

void EnvironmentMaps::select(const FrameScene& scene, const render::GpuScene& gpu_scene,
                             const GiSettings& settings, bool elsewhere) {
    if (!elsewhere || !many_rooms()) {
        kept_ = {};
        returned_.clear();
    }
    chosen_.select(scene, gpu_scene, settings, elsewhere);
    const int slots = count() + 1;
    if (!maps_ || maps_->maps().slots() != slots ||
        maps_->maps().resolution() != settings.of<EmcSettings>().resolution) {
        kept_.drop_if([&](const KeptMap& map) {
            return map.still.resolution() != settings.of<EmcSettings>().resolution;
        });
        maps_.emplace(MapUse::tracing, slots, settings.of<EmcSettings>().resolution);
    }
    slot_of_.resize(static_cast<std::size_t>(count()));
    std::iota(slot_of_.begin(), slot_of_.end(), 0);
    centres_.assign(static_cast<std::size_t>(slots), vec3(0));
    for (int i = 0; i < count(); ++i) {
        centres_[static_cast<std::size_t>(i)] = centre_at(static_cast<std::size_t>(i));
        replace(i, centres_[static_cast<std::size_t>(i)], settings);
    }
    spare_slot_ = count();
    ++version_;
    fade_in_ = -1;
    fade_ = 1;
    redraw(scene, gpu_scene);
}

bool EnvironmentMaps::exchange(const FrameScene& scene, const render::GpuScene& gpu_scene,
                               const GiSettings& settings) {
    const MapCentres::Changes changes = chosen_.exchange(settings);
    for (const int place : changes.replaced) {
        const auto i = static_cast<std::size_t>(place);
        const auto slot = static_cast<std::size_t>(slot_of_[i]);
        centres_[slot] = centre_at(i);
        replace(slot_of_[i], centres_[slot], settings);
    }
    version_ += changes.replaced.empty() ? 0 : 1;
    if (changes.faded >= 0) {
        fade_to(static_cast<std::size_t>(changes.faded), scene, gpu_scene, settings);
    }
    if (changes.added) {
        add(1, scene, gpu_scene, settings);
    }
    return !changes.none();
}

bool EnvironmentMaps::reserve(const FrameScene& scene, const render::GpuScene& gpu_scene,
                              const GiSettings& settings, const UnseenSurvey& survey) {
    if (fading()) {
        return false;
    }
    const MapCentres::Reserved reserved = chosen_.reserve(scene, gpu_scene, settings, survey);
    if (reserved.replaced >= 0) {
        fade_to(static_cast<std::size_t>(reserved.replaced), scene, gpu_scene, settings);
    } else if (reserved.added > 0) {
        add(reserved.added, scene, gpu_scene, settings);
    }
    return reserved.replaced >= 0 || reserved.added > 0;
}

ivec2 EnvironmentMaps::reserved_slots() const {
    ivec2 slots(-1);
    int n = 0;
    for (std::size_t i = 0; i < selected().size(); ++i) {
        if (selected()[i] >= static_cast<int>(candidates().size())) {
            slots[n++] = slot_of_[i];
        }
    }
    return slots;
}

// A kept map holds as long as nothing has moved in its sight.
void EnvironmentMaps::forget_outdated(const FrameScene& scene, const GiSettings& settings) {
    const SceneChanges& changes = scene.changes;
    const bool all =
        changes.assets || changes.pattern || !changes.painted.empty() || settings.of<EmcSettings>().kept == 0;
    if (!all && !changes.geometry) {
        return;
    }
    kept_.drop_if([&](const KeptMap& map) {
        const auto sees = [&](const Aabb& box) {
            return chosen_.pool().in_sight(map.centre, box.centre(),
                                           0.5f * box.diagonal() + chosen_.pool().cell());
        };
        return all || sees(changes.dirty) || std::ranges::any_of(changes.moved, [&](std::uint32_t i) {
                   return sees(scene.instances[i].bounds);
               });
    });
}

void EnvironmentMaps::replace(int slot, const vec3& centre, const GiSettings& settings) {
    const std::size_t budget = static_cast<std::size_t>(settings.of<EmcSettings>().kept) << 20;
    const vec3 before = maps_->centre(slot);
    if (!many_rooms() || budget == 0) {
        maps_->place(slot, centre);
        return;
    }
    if (std::optional<CubeMaps> still = maps_->still(slot)) {
        auto rays = std::make_shared<const KeptRays>(rays_of_ ? rays_of_(slot) : KeptRays());
        kept_.keep({before, std::move(*still), std::move(rays)}, budget);
        std::erase_if(returned_, [&](const auto& r) { return r.first == slot; });
    }
    maps_->place(slot, centre);
    if (const KeptMap* map = kept_.find(centre)) {
        maps_->restore(slot, map->still);
        returned_.emplace_back(slot, map->rays);
        ++brought_back_;
    }
}

void EnvironmentMaps::fade_to(std::size_t place, const FrameScene& scene, const render::GpuScene& gpu_scene,
                              const GiSettings& settings) {
    faded_to_ = ++version_;
    fade_in_ = spare_slot_;
    spare_slot_ = slot_of_[place];
    slot_of_[place] = fade_in_;
    centres_[static_cast<std::size_t>(fade_in_)] = centre_at(place);
    fade_ = fade_step(settings);
    replace(fade_in_, centres_[static_cast<std::size_t>(fade_in_)], settings);
    redraw(scene, gpu_scene);
}

std::optional<ivec2> EnvironmentMaps::exchanged_since(std::uint64_t version) const {
    const bool alone = version_ == version + 1 && faded_to_ == version_ && fading();
    return alone ? std::optional(ivec2(fade_in_, spare_slot_)) : std::nullopt;
}

void EnvironmentMaps::add(int maps, const FrameScene& scene, const render::GpuScene& gpu_scene,
                          const GiSettings& settings) {
    for (int i = 0; i < maps; ++i) {
        slot_of_.push_back(slots());
        centres_.push_back(centre_at(slot_of_.size() - 1));
    }
    ++version_;
    maps_.emplace(MapUse::tracing, slots(), settings.of<EmcSettings>().resolution);
    for (int slot = 0; slot < slots(); ++slot) {
        maps_->place(slot, centres_[static_cast<std::size_t>(slot)]);
    }
    redraw(scene, gpu_scene);
}

void EnvironmentMaps::redraw(const FrameScene& scene, const render::GpuScene& gpu_scene, bool all) {
    std::vector<int> in_use = slot_of_;
    if (fading()) {
        in_use.push_back(spare_slot_);
    }
    if (all) {
        std::ranges::for_each(in_use, [&](int slot) { maps_->place(slot, maps_->centre(slot)); });
    }
    maps_->update(scene, gpu_scene, in_use, 0, sight_);
}

void EnvironmentMaps::advance_fade(const GiSettings& settings) {
    if (!fading()) {
        return;
    }
    fade_ += fade_step(settings);
    if (fade_ >= 1.0f - 1e-6f) {
        fade_ = 1;
        fade_in_ = -1;
    }
}

void EnvironmentMaps::bind(const gpu::Program& program, GLuint planes_unit, GLuint albedo_unit,
                           const GiSettings& settings, const FrameScene& scene) const {
    std::vector<vec4> centres;
    std::ranges::transform(centres_, std::back_inserter(centres), [](const vec3& c) { return vec4(c, 0); });
    program.set("map_centres", centres);
    program.set("map_count", static_cast<int>(centres.size()));
    program.set("map_resolution", maps_->maps().resolution());
    // Outside of a fade the spare slot is one that fades out with nobody left in it.
    program.set("map_fade", vec3(static_cast<float>(fade_in_), static_cast<float>(spare_slot_), fade_));
    program.set("reserved_slots", reserved_slots());
    program.set("march_step", kPi / static_cast<float>(settings.of<EmcSettings>().steps));
    program.set("hit_threshold", settings.of<EmcSettings>().threshold);
    program.set("search_all_maps", settings.of<EmcSettings>().exhaustive ? 1 : 0);
    program.set("scene_diagonal", scene.diagonal());
    program.set("local_length", extent(scene));
    program.set("scene_lower", scene.bounds.lower);
    program.set("scene_upper", scene.bounds.upper);
    program.set("environment_planes", static_cast<int>(planes_unit));
    program.set("environment_albedo", static_cast<int>(albedo_unit));
    maps_->maps().planes().bind(planes_unit);
    maps_->maps().albedo().bind(albedo_unit);
}

std::vector<vec4> EnvironmentMaps::slots_in_use() const {
    std::vector<vec4> result;
    for (const int slot : slot_of_) {
        result.emplace_back(static_cast<float>(slot), 0, 0, 0);
    }
    return result;
}

void EnvironmentMaps::add_eyes(DetailHints& hints, const dvec3& origin) const {
    for (const int slot : slot_of_) {
        hints.eyes.push_back({origin + dvec3(centres_[static_cast<std::size_t>(slot)]),
                              render::cube_samples_per_radian(maps_->maps().resolution())});
    }
}

EmcStatistics EnvironmentMaps::statistics() const {
    EmcStatistics result = chosen_.statistics();
    result.brought_back = brought_back_;
    result.resolution = maps_ ? maps_->maps().resolution() : 0;
    result.kept = kept_.count();
    result.kept_bytes = kept_.bytes();
    result.map_bytes = maps_ ? maps_->bytes() : 0;
    return result;
}

}  // namespace lanthorn::gi
