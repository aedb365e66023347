#include "tools/lanthorn/replay/seek.h"

#include <optional>

#include "lanthorn/core/error.h"
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

std::vector<replay::StoredState> key_states(const LevelFile& level, const std::string& file,
                                            const std::shared_ptr<const replay::Recording>& recording,
                                            std::uint64_t every) {
    ReplayedLevel replayed(level, file, recording);
    std::vector<replay::StoredState> states;
    while (!replayed.session().done()) {
        const std::uint64_t step = replayed.session().steps();
        if (step > 0 && step % (kKeySteps * every) == 0) {
            states.push_back(
                {step, ecs::Snapshot::save(replayed.world(), replayed.app().registry()).to_bytes()});
        }
        replayed.app().step();
    }
    if (!replayed.comparison().divergences.empty()) {
        throw InputError(
            file, "--states",
            replayed.comparison().divergences.front().describe() + "; expected states as recorded to store");
    }
    return states;
}

}  // namespace lanthorn::tools
