#include "tools/lanthorn/replay/minimise.h"

#include <utility>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/replay/reduce_steps.h"

namespace lanthorn::tools {

Minimised minimise(const LevelFile& level, const replay::Recording& recording, Reference& reference,
                   const MinimiseChoice& choice) {
    replay::Recording whole = recording;
    whole.annotations.states.clear();
    whole.cut_off.clear();
    const replay::Recording expected = reference.played(whole);
    const auto step = first_unequal(level, expected, choice.here);
    const auto first = step ? find_cause(level, expected, *step, choice.here, reference) : std::nullopt;
    if (!first) {
        throw InputError(
            "trim --minimise: this build plays these inputs as the other does, expected a difference to "
            "keep");
    }
    Minimised result{expected, *first, 1};
    result.recording.steps.resize(*step + 1);
    // They show it where the first difference has the same system, field and sign; up to there they are kept.
    const auto shows =
        [&](std::vector<replay::RecordedStep> steps) -> std::optional<std::vector<replay::RecordedStep>> {
        const replay::Recording trial =
            reference.played({result.recording.header, std::move(steps), {}, result.recording.annotations});
        const auto differs = first_unequal(level, trial, choice.here);
        const auto cause =
            differs ? find_cause(level, trial, *differs, choice.here, reference, 20, result.cause.system)
                    : std::nullopt;
        if (!cause || !cause->same_as(result.cause)) {
            return std::nullopt;
        }
        result.cause = *cause;
        steps = trial.steps;
        steps.resize(*differs + 1);
        return steps;
    };
    ReducedSteps reduced = reduce_steps(result.recording.steps, shows, choice.seconds, choice.progress);
    result.recording.steps = std::move(reduced.steps);
    result.trials += reduced.trials;
    return result;
}

}  // namespace lanthorn::tools
