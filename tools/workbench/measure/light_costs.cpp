#include "tools/workbench/measure/light_costs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/workbench/frame_meter.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::workbench {

namespace {

std::string name_of(const ecs::World& world, ecs::Entity entity, const std::string& otherwise) {
    const auto* name = world.try_get<Name>(entity);
    return name != nullptr && !name->value.empty() ? name->value : otherwise;
}

// By material, in the order of the entities that show them.
void add_glowing(ecs::World& world, std::vector<Lamp>& lamps) {
    const AssetStore& store = asset_store(world);
    const std::size_t first = lamps.size();
    for (const ecs::Entity entity : emissive_meshes(world)) {
        for (const MeshHandle mesh : world.get<MeshInstances>(entity).meshes) {
            const MaterialHandle material = store.material_of(mesh);
            if (!store.get(material).emits()) {
                continue;
            }
            const auto known = std::find_if(lamps.begin() + static_cast<std::ptrdiff_t>(first), lamps.end(),
                                            [&](const Lamp& lamp) { return lamp.material == material; });
            if (known == lamps.end()) {
                const std::string& own = store.get(material).name;
                lamps.push_back({reference::LightKind::emitter,
                                 own.empty() ? name_of(world, entity, "a glowing surface") : own,
                                 {entity},
                                 material});
            } else if (known->entities.back() != entity) {
                known->entities.push_back(entity);
            }
        }
    }
}

bool shines(const Sky& sky) {
    return sky.image && sky.intensity > 0 && sky.colour != vec3(0);
}

// The one that is shown: of the lowest entity.
void add_sky(const ecs::World& world, std::vector<Lamp>& lamps) {
    ecs::Entity found = ecs::kNullEntity;
    world.query<ecs::Read<SkyComponent>>().each([&](ecs::Entity e, const SkyComponent& component) {
        if (shines(component.sky) && (!found || e.index < found.index)) {
            found = e;
        }
    });
    const auto* backdrop = world.try_resource<Backdrop>();
    if (found) {
        lamps.push_back({reference::LightKind::sky, name_of(world, found, "the sky"), {found}});
    } else if (backdrop != nullptr && shines(backdrop->sky)) {
        lamps.push_back({reference::LightKind::sky, "the sky", {}});
    }
}

Sky& sky_of(ecs::World& world, const Lamp& lamp) {
    return lamp.entities.empty() ? world.resource_mut<Backdrop>().sky
                                 : world.get_mut<SkyComponent>(lamp.entities.front()).sky;
}

// Of the median of normally distributed values, whose spread is read from their median distance to it.
double median_error(const std::vector<double>& values) {
    std::vector<double> away = values;
    const double middle = median(values);
    for (double& value : away) {
        value = std::abs(value - middle);
    }
    return 1.2533 * 1.4826 * median(std::move(away)) / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace

std::vector<Lamp> punctual_lamps(const ecs::World& world) {
    std::vector<Lamp> lamps;
    world.query<ecs::Read<LightComponent>>().each([&](ecs::Entity e, const LightComponent&) {
        lamps.push_back({reference::LightKind::punctual, name_of(world, e, "a lamp"), {e}});
    });
    std::ranges::sort(lamps, {}, [](const Lamp& lamp) { return lamp.entities.front().index; });
    return lamps;
}

std::vector<Lamp> all_lamps(ecs::World& world) {
    std::vector<Lamp> lamps = punctual_lamps(world);
    add_glowing(world, lamps);
    add_sky(world, lamps);
    return lamps;
}

LightCosts::LightCosts(ecs::World& world, std::vector<Lamp> lamps, std::function<void()> show,
                       LightCostFrames frames)
    : world_(&world), lamps_(std::move(lamps)), show_(std::move(show)), each_(frames) {}

void LightCosts::put_out(const Lamp& lamp) {
    switch (lamp.kind) {
        case reference::LightKind::punctual:
            light_ = world_->get<LightComponent>(lamp.entities.front()).light;
            world_->remove<LightComponent>(lamp.entities.front());
            break;
        case reference::LightKind::emitter:
            emissive_ = asset_store(*world_).get(lamp.material).emissive;
            asset_store(*world_).edit_material(lamp.material, [](Material& m) { m.emissive = vec3(0); });
            break;
        case reference::LightKind::sky:
            sky_ = std::exchange(sky_of(*world_, lamp), Sky());
            break;
    }
}

void LightCosts::light_again(const Lamp& lamp) {
    switch (lamp.kind) {
        case reference::LightKind::punctual:
            world_->insert(lamp.entities.front(), LightComponent{*light_});
            break;
        case reference::LightKind::emitter:
            asset_store(*world_).edit_material(lamp.material, [&](Material& m) { m.emissive = emissive_; });
            break;
        case reference::LightKind::sky:
            sky_of(*world_, lamp) = *sky_;
            break;
    }
}

bool LightCosts::step() {
    if (round_ >= rounds(lamps_.size())) {
        return false;
    }
    const bool without = round_ % 2 == 1;
    const Lamp& lamp = lamps_[std::min(round_ / 2, lamps_.size() - 1)];
    if (in_round_ == 0 && without) {
        put_out(lamp);
    }
    const auto begun = std::chrono::steady_clock::now();
    const double cpu_begun = processor_ms();
    show_();
    const double cpu_ms = processor_ms() - cpu_begun;
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - begun;
    ++frames_;
    if (++in_round_ > each_.settling) {
        timed_.ms.push_back(ms.count());
        timed_.cpu_ms.push_back(cpu_ms);
    }
    if (in_round_ < each_.settling + each_.timed) {
        return true;
    }
    errors_.ms.push_back(median_error(timed_.ms));
    errors_.cpu_ms.push_back(median_error(timed_.cpu_ms));
    medians_.ms.push_back(median(std::exchange(timed_.ms, {})));
    medians_.cpu_ms.push_back(median(std::exchange(timed_.cpu_ms, {})));
    in_round_ = 0;
    if (without) {
        light_again(lamp);
    } else if (round_ > 0) {
        const auto saved = [&](const std::vector<double>& by_round) {
            return 0.5 * (by_round[round_ - 2] + by_round[round_]) - by_round[round_ - 1];
        };
        const auto noise = [&](const std::vector<double>& by_round, const std::vector<double>& error) {
            return std::hypot(0.5 * (by_round[round_ - 2] - by_round[round_]), error[round_ - 1],
                              0.5 * std::hypot(error[round_ - 2], error[round_]));
        };
        costs_.push_back({lamps_[round_ / 2 - 1], saved(medians_.ms), saved(medians_.cpu_ms),
                          noise(medians_.ms, errors_.ms), noise(medians_.cpu_ms, errors_.cpu_ms)});
    }
    return ++round_ < rounds(lamps_.size());
}

}  // namespace lanthorn::workbench
