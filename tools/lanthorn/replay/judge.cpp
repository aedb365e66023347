#include "tools/lanthorn/replay/judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iterator>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/replay/content_hash.h"
#include "tools/lanthorn/replay/expectations.h"
#include "tools/lanthorn/replay/heavy.h"
#include "tools/lanthorn/replay/sensor_look.h"

namespace lanthorn::tools {

namespace {

double cpu_now() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Check live(const replay::Comparison& c, const replay::Recording& recording, const Expectations& expected) {
    const auto ever = std::ranges::count_if(c.changed, [](std::uint64_t n) { return n > 0; });
    Check check{"live", Check::Verdict::ok,
                fmt::format("{} steps changed something, {} of {} parts", c.live, ever, c.parts.size())};
    if (expected.solved_at()) {
        check.text += fmt::format("; solved at step {}", *expected.solved_at());
    }
    if (c.live == 0) {
        check.verdict = Check::Verdict::failed;
        check.text = recording.steps.empty() ? "no steps: nothing is proved"
                                             : "no step changed anything: nothing is proved";
    }
    return check;
}

Check state(const replay::Comparison& c, double step_rate, std::size_t resynchronised) {
    const std::string parts =
        c.not_compared.empty()
            ? fmt::format("all {} parts", c.parts.size())
            : fmt::format("{} parts compared; not: {}", c.parts.size(), fmt::join(c.not_compared, ", "));
    const char* by = c.roots ? "" : ", by tags alone";
    if (c.steps == 0) {
        return {"state", Check::Verdict::none, "no steps to compare"};
    }
    if (c.divergences.empty()) {
        return {
            "state", Check::Verdict::ok,
            fmt::format(
                "{} steps, {} hashes equal; {}{}{}", c.steps, c.hashes, parts, by,
                c.unknown > 0 ? fmt::format("; {} steps played whose state is not known", c.unknown) : "")};
    }
    const replay::Divergence& first = c.divergences.front();
    return {
        "state", Check::Verdict::failed,
        fmt::format(
            "step {} ({:.2f} s): {} differs; {} steps, {} hashes equal before; {} divergence{} ({}); {}{}",
            first.step, static_cast<double>(first.step) / step_rate,
            first.parts.empty() ? "a part whose tag is the same"
                                : fmt::format("{}", fmt::join(first.parts, ", ")),
            c.equal, c.equal * c.parts.size(), c.divergences.size(), c.divergences.size() == 1 ? "" : "s",
            resynchronised > 0 ? fmt::format("resynchronised {} times", resynchronised)
                               : "no stored state behind it to resynchronise at",
            parts, by)};
}

Check sensors(const replay::SensorCheck& check, std::size_t recorded) {
    if (check.divergence()) {
        return {"sensors", Check::Verdict::failed, check.divergence()->describe()};
    }
    if (check.checked() == 0) {
        return {
            "sensors", Check::Verdict::none,
            fmt::format("{} recorded readings drove it; none was read again: nothing was drawn", recorded)};
    }
    return {"sensors", Check::Verdict::ok,
            fmt::format("{} readings within {} lux and {:.0f} % of those recorded", check.checked(),
                        replay::SensorCheck::kSlack, 100 * replay::SensorCheck::kShare)};
}

std::size_t readings_of(const replay::Recording& recording) {
    std::size_t count = 0;
    for (const replay::RecordedStep& step : recording.steps) {
        count += step.sensors.size();
    }
    return count;
}

// After a difference a replay goes on from the recording's own state, where the file has one: what differs
// from there on has another cause. Whether it did.
bool resynchronise(ReplayedLevel& replayed, const replay::Recording& recording) {
    session::Session& session = replayed.session();
    if (!session.apart()) {
        return false;
    }
    const auto& states = recording.annotations.states;
    const auto state = std::ranges::find(states, session.steps(), &replay::StoredState::step);
    if (state == states.end()) {
        return false;
    }
    const ecs::Registry& registry = replayed.app().registry();
    session.jump(session::Moment(state->step, ecs::Snapshot::from_bytes(state->bytes, registry, "SNAP")));
    return true;
}

// In how many steps each system ran.
class SystemCounts {
  public:
    void add(const ecs::Schedule& schedule) {
        const auto& report = schedule.report();
        counts_.resize(report.size());
        for (std::size_t i = 0; i < report.size(); ++i) {
            counts_[i].first = report[i].name;
            counts_[i].second += report[i].ran ? 1 : 0;
        }
    }
    std::vector<std::pair<std::string, std::uint64_t>> take() { return std::move(counts_); }

