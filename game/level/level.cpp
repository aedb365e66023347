#include "lanthorn/lamplighter/lamplighter.h"

#include <cmath>
#include <string>
#include <vector>

#include "game/level/level_starts.h"
#include "game/level/night_sky.h"
#include "game/rules/components.h"
#include "game/rules/headings.h"
#include "lanthorn/core/error.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::game {

using ecs::Entity;
using ecs::World;

void fail(const World& world, Entity e, const std::string& source, const std::string& problem) {
    const Name* name = world.try_get<Name>(e);
    throw InputError(source, "node '" + (name != nullptr ? name->value : ecs::to_string(e)) + "'", problem);
}

namespace {

template <class T>
Entity only_one(const World& world, const std::string& source, const char* component) {
    const std::vector<Entity> found = world.query<ecs::With<T>>().entities();
    if (found.size() != 1) {
        throw InputError(source, "nodes",
                         "found " + std::to_string(found.size()) + " with extras {\"" + component +
                             "\": {}}, expected one");
    }
    return found.front();
}

void refuse_several_levels(const World& world, const std::string& source) {
    const std::size_t found = world.query<ecs::With<LevelInfo>>().entities().size();
    if (found > 1) {
        throw InputError(
            source, "nodes",
            "found " + std::to_string(found) + " with extras {\"level\": {}}, expected one at most");
    }
}

void start_player(World& world, const std::string& source) {
    const Entity player = only_one<Player>(world, source, "player");
    const Entity eyes = only_one<Eyes>(world, source, "eyes");
    if (!world.has<physics::Character>(player)) {
        fail(world, player, source, "has a player, expected {\"character\": {}} beside it");
    }
    if (!world.has<CameraComponent>(eyes) || parent_of(world, eyes) != player) {
        fail(world, eyes, source, "has eyes, expected a camera right below the player's node");
    }
    world.insert(player, physics::CharacterInput{});
    world.insert(eyes, Interpolated{});
    const vec3 ahead = world.get<LocalTransform>(eyes).value.rotation * vec3(0, 0, -1);
    Eyes& look = world.get_mut<Eyes>(eyes);
    look.yaw = rounded(std::atan2(-double(ahead.x), -double(ahead.z)));
    look.pitch = rounded(std::asin(glm::clamp(double(ahead.y), -1.0, 1.0)));
    world.resource_mut<View>().camera = eyes;
}

void start_doors(World& world) {
    for (const Entity e : world.query<ecs::With<Door>>().entities()) {
        world.get_mut<Door>(e).closed = world.get<LocalTransform>(e).value.rotation;
        world.insert(e, Interpolated{});
    }
}

void start_moving_things(World& world) {
    for (const Entity e : world.query<ecs::With<Shutter>>().entities()) {
        world.get_mut<Shutter>(e).shut = world.get<LocalTransform>(e).value.translation;
        world.insert(e, Interpolated{});
    }
    for (const Entity e : world.query<ecs::With<Pushed>>().entities()) {
        world.get_mut<Pushed>(e).start = world.get<LocalTransform>(e).value.translation;
        world.insert(e, Interpolated{});
    }
    for (const Entity e : world.query<ecs::With<Turntable>>().entities()) {
        world.get_mut<Turntable>(e).start = world.get<LocalTransform>(e).value.rotation;
        world.insert(e, Interpolated{});
    }
    for (const Entity e : world.query<ecs::With<physics::RigidBody>>().entities()) {
        if (world.get<physics::RigidBody>(e).type == physics::BodyType::dynamic) {
            world.insert(e, Interpolated{});
        }
    }
}

// The one light below `e`; null: there is none.
Entity light_below(const World& world, Entity e, const std::string& source) {
    Entity found;
    for (const Entity below : descendants(world, e)) {
        if (world.has<LightComponent>(below)) {
            if (found) {
                fail(world, e, source, "has several lights below it, expected one at most");
            }
            found = below;
        }
    }
    return found;
}

// Asleep, they are dark.
void start_crystals(World& world, const std::string& source) {
    for (const Entity e : world.query<ecs::With<Crystal>>().entities()) {
        if (!world.has<LightSensor>(e)) {
            fail(world, e, source, "has a crystal, expected {\"light_sensor\": {}} beside it");
        }
        Crystal& crystal = world.get_mut<Crystal>(e);
        crystal.lamp = light_below(world, e, source);
        if (crystal.lamp) {
            crystal.light = world.get<LightComponent>(crystal.lamp).light;
            world.remove<LightComponent>(crystal.lamp);
        }
    }
}

void start_lanterns(World& world, const std::string& source) {
    for (const Entity e : world.query<ecs::With<Lantern>>().entities()) {
        if (parent_of(world, e)) {
            fail(world, e, source, "has a lantern and is below another node, expected a root node");
        }
        Lantern& lantern = world.get_mut<Lantern>(e);
        lantern.flame = light_below(world, e, source);
        if (lantern.flame) {
            lantern.light = world.get<LightComponent>(lantern.flame).light;
            if (lantern.lit) {
                world.insert(lantern.flame, LightComponent{lantern.shining()});
            } else {
                world.remove<LightComponent>(lantern.flame);
            }
        }
        world.insert(e, Interpolated{});
    }
}

// Where the level's moon shines from, if it has one.
vec3 towards_moon(World& world) {
    constexpr vec3 kElsewhere(-0.75f, 0.5f, 0.43f);
    const Entity moon = find_by_name(world, "moon");
    return moon && world.has<LightComponent>(moon) ? vec3(world.get<WorldTransform>(moon).matrix[2])
                                                   : kElsewhere;
}

}  // namespace

void load_level(App& app, const SceneData& scene) {
    World& world = app.world();
    spawn_scene(app, scene);
    refuse_several_levels(world, scene.source);
    start_clip(world, scene.source);
    start_player(world, scene.source);
    start_figures(world, scene.source);
    start_cloths(world, scene.source);
    start_doors(world);
    start_moving_things(world);
    start_crystals(world, scene.source);
    start_lanterns(world, scene.source);
    world.insert_resource(Backdrop{night_sky(towards_moon(world))});
}

}  // namespace lanthorn::game
