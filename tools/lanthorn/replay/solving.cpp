#include "tools/lanthorn/replay/solving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "game/rules/components.h"
#include "game/rules/player_input.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/runtime/sensor_plugin.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/session/session.h"
#include "tools/lanthorn/replay/expectations.h"
#include "tools/lanthorn/replay/replayed_level.h"
#include "tools/lanthorn/replay/sensor_look.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;
using game::Crystal;
using game::Goal;

constexpr std::uint64_t kLookEvery = 15;  // steps from one picture to the next: a quarter of a second
constexpr std::uint64_t kMore = 300;      // steps behind the last input

// An expectation without the steps that it names: the light of another day comes a little sooner or later.
std::string without_steps(const std::string& line) {
    for (const char* word : {" before ", " after "}) {
        if (const std::size_t at = line.rfind(word); at != std::string::npos) {
            return line.substr(0, at);
        }
    }
    return line;
}

double seconds(std::uint64_t step) {
    return static_cast<double>(step) / kStepsPerSecond;
}

// Looks at a session step by step.
class Witness {
  public:
    Witness(std::string file, const std::vector<std::string>& lines) : file_(std::move(file)) {
        for (const std::string& line : lines) {
            const std::string what = without_steps(line);
            // What crystals do is looked at by itself.
            if (what != "solved" && what.find(" crystal.") == std::string::npos) {
                expected_.push_back({what, Expectations(file_, {what})});
            }
        }
    }

    void look(const ecs::World& world, const ecs::Registry& registry, std::uint64_t step) {
        world.query<ecs::Read<Crystal>, ecs::Read<LightSensor>, ecs::Read<Name>>().each(
            [&](const Crystal& crystal, const LightSensor& sensor, const Name& name) {
                read(name.value, crystal.lux, crystal.seconds, sensor.lux, crystal.charge, step);
                if (crystal.awake) {
                    happened(name.value + " wakes", name.value, step);
                }
            });
        world.query<ecs::Read<Goal>, ecs::Read<LightSensor>, ecs::Read<Name>>().each(
            [&](const Goal& goal, const LightSensor& sensor, const Name& name) {
                read(name.value, goal.lux, 0, sensor.lux, 0, step);
                if (goal.reached) {
                    happened(name.value + " is reached", name.value, step);
                }
            });
        for (Expected& one : expected_) {
            if (!one.at) {
                one.expectations.look(world, registry, step);
                if (one.expectations.check().verdict == Check::Verdict::ok) {
                    one.at = step;
                    happened(one.what, "", step);
                }
            }
        }
        if (!solved_at_ && game::solved(world)) {
            solved_at_ = step;
        }
    }

    // What the level asks for, whether it has happened or not.
    std::vector<Solving::Event> all() const {
        std::vector<Solving::Event> events = events_;
        const auto add = [&](const std::string& what, const std::string& crystal) {
            if (std::ranges::find(events, what, &Solving::Event::what) == events.end()) {
                events.push_back({what, crystal, std::nullopt, std::nullopt});
            }
        };
        for (const Solving::Reading& one : readings_) {
            add(one.name + (one.seconds > 0 ? " wakes" : " is reached"), one.name);
        }
        for (const Expected& one : expected_) {
            add(one.what, "");
        }
        return events;
    }
    const std::vector<Solving::Reading>& readings() const { return readings_; }
    std::optional<std::uint64_t> solved_at() const { return solved_at_; }

  private:
    struct Expected {
        std::string what;
        Expectations expectations;
        std::optional<std::uint64_t> at = {};
    };

    void read(const std::string& name, double needed, double for_seconds, double lux, double charge,
              std::uint64_t step) {
        auto found = std::ranges::find(readings_, name, &Solving::Reading::name);
        if (found == readings_.end()) {
            readings_.push_back({name, needed, 0, for_seconds, 0, 0});
            found = readings_.end() - 1;
        }
        if (lux > found->most) {
            found->most = lux;
            found->most_at = step;
        }
        found->charge = std::max(found->charge, charge);
    }
    void happened(const std::string& what, const std::string& crystal, std::uint64_t step) {
        if (std::ranges::find(events_, what, &Solving::Event::what) == events_.end()) {
            events_.push_back({what, crystal, std::nullopt, step});
        }
    }

    std::string file_;
    std::vector<Expected> expected_;
    std::vector<Solving::Event> events_;  // that have happened, in their order
    std::vector<Solving::Reading> readings_;
    std::optional<std::uint64_t> solved_at_;
};