  private:
    std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

std::string time_words(const Verdict& v, bool drawn) {
    if (drawn) {
        return "not measured: it was drawn, too";
    }
    return fmt::format(
        "{:.0f} steps a second, {:.0f} times real time; {:.0f} times by processor time; no baseline", v.speed,
        v.speed / v.header.step_rate, v.seconds() / std::max(v.cpu_seconds, 1e-9));
}

}  // namespace

std::string key_of(const std::string& file, const LevelFile& level, const std::string& settings) {
    const std::string text =
        fmt::format("{:016x} {:016x} {} {}", replay::hash_file(file), level.hash, build_words(), settings);
    return fmt::format("{:016x}", replay::hash_bytes(std::as_bytes(std::span(text))));
}

Verdict judge(const std::string& file, const JudgeChoice& choice) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const auto level = read_level(file, recording->header, choice.level);
    Expectations expectations(file, recording->annotations.expectations);
    const auto look = choice.sensors ? std::make_unique<SensorLook>() : nullptr;
    ReplayedLevel replayed(*level, file, recording, {.threads = choice.threads, .extend = choice.extend});

    Verdict v;
    v.file = file;
    v.key = key_of(file, *level, choice.heavy > 0 ? fmt::format("heavy {}", choice.heavy) : "");
    v.header = recording->header;
    v.marks = recording->annotations.marks;
    v.build = build_words();
    v.steps = recording->steps.size();
    v.timeline = timeline_of(*recording);
    v.cut_off = recording->cut_off;
    if (look) {
        look->draw(replayed.app(), replayed.session().seed());
    }
    SystemCounts systems;
    std::size_t resynchronised = 0;
    const double cpu_before = cpu_now();
    const auto before = std::chrono::steady_clock::now();
    while (!choice.marks_alone && !replayed.session().done()) {
        replayed.app().step();
        systems.add(replayed.app().fixed_schedule());
        resynchronised += resynchronise(replayed, *recording) ? 1 : 0;
        expectations.look(replayed.world(), replayed.app().registry(), replayed.session().steps());
        if (look) {
            look->look(replayed.app(), replayed.session().steps(), v.steps);
        }
        if (choice.at_step) {
            choice.at_step(replayed.session().steps());
        }
        if (choice.enough && choice.enough(replayed.session().steps())) {
            break;
        }
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    v.cpu_seconds = cpu_now() - cpu_before;
    v.speed = static_cast<double>(v.steps) / std::max(took.count(), 1e-9);
    v.systems_ran = systems.take();
    v.comparison = replayed.comparison();
    if (!choice.marks_alone) {
        v.checks = {live(v.comparison, *recording, expectations),
                    state(v.comparison, v.header.step_rate, resynchronised),
                    sensors(*replayed.session().sensor_check(), readings_of(*recording)),
                    replayed.session().done()
                        ? expectations.check()
                        : Check{"expectations", Check::Verdict::none, "it was not played to its end"},
                    Check{"time", Check::Verdict::none, time_words(v, look != nullptr)}};
    }
    PictureChoice marks = choice.pictures;
    marks.drawn = [&, n = std::uint64_t{0}]() mutable {
        if (choice.at_step) {
            choice.at_step(v.steps + ++n);
        }
    };
    PictureResults pictures = check_pictures(level, file, recording, marks, choice.threads);
    v.pictures = std::move(pictures.pictures);
    std::ranges::move(pictures.checks, std::back_inserter(v.checks));
    if (choice.heavy > 0) {
        v.checks.push_back(heavy_check(*level, file, recording, choice.heavy,
                                       {.threads = choice.threads, .extend = choice.extend}));
    }
    return v;
}

}  // namespace lanthorn::tools
