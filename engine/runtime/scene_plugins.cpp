#include "lanthorn/runtime/scene_plugins.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "engine/runtime/animation_plugin.h"
#include "engine/runtime/physics_plugin.h"
#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/deformation_plugin.h"
#include "lanthorn/runtime/scene_plugin.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {

namespace {

std::optional<std::uint32_t> find_wanted(const AnimationSet& set, const std::string& wanted) {
    if (wanted.empty()) {
        return set.clips->empty() ? std::nullopt : std::optional(0u);
    }
    std::vector<std::string> names;
    for (const AnimationClip& clip : *set.clips) {
        names.push_back(clip.name);
    }
    const auto found = find_by_name_or_number(names, wanted);
    return found ? std::optional(static_cast<std::uint32_t>(*found)) : std::nullopt;
}

}  // namespace

void add_scene_plugins(App& app) {
    app.add<ScenePlugin>().add<AnimationPlugin>().add<PhysicsPlugin>().add<DeformationPlugin>();
}

std::vector<ecs::Entity> spawn_scene(App& app, SceneData scene, BadExtras bad) {
    const std::string source = scene.source;
    std::vector<ecs::Entity> entities = spawn(app.world(), std::move(scene));
    apply_extras(app.world(), app.registry(), entities, source, bad);
    return entities;
}

std::string named_clip(ecs::World& world) {
    std::string name;
    world.query<ecs::Read<StartClip>>().each(
        [&](const StartClip& start) { name = name.empty() ? start.clip : name; });
    return name;
}

void play_clip(ecs::World& world, const std::string& asked, const std::string& source) {
    const std::string animation = asked.empty() ? named_clip(world) : asked;
    if (animation == "none") {
        return;
    }
    bool found = animation.empty();
    std::string known;
    for (const ecs::Entity e : world.query<ecs::With<AnimationSet>>().entities()) {
        const AnimationSet set = world.get<AnimationSet>(e);  // a copy: what is added moves it
        if (const auto clip = find_wanted(set, animation)) {
            AnimationPlayer player;
            play(player, set, *clip);
            player.by_clock = true;
            world.insert(e, std::move(player));
            found = true;
        }
        for (std::size_t i = 0; i < set.clips->size(); ++i) {
            known += fmt::format("{} '{}', ", i, (*set.clips)[i].name);
        }
    }
    if (!found) {
        throw InputError(source, "",
                         known.empty() ? fmt::format("found no animation '{}': there is none", animation)
                                       : fmt::format("found no animation '{}', expected one of {}or none",
                                                     animation, known));
    }
}

FrameScene still_scene(ecs::World& world, ecs::Entity camera) {
    Transforms().update(world);
    Deformation().update(world);
    return Extractor().extract(world, camera);
}

}  // namespace lanthorn