// What happens in the recording itself; nothing where the level that it was made in is not at hand any more.
std::optional<Witness> as_recorded(const std::string& file,
                                   const std::shared_ptr<const replay::Recording>& recording) {
    try {
        const auto level = read_level(file, recording->header, "");
        if (level->hash != recording->header.level_hash) {
            return std::nullopt;
        }
        ReplayedLevel played(*level, file, recording);
        Witness witness(file, recording->annotations.expectations);
        while (!played.session().done()) {
            played.app().step();
            witness.look(played.world(), played.app().registry(), played.session().steps());
        }
        return witness;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

session::InputStream inputs_of(const std::string& file,
                               const std::shared_ptr<const replay::Recording>& recording) {
    const replay::RecordingHeader& header = recording->header;
    if (header.input_format != game::kInputFormat || header.input_size != sizeof(game::PlayerInput)) {
        throw InputError(file, "input",
                         fmt::format("found '{}', expected '{}'", header.input_format, game::kInputFormat));
    }
    return session::InputStream::of<game::PlayerInput>(
        game::kInputFormat,
        [recording](const ecs::World&, std::uint64_t step) {
            game::PlayerInput input;
            if (step < recording->steps.size()) {
                std::memcpy(static_cast<void*>(&input), recording->steps[step].input.data(), sizeof input);
            }
            return input;
        },
        recording->steps.size());
}

}  // namespace

const Solving::Event* Solving::first_missing() const {
    const auto found = std::ranges::find_if(events, [](const Event& event) { return !event.now; });
    return found == events.end() ? nullptr : &*found;
}

const Solving::Reading* Solving::reading(const std::string& name) const {
    const auto found = std::ranges::find(readings, name, &Reading::name);
    return found == readings.end() ? nullptr : &*found;
}

std::string Solving::words() const {
    if (solved_at) {
        const std::string then = recorded_at && *recorded_at != *solved_at
                                     ? fmt::format(", in the recording at {}", *recorded_at)
                                     : std::string();
        return fmt::format("solved at step {} ({:.1f} s{})", *solved_at, seconds(*solved_at), then);
    }
    const Event* missing = first_missing();
    if (missing == nullptr) {
        return fmt::format("not solved in {} steps", steps);
    }
    std::string why = missing->what + ": never";
    if (const Reading* read = missing->crystal.empty() ? nullptr : reading(missing->crystal)) {
        if (read->most < read->needed) {
            why = fmt::format("{} had at most {:.3g} lx (step {}), needs {:.3g} lx", read->name, read->most,
                              read->most_at, read->needed);
        } else {
            why = fmt::format(
                "{} had {:.3g} lx (step {}), and needs {:.3g} lx for {:.3g} s: it came to {:.0f} %",
                read->name, read->most, read->most_at, read->needed, read->seconds, 100 * read->charge);
        }
    }
    const std::string then = missing->recorded
                                 ? fmt::format("; in the recording it is done at step {}", *missing->recorded)
                                 : std::string();
    return fmt::format("not solved: {}{}", why, then);
}

Solving solve_again(const std::string& file, const std::string& level,
                    const std::function<bool(std::uint64_t, std::uint64_t)>& at_step) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const auto changed = read_level(file, recording->header, level);
    SensorLook look;
    ShownScene shown([&](App& app) {
        app.add<SensorPlugin>().add<game::GamePlugin>();
        app.set_threads(1);
        game::load_level(app, changed->scene);
    });
    App& app = shown.app();
    look.draw(app, recording->header.seed);
    session::Config config;
    config.content = fs::path(changed->path).filename().string();
    config.content_hash = changed->hash;
    config.seed = recording->header.seed;
    const session::Session session(app, inputs_of(file, recording), config);

    Witness witness(file, recording->annotations.expectations);
    Solving solving;
    const std::uint64_t steps = recording->steps.size();
    for (; solving.steps < steps || (!witness.solved_at() && solving.steps < steps + kMore);) {
        app.step();
        ++solving.steps;
        if (solving.steps % kLookEvery == 0) {
            app.show_at(seconds(solving.steps));
        }
        witness.look(shown.world(), app.registry(), solving.steps);
        if (witness.solved_at() || !at_step(solving.steps, steps)) {
            break;
        }
    }
    solving.solved_at = witness.solved_at();
    solving.readings = witness.readings();
    const std::optional<Witness> recorded = as_recorded(file, recording);
    if (!recorded) {
        solving.events = witness.all();
        return solving;
    }
    solving.recorded_at = recorded->solved_at();
    const std::vector<Solving::Event> now = witness.all();
    for (const Solving::Event& event : recorded->all()) {
        const auto found = std::ranges::find(now, event.what, &Solving::Event::what);
        if (found != now.end()) {  // what was taken out of the level need not happen any more
            solving.events.push_back({event.what, event.crystal, event.now, found->now});
        }
    }
    for (const Solving::Event& event : now) {
        if (std::ranges::find(solving.events, event.what, &Solving::Event::what) == solving.events.end()) {
            solving.events.push_back(event);
        }
    }
    return solving;
}

fs::path recording_of(const fs::path& level) {
    const std::string name = level.stem().string() + ".rec";
    std::error_code ignored;
    for (const fs::path& folder :
         {level.parent_path(), fs::path(LANTHORN_SOURCE_ASSETS) / ".." / "tests" / "replay"}) {
        if (fs::is_regular_file(folder / name, ignored)) {
            return (folder / name).lexically_normal();
        }
    }
    return {};
}

std::string to_json(const Solving& solving) {
    using Json = nlohmann::ordered_json;
    const auto step = [](const std::optional<std::uint64_t>& at) { return at ? Json(*at) : Json(); };
    Json json = {{"solved", solving.solved_at.has_value()},
                 {"words", solving.words()},
                 {"solved_at", step(solving.solved_at)},
                 {"recorded_at", step(solving.recorded_at)},
                 {"steps", solving.steps},
                 {"events", Json::array()},
                 {"readings", Json::array()}};
    for (const Solving::Event& event : solving.events) {
        json["events"].push_back(
            {{"what", event.what}, {"now", step(event.now)}, {"recorded", step(event.recorded)}});
    }
    for (const Solving::Reading& read : solving.readings) {
        json["readings"].push_back({{"name", read.name},
                                    {"needed_lux", read.needed},
                                    {"most_lux", read.most},
                                    {"most_at", read.most_at},
                                    {"charge", read.charge}});
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lanthorn::tools
