#include "lanthorn/scene/extras.h"

#include <map>
#include <memory>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {
namespace {

std::string node_place(const ecs::World& world, ecs::Entity e, std::size_t index) {
    const Name* name = world.try_get<Name>(e);
    return name != nullptr ? "node '" + name->value + "'" : "node " + std::to_string(index);
}

}  // namespace

ecs::EntityNames names_of(const ecs::World& world, std::span<const ecs::Entity> entities) {
    auto by_name = std::make_shared<std::map<std::string, ecs::Entity, std::less<>>>();
    for (const ecs::Entity e : entities) {
        if (const Name* name = world.try_get<Name>(e)) {
            by_name->emplace(name->value, e);
        }
    }
    ecs::EntityNames names;
    names.find = [by_name](std::string_view name) {
        const auto found = by_name->find(name);
        return found != by_name->end() ? found->second : ecs::kNullEntity;
    };
    names.name = [&world](ecs::Entity e) {
        const Name* name = world.try_get<Name>(e);
        return name != nullptr ? name->value : ecs::to_string(e);
    };
    return names;
}

std::vector<std::string> apply_extras(ecs::World& world, const ecs::Registry& registry,
                                      std::span<const ecs::Entity> entities, std::string_view source,
                                      BadExtras bad) {
    std::vector<std::string> lines;
    std::vector<std::pair<ecs::Entity, ecs::ExtrasReading>> found;
    const ecs::EntityNames names = names_of(world, entities);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const Extras* extras = world.try_get<Extras>(entities[i]);
        if (extras == nullptr || extras->json.empty()) {
            continue;
        }
        ecs::ExtrasReading reading = ecs::read_extras(registry, extras->json, names);
        const auto tell = [&](const ecs::JsonProblem& problem, const char* outcome) {
            const std::string place = node_place(world, entities[i], i);
            if (bad == BadExtras::refuse) {
                throw InputError(source, place, problem.line());
            }
            lines.push_back((source.empty() ? "" : std::string(source) + ": ") + place + ": " +
                            problem.line() + outcome);
        };
        for (const ecs::JsonProblem& problem : reading.skipped) {
            tell(problem, ": skipped");
        }
        for (const ecs::JsonProblem& problem : reading.ignored) {
            tell(problem, ": ignored");
        }
        if (!reading.types.empty()) {
            found.emplace_back(entities[i], std::move(reading));
        }
    }
    for (const auto& [entity, reading] : found) {
        for (std::size_t k = 0; k < reading.types.size(); ++k) {
            reading.types[k]->insert(world, entity, reading.values[k].get());
        }
    }
    return lines;
}

}  // namespace lanthorn
