#include "tools/lanthorn/replay/reference.h"

#include <fmt/format.h>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/world_hash.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::tools {

namespace {

class ProgramReference final : public Reference {
  public:
    ProgramReference(std::string program, std::string level)
        : program_(std::move(program)), level_(std::move(level)) {}

    replay::Recording played(const replay::Recording& inputs) override {
        run(inputs, {});
        return replay::read_recording(folder_.at("out").string());
    }
    TracedStep traced(const replay::Recording& inputs, std::uint64_t step,
                      const std::string& after) override {
        std::vector<std::string> more = {"--step", fmt::format("{}", step)};
        if (!after.empty()) {
            more.insert(more.end(), {"--after", after});
        }
        run(inputs, more);
        return read_trace(folder_.at("out").string());
    }

  private:
    void run(const replay::Recording& inputs, const std::vector<std::string>& more) {
        replay::write_recording(folder_.at("inputs.rec").string(), inputs);
        std::vector<std::string> arguments = {program_,  "replay", "state", folder_.at("inputs.rec").string(),
                                              "--level", level_,   "-o",    folder_.at("out").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ChildOutcome outcome = run_child(arguments);
        if (!outcome.ok()) {
            throw InputError(program_, "replay state", outcome.why());
        }
    }
    std::string program_, level_;
    const suite::Scratch folder_ = suite::Scratch::temporary("lanthorn-replay");
};

class OwnReference final : public Reference {
  public:
    OwnReference(const LevelFile& level, ReplayChoice choice) : level_(level), choice_(std::move(choice)) {}

    replay::Recording played(const replay::Recording& inputs) override {
        return played_again(level_, inputs, choice_);
    }
    TracedStep traced(const replay::Recording& inputs, std::uint64_t step,
                      const std::string& after) override {
        ReplayedLevel replayed(level_, "reference", std::make_shared<replay::Recording>(inputs), choice_);
        return trace_step(replayed, step, after);
    }

  private:
    const LevelFile& level_;
    ReplayChoice choice_;
};

}  // namespace

std::unique_ptr<Reference> program_reference(const std::string& program, const std::string& level) {
    return std::make_unique<ProgramReference>(program, level);
}

std::unique_ptr<Reference> own_reference(const LevelFile& level, const ReplayChoice& choice) {
    return std::make_unique<OwnReference>(level, choice);
}

replay::Recording played_again(const LevelFile& level, const replay::Recording& inputs,
                               const ReplayChoice& choice) {
    ReplayedLevel replayed(level, "inputs", std::make_shared<replay::Recording>(inputs), choice);
    replay::Recording result = inputs;
    const ecs::Registry& registry = replayed.app().registry();
    result.header.parts = ecs::state_parts(registry);
    result.header.schemas = ecs::state_schemas(registry);
    result.header.build = build_words();
    result.annotations.states.clear();
    std::vector<std::uint64_t> before;
    for (replay::RecordedStep& step : result.steps) {
        replayed.app().step();
        replay::mark_state(ecs::state_hashes(registry, replayed.world()), before, step);
    }
    return result;
}

}  // namespace lanthorn::tools
