// Plays the game for a long time with random input, and counts what it holds: heap and resident set, GPU
// bytes and objects, descriptors, threads. tools/soak calls it.
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "engine/shell/holdings.h"
#include "game/level/campaign.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/ecs/workers_end.h"
#include "lanthorn/gpu/context.h"
#include "tests/gpu/game/wanderer.h"
#include "tests/soak/growth.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

class Until {
  public:
    Until(double minutes, const StopSignal& stop)
        : end_(Clock::now() + std::chrono::milliseconds(static_cast<long>(60'000 * minutes))), stop_(stop) {}
    bool reached() const { return stopped() || Clock::now() >= end_; }
    bool stopped() const { return stop_.asked(); }

  private:
    Clock::time_point end_;
    const StopSignal& stop_;
};

// Without a window: level after level, each loaded, played, changed, saved, restored, and left. Three rounds
// at least, however long they take: of fewer nothing can be said. Every visit of a level has the same input,
// since what is held depends on what moves: visits can be held against each other.
std::vector<Sample> play_without_window(const Until& until, unsigned seed) {
    constexpr int kFrames = 16, kRounds = 3;
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    std::vector<Sample> samples;
    for (int round = 0; round < kRounds || !until.reached(); ++round) {
        for (const std::string_view name : campaign()) {
            if (until.stopped()) {
                return samples;
            }
            Options options;
            options.level = level_path(name);
            {
                Wanderer wanderer(seed);
                Playthrough level(options, import_gltf(options.level));
                Quality quality(options, level.session().seed());
                quality.draw(level.app(), {"low"});
                level.set_devices([&] { return wanderer.next(); });
                level.app().view().size = ivec2(64, 36);
                const std::string beginning = level.shown().state();
                for (int i = 0; i < kFrames; ++i) {
                    level.app().frame(1.0 / 12, 6);
                    if (i == kFrames / 4) {
                        quality.draw(level.app(), {"medium"});
                    } else if (i == kFrames / 4 + 1) {
                        quality.draw(level.app(), {"low"});
                        level.shown().restore(beginning, "soak");
                    } else if (i > kFrames / 2) {
                        samples.push_back({std::string(name), shell::holdings()});
                    }
                }
            }
            samples.push_back({"no level", shell::holdings()});
        }
    }
    return samples;
}

// What is pressed in a window, as arguments of xdotool.
class Hands {
  public:
    explicit Hands(unsigned seed) : random_(seed) {}

    std::string next() {
        constexpr std::array kWalk = {"w", "a", "s", "d"};
        constexpr std::array kSizes = {"160 90", "160 90", "200 100"};  // few, so that each is seen often
        constexpr std::array kDo = {"e", "f", "g", "c", "r", "t", "h"};
        const std::uint32_t what = random_() % 40;
        if (what < 18) {
            const std::string key = pick(kWalk);
            return "keydown " + key + " sleep 0." + std::to_string(1 + random_() % 8) + " keyup " + key;
        }
        if (what < 28) {
            return std::string("key ") + pick(kDo);
        }
        if (what < 34) {
            return "mousemove_relative -- " + std::to_string(static_cast<int>(random_() % 400) - 200) + ' ' +
                   std::to_string(static_cast<int>(random_() % 60) - 30);
        }
        if (what < 36) {
            return std::string("search --onlyvisible --name lamplighter windowsize ") + pick(kSizes);
        }
        // On the pages: Resume, begin again, levels, options, title are in this order. Of the options the
        // first, the picture's size, is left alone: there is no way back to a small one, and of large ones a
        // software rasteriser draws hardly any.
        constexpr std::array kPages = {"key Escape sleep 0.6 key Escape",
                                       "key Escape sleep 0.6 key Down Return",
                                       "key Escape sleep 0.6 key Down Down Return sleep 0.6 key Right Return",
                                       "key Escape sleep 0.6 key Down Down Return sleep 0.6 key Left Return",
                                       "key Escape sleep 0.6 key Down Down Down Return sleep 0.6 key Down "
                                       "Down Right Left Escape sleep 0.6 key Escape",
                                       "key BackSpace"};
        return pick(kPages);
    }

  private:
    template <std::size_t n>
    const char* pick(const std::array<const char*, n>& of) {
        return of[random_() % n];
    }
    std::minstd_rand random_;
};

// The game in a process of its own; ended with this.
class Game {
  public:
    Game(const std::string& program, const testing_tools::TemporaryFolder& folder) {
        std::filesystem::create_directories(folder.path("lamplighter"));
        child_ = ::fork();
        if (child_ == 0) {
            ::setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
            ::setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
            ::execl(program.c_str(), program.c_str(), "--size", "160x90", "--preset", "low", "--log",
                    folder.path("log").c_str(), nullptr);
            ::_exit(127);
        }
    }
    ~Game() { end(SIGKILL); }
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    bool runs() {
        if (child_ > 0 && ::waitpid(child_, &status_, WNOHANG) == child_) {
            child_ = 0;
        }
        return child_ > 0;
    }
    // The exit code; minus the signal that ended it.
    int end(int signal) {
        if (runs()) {
            ::kill(child_, signal);
            ::waitpid(std::exchange(child_, 0), &status_, 0);
        }
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
    }

  private:
    pid_t child_ = 0;
    int status_ = 0;
};

std::vector<Sample> read_log(const std::string& file) {
    std::vector<Sample> samples;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json at = nlohmann::json::parse(line, nullptr, false);
        if (at.is_discarded() || at["screen"] != "play") {  // a game that is killed leaves half a line
            continue;
        }
        const std::string state = at["level"].get<std::string>() + ' ' + at["preset"].get<std::string>() +
                                  ' ' + at["picture"].dump();
        samples.push_back({state,
                           {.heap = at["heap"],
                            .resident = at["resident"],
                            .gpu = at["gpu"],
                            .textures = at["textures"],
                            .buffers = at["buffers"],
                            .framebuffers = at["framebuffers"],
                            .queries = at["queries"],
                            .programs = at["programs"],
                            .files = at["files"],
                            .threads = at["threads"]}});
    }
    return samples;
}

// In a window of the display that there is.
std::vector<Sample> play_in_window(const Until& until, unsigned seed, const std::string& program,
                                   bool* failed) {
    const testing_tools::TemporaryFolder folder;
    Hands hands(seed);
    Game game(program, folder);
    const auto press = [](const std::string& what) {
        return std::system(("timeout 60 xdotool " + what + " >/dev/null 2>&1").c_str()) == 0;
    };
    if (!press("search --sync --onlyvisible --name lamplighter windowfocus --sync") || !press("key Return")) {
        std::fprintf(stderr, "soak: found no window of the game\n");
        *failed = true;
        return {};
    }
    while (!until.reached() && game.runs()) {
        press(hands.next());
        std::this_thread::sleep_for(100ms);
    }
    const bool ran = game.runs();
    const int code = game.end(SIGTERM);
    if ((!ran || code != 128 + SIGTERM) && !until.stopped()) {
        std::fprintf(stderr, "soak: the game ended by itself or badly, with code %d\n", code);
        *failed = true;
    }
    return read_log(folder.path("log"));
}

// `must_judge`: it is an error if no state was seen `fewest` times.
int judge(const char* how, const std::vector<Sample>& samples, std::size_t fewest, bool must_judge) {
    std::printf("%s: %zu samples; %s\n", how, samples.size(), summary(samples).c_str());
    const std::vector<std::string> lines = growth(samples, fewest);
    for (const std::string& line : lines) {
        std::fprintf(stderr, "soak: %s: grew: %s\n", how, line.c_str());
    }
    const std::size_t judged = states_seen(samples, fewest);
    std::printf("%s: %zu states were seen often enough to judge\n", how, judged);
    if (samples.empty() || (judged == 0 && must_judge)) {
        std::fprintf(stderr, "soak: %s: too little was counted to judge; play longer\n", how);
        return 1;
    }
    return lines.empty() ? 0 : 1;
}

// In a window, a second a sample: what a level makes when it is first needed comes in its first half minute.
constexpr double kMinutesToJudge = 5;

int run(int argc, char** argv) {
    double minutes = 10;
    unsigned seed = 1;
    std::string window;
    CLI::App app{"Plays lamplighter with random input and counts what it holds; exit code 1 if that grows."};
    app.add_option("--minutes", minutes, "how long")
        ->check(CLI::Range(0.05, 100'000.0))
        ->capture_default_str();
    app.add_option("--seed", seed, "of the input")->capture_default_str();
    app.add_option("--window", window,
                   "this program, in a window of the display that there is; else without a window");
    CLI11_PARSE(app, argc, argv);
    const StopSignal stop;
    const Until until(minutes, stop);
    bool failed = false;
    const std::vector<Sample> samples =
        window.empty() ? play_without_window(until, seed) : play_in_window(until, seed, window, &failed);
    const int grew = judge(window.empty() ? "without a window" : "in a window", samples,
                           window.empty() ? 10 : 40, window.empty() || minutes >= kMinutesToJudge);
    return stop.asked() ? stop.exit_code() : failed ? 1 : grew;
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    const lanthorn::ecs::WorkersEndWithMain workers;
    try {
        return lanthorn::game::run(argc, argv);
    } catch (const lanthorn::Error& e) {
        std::fprintf(stderr, "soak: %s\n", e.what());
        return static_cast<int>(e.code());
    }
}
