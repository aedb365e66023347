#include "lanthorn/ecs/clone.h"

#include <memory>
#include <unordered_map>

#include "engine/ecs/value_ops.h"
#include "lanthorn/ecs/component_json.h"

namespace lanthorn::ecs {
namespace {

std::vector<Entity> copy(World& world, const World& from, const Registry& registry,
                         std::span<const Entity> originals) {
    // All copies of values are made before the world changes: adding rows moves those there are.
    struct Copied {
        const ComponentType* type;
        std::shared_ptr<void> value;
    };
    std::vector<std::vector<Copied>> copies(originals.size());
    for (std::size_t i = 0; i < originals.size(); ++i) {
        const World::Row row = from.row_of(originals[i]);
        if (!row) {
            World::throw_dead("clone", originals[i]);
        }
        for (const ComponentInfo* info : row.archetype->components()) {
            const ComponentType* type = registry.find(info->id);
            if (type == nullptr) {
                throw Error("clone: " + std::string(info->name) + " of " + to_string(originals[i]) +
                            " is not declared");
            }
            if (type->derived) {
                continue;
            }
            copies[i].push_back({type, type->clone(get(from, originals[i], *type))});
        }
    }
    std::vector<Entity> made;
    std::unordered_map<Entity, Entity> clone_of;
    for (const Entity original : originals) {
        made.push_back(world.create());
        clone_of[original] = made.back();
    }
    const auto renumber = [&](Entity e) {
        const auto found = clone_of.find(e);
        return found != clone_of.end() ? found->second : &world == &from ? e : kNullEntity;
    };
    for (std::size_t i = 0; i < originals.size(); ++i) {
        for (const Copied& copied : copies[i]) {
            renumber_entities(*copied.type->value, copied.value.get(), renumber);
            copied.type->insert(world, made[i], copied.value.get());
        }
    }
    return made;
}

}  // namespace

std::vector<Entity> clone(World& world, const Registry& registry, std::span<const Entity> originals) {
    return copy(world, world, registry, originals);
}

std::vector<Entity> clone_from(World& world, const World& from, const Registry& registry,
                               std::span<const Entity> originals) {
    return copy(world, from, registry, originals);
}

}  // namespace lanthorn::ecs
