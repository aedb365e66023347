#include "tools/lanthorn/replay/seek.h"

#include <optional>

#include "lanthorn/ecs/snapshot.h"

namespace lanthorn::tools {

std::uint64_t seek(ReplayedLevel& replayed, std::uint64_t step, const StateCache& cache) {
    const ecs::Registry& registry = replayed.app().registry();
    const std::optional<StateCache::Found> state = cache.before(step);
    if (state && state->step > replayed.session().steps()) {
        replayed.session().jump(
            session::Moment(state->step, ecs::Snapshot::from_bytes(state->bytes, registry, "cache")));
    }
    const std::uint64_t begun = replayed.session().steps();
    while (replayed.session().steps() < step) {
        replayed.app().step();
        const std::uint64_t now = replayed.session().steps();
        if (now % kKeySteps == 0) {
            cache.keep(now, ecs::Snapshot::save(replayed.world(), registry).to_bytes());
        }
    }
    return begun;
}

}  // namespace lanthorn::tools
