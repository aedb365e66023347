#include "tools/lanthorn/replay/heavy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"

namespace lanthorn::tools {

namespace {

constexpr int kLoads = 100;  // into one App before another is made

std::string saved(const ReplayedLevel& replayed) {
    return ecs::Snapshot::save(replayed.world(), replayed.app().registry()).to_bytes();
}

void load(ReplayedLevel& into, std::uint64_t step, const std::string& state) {
    into.session().jump(
        session::Moment(step, ecs::Snapshot::from_bytes(state, into.app().registry(), "state")));
}

std::vector<std::uint64_t> hashes(const ReplayedLevel& replayed) {
    return ecs::state_hashes(replayed.app().registry(), replayed.world());
}

std::string differing(const ReplayedLevel& one, const std::vector<std::uint64_t>& a,
                      const std::vector<std::uint64_t>& b) {
    const std::vector<std::string> names = ecs::state_parts(one.app().registry());
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (a[i] != b[i]) {
            parts.push_back(names[i]);
        }
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

// Every state by itself. Returns what is wrong; counts what is right.
std::string load_every_state(const LevelFile& level, const std::string& file,
                             const std::shared_ptr<const replay::Recording>& recording, std::uint64_t every,
                             const ReplayChoice& choice, std::uint64_t& states) {
    const auto made = [&] {
        auto replayed = std::make_unique<ReplayedLevel>(level, file, recording, choice);
        replayed->app().world().resource_mut<Time>().key_every = 1;
        return replayed;
    };
    const auto kept = made();
    std::unique_ptr<ReplayedLevel> loaded;
    while (!kept->session().done()) {
        const std::uint64_t step = kept->session().steps();
        if (step == 0 || step % every != 0) {
            kept->app().step();
            continue;
        }
        if (states % kLoads == 0) {
            loaded = made();
        }
        load(*loaded, step, saved(*kept));
        if (const auto a = hashes(*kept), b = hashes(*loaded); a != b) {
            return fmt::format("step {}: {} lost in saving and loading", step, differing(*kept, a, b));
        }
        kept->app().step();
        loaded->app().step();
        if (const auto a = hashes(*kept), b = hashes(*loaded); a != b) {
            return fmt::format("step {}: {} goes on differently after loading", step, differing(*kept, a, b));
        }
        ++states;
    }
    return "";
}

// From key step to key step, against the recording.
std::string go_on_from_key_steps(const LevelFile& level, const std::string& file,
                                 const std::shared_ptr<const replay::Recording>& recording,
                                 const ReplayChoice& choice, std::uint64_t& key_steps) {
    ReplayedLevel kept(level, file, recording, choice);
    std::unique_ptr<ReplayedLevel> loaded;
    while (!kept.session().done()) {
        const std::uint64_t step = kept.session().steps();
        if (step > 0 && step % kKeySteps == 0) {
            loaded = std::make_unique<ReplayedLevel>(level, file, recording, choice);
            load(*loaded, step, saved(kept));
            ++key_steps;
        }
        kept.app().step();
        if (!loaded) {
            continue;
        }
        loaded->app().step();
        if (const auto a = hashes(kept), b = hashes(*loaded); a != b) {
            return fmt::format("step {}: {} differs after a seek to key step {}", step, differing(kept, a, b),
                               step / kKeySteps * kKeySteps);
        }
    }
    return "";
}

}  // namespace

Check heavy_check(const LevelFile& level, const std::string& file,
                  const std::shared_ptr<const replay::Recording>& recording, std::uint64_t every,
                  const ReplayChoice& choice) {
    std::uint64_t states = 0, key_steps = 0;
    std::string wrong = load_every_state(level, file, recording, every, choice, states);
    if (wrong.empty()) {
        wrong = go_on_from_key_steps(level, file, recording, choice, key_steps);
    }
    if (!wrong.empty()) {
        return {"heavy", Check::Verdict::failed, wrong};
    }
    return {"heavy", Check::Verdict::ok,
            fmt::format("{} states saved, loaded and gone on from, to the bit; {} seeks to key steps", states,
                        key_steps)};
}

}  // namespace lanthorn::tools
