#include "game/presentation/campaign_flow.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "game/rules/components.h"

namespace lanthorn::game {

CampaignFlow::CampaignFlow(const Options& options, Notices& notices, Stage stage)
    : options_(options),
      notices_(notices),
      stage_(std::move(stage)),
      progress_(
          options.straight || options.tour ? std::filesystem::path() : shell::data_file(kProgram, "progress"),
          [this](const std::string& line) { notices_.add(line); }),
      level_(options) {
    screens_.levels = static_cast<int>(level_.files().size());
}

void CampaignFlow::begin() {
    if (options_.straight || options_.tour) {
        screens_.at = Screen::play;
        screens_.begun = true;
        screens_.once = !options_.record.empty() || !options_.replay.empty();
        load(0);
    } else {
        resume();
    }
}

// The first one from `level` on, and around; nothing: all are solved.
std::optional<int> CampaignFlow::next_unsolved(int level) const {
    for (int i = 0; i < screens_.levels; ++i) {
        const int one = (level + i) % screens_.levels;
        if (!progress_.solved(level_.file(one))) {
            return one;
        }
    }
    return std::nullopt;
}

// Behind the title is the level that the player goes on with.
void CampaignFlow::resume() {
    const std::optional<int> found = progress_.read(level_.files());
    screens_.begun = found.has_value();
    screens_.level = found.value_or(0);
    const std::optional<int> unsolved = next_unsolved(screens_.level);
    if (screens_.begun && unsolved && *unsolved != screens_.level) {
        screens_.level = *unsolved;
        load(screens_.level);
        return;
    }
    load(screens_.level);
    if (!screens_.begun) {
        return;
    }
    try {
        progress_.restore(level_);
        level_.keep_no_session();
    } catch (const InputError& e) {
        notices_.add(std::string(e.what()) + "; it starts from its beginning");
    }
}

void CampaignFlow::load(int level) {
    solved_.forget();
    loaded_ = true;
    stage_.announce();
    try {
        level_.load(level, stage_.spending()).set_devices(stage_.input);
    } catch (const InputError& e) {
        if (options_.straight || options_.tour) {
            throw;
        }
        level_.drop();
        notices_.add(e.what());
        screens_.at = Screen::title;
        screens_.begun = false;
    }
}

void CampaignFlow::keep_progress() {
    if (screens_.begun) {
        progress_.keep(level_, screens_.level);
    }
}

void CampaignFlow::follow(const Event& event) {
    screens_.unsolved = next_unsolved(0);
    const Change change = game::follow(screens_, event);
    screens_ = change.to;
    switch (change.effect) {
        case Effect::none:
            break;
        case Effect::load:
            load(screens_.level);
            break;
        case Effect::refuse:
            notices_.add(options_.record.empty() ? "a replay cannot begin again"
                                                 : "a recording cannot begin again");
            break;
        case Effect::keep:
            keep_progress();
            break;
        case Effect::quit:
            keep_progress();
            quit_ = true;
            break;
    }
}

void CampaignFlow::pass(double seconds) {
    if (!options_.tour) {
        if (solved_.pass(solved(level_.played()->world()), seconds) && !options_.straight) {
            follow({Happening::solved});
        }
    } else if (tour_.pass(level_, screens_.level, seconds)) {
        if (screens_.level + 1 == screens_.levels) {
            quit_ = true;
        } else {
            load(++screens_.level);
        }
    }
}

bool CampaignFlow::ended() const {
    return quit_ || (options_.straight && !options_.tour && level_.played()->session().done());
}

ExitCode CampaignFlow::end(const StopSignal& stop) {
    if (!quit_) {
        keep_progress();  // the window was closed
    }
    if (!tour_.solved_all()) {
        return ExitCode::check_failed;
    }
    if (level_.played() == nullptr) {
        return ExitCode::ok;
    }
    Playthrough& playthrough = *level_.played();
    session::Session& session = playthrough.session();
    session.finish();
    playthrough.say_stopped(stop);
    if (const std::string divergence = session.divergence(); !divergence.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options_.replay.c_str(), divergence.c_str());
        return ExitCode::check_failed;
    }
    const bool asked = !options_.record.empty();  // else it is kept in any case, where that can be
    return asked && session.recording_failed() ? ExitCode::bad_input : ExitCode::ok;
}

}  // namespace lanthorn::game
