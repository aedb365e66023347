#include "tools/lanthorn/replay/cause.h"

#include <algorithm>

#include "lanthorn/ecs/snapshot.h"

namespace lanthorn::tools {

namespace {

// "physics (commands)" is no system of its own.
bool is_commands(const std::string& system) {
    return system.ends_with(" (commands)");
}

// A world that holds a traced state, for its fields to be looked at.
class StateWorld {
  public:
    StateWorld(const LevelFile& level, const replay::Recording& inputs, const std::string& state,
               const std::string& source)
        : holder_(level, source, std::make_shared<replay::Recording>(inputs)) {
        ecs::Snapshot::from_bytes(state, holder_.app().registry(), source).restore(holder_.app().world());
    }
    const ecs::World& world() const { return holder_.world(); }
    const ecs::Registry& registry() const { return holder_.app().registry(); }

  private:
    ReplayedLevel holder_;
};

TracedStep traced_here(const LevelFile& level, const replay::Recording& inputs, std::uint64_t step,
                       const ReplayChoice& here, const std::string& after) {
    ReplayedLevel replayed(level, "inputs", std::make_shared<replay::Recording>(inputs), here);
    return trace_step(replayed, step, after);
}

}  // namespace

bool Cause::same_as(const Cause& other) const {
    if (system != other.system || fields.empty() || other.fields.empty()) {
        return system == other.system && fields.empty() == other.fields.empty();
    }
    const FieldDifference& a = fields.front();
    return std::ranges::any_of(
        other.fields, [&](const FieldDifference& b) { return a.name() == b.name() && a.sign == b.sign; });
}

std::optional<Cause> find_cause(const LevelFile& level, const replay::Recording& inputs, std::uint64_t step,
                                const ReplayChoice& here, Reference& reference, std::size_t most_fields,
                                const std::string& likely) {
    TracedStep found = traced_here(level, inputs, step, here, likely);
    TracedStep expected = reference.traced(inputs, step, likely);
    const std::optional<TraceDifference> difference = first_difference(found, expected);
    if (!difference) {
        return std::nullopt;
    }
    const std::size_t k = difference->system;
    Cause cause;
    cause.step = step;
    cause.parts = difference->parts;
    cause.system = found.systems[k].system;
    for (std::size_t i = 0; i < found.systems.size(); ++i) {
        const bool system = !is_commands(found.systems[i].system);
        cause.systems += system ? 1 : 0;
        cause.position += system && i <= k ? 1 : 0;
    }
    if (cause.system != likely || difference->there != likely) {
        // The same step again, for the states right after that system: what later ones did would hide it.
        found = traced_here(level, inputs, step, here, cause.system);
        expected = reference.traced(inputs, step, difference->there);
    }
    const StateWorld a(level, inputs, found.state, "state here");
    const StateWorld b(level, inputs, expected.state, "state of the reference");
    cause.fields = field_differences(a.registry(), a.world(), b.world(), most_fields + 1);
    cause.more = cause.fields.size() > most_fields;
    cause.fields.resize(std::min(cause.fields.size(), most_fields));
    return cause;
}

std::optional<std::uint64_t> first_unequal(const LevelFile& level, const replay::Recording& expected,
                                           const ReplayChoice& here) {
    ReplayedLevel replayed(level, "inputs", std::make_shared<replay::Recording>(expected), here);
    while (!replayed.session().done() && replayed.comparison().divergences.empty()) {
        replayed.app().step();
    }
    return replayed.comparison().divergences.empty()
               ? std::nullopt
               : std::optional(replayed.comparison().divergences.front().step);
}

}  // namespace lanthorn::tools
