// Hooks of World: keeping and calling them.
#include <algorithm>

#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

HookId World::hook_in(const ComponentInfo& info, bool add, Hook hook) {
    if (info.id >= hooks_.size()) {
        hooks_.resize(info.id + 1);
    }
    if (!hooks_[info.id]) {
        hooks_[info.id] = std::make_unique<GivenHooks>();
        for (const auto& archetype : archetypes_) {
            archetype->hooked = archetype->hooked || archetype->has(info.id);
        }
    }
    const HookId id{++hooks_given_};
    GivenHooks& given = *hooks_[info.id];
    (add ? given.add : given.remove).push_back({id, std::make_shared<const Hook>(std::move(hook))});
    return id;
}

void World::unhook(HookId id) {
    for (const auto& given : hooks_) {
        if (!given) {
            continue;
        }
        for (auto* list : {&given->add, &given->remove}) {
            for (GivenHook& hook : *list) {
                // Its place stays: the list may be on its way through.
                if (hook.id.number == id.number) {
                    hook.call = nullptr;
                }
            }
        }
    }
}

void World::call_hooks(Entity e, const ComponentInfo& info, bool add) {
    if (const detail::HookFunction own = add ? info.on_add : info.on_remove) {
        own(*this, e);
    }
    if (info.id >= hooks_.size() || !hooks_[info.id]) {
        return;
    }
    const GivenHooks& given = *hooks_[info.id];
    const std::vector<GivenHook>& list = add ? given.add : given.remove;
    // Hooks given meanwhile are for the next time.
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < count && find_component(e, info); ++i) {
        if (const std::shared_ptr<const Hook> hook = list[i].call) {
            (*hook)(*this, e);
        }
    }
}

void World::announce_added(Entity e, const ComponentInfo& info) {
    call_hooks(e, info, true);
}

void World::announce_created(Entity e, const Archetype& archetype) {
    for (const ComponentInfo* info : archetype.components()) {
        // An earlier hook may have taken it off again.
        if (hooked(*info) && find_component(e, *info)) {
            call_hooks(e, *info, true);
        }
    }
}

void World::announce_removal(Entity e, const ComponentInfo& info) {
    const ComponentInfo* const infos[] = {&info};
    announce_leaving(e, infos);
}

void World::announce_destruction(Entity e, const Archetype& archetype) {
    announce_leaving(e, archetype.components());
}

bool World::leaving(Entity e) const {
    return std::find(leaving_.begin(), leaving_.end(), e) != leaving_.end();
}

void World::announce_leaving(Entity e, std::span<const ComponentInfo* const> infos) {
    if (leaving(e)) {
        throw Error("a hook removes or destroys " + to_string(e) +
                    ", which is being removed from or destroyed");
    }
    const Archetype* const archetype = row_of(e).archetype;
    struct Leaving {
        std::vector<Entity>& list;
        Leaving(std::vector<Entity>& l, Entity entity) : list(l) { list.push_back(entity); }
        Leaving(const Leaving&) = delete;
        Leaving& operator=(const Leaving&) = delete;
        ~Leaving() { list.pop_back(); }
    } const leaving(leaving_, e);
    for (const ComponentInfo* info : infos) {
        if (hooked(*info)) {
            call_hooks(e, *info, false);
        }
    }
    if (row_of(e).archetype != archetype) {
        throw Error("a hook of removal changed which components " + to_string(e) + ", its own entity, has");
    }
}

}  // namespace lanthorn::ecs
