// How long it takes to go to a step of a long recording: the inputs of a short one, over and over.
//   bench_seek pool 216000
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "lanthorn/core/error.h"
#include "tests/support/clocks.h"
#include "tests/support/repository.h"
#include "tools/lanthorn/replay/judge.h"
#include "tools/lanthorn/replay/reference.h"
#include "tools/lanthorn/replay/seek.h"

namespace {

using namespace lanthorn;
using namespace lanthorn::tools;
namespace fs = std::filesystem;

// Wall and processor time since it was made.
class Clock {
  public:
    std::string words() const {
        return fmt::format("{:.3f} s ({:.3f} s of processor time)", support::wall_seconds() - wall_,
                           support::processor_seconds() - processor_);
    }

  private:
    double wall_ = support::wall_seconds();
    double processor_ = support::processor_seconds();
};

replay::Recording repeated(const replay::Recording& recording, std::size_t steps) {
    replay::Recording inputs = recording;
    inputs.steps.clear();
    for (std::size_t i = 0; i < steps; ++i) {
        inputs.steps.push_back(recording.steps[i % recording.steps.size()]);
    }
    return inputs;
}

// To a step, as a program does that has just begun.
void seek_afresh(const std::string& file, const LevelFile& level, std::uint64_t step) {
    const Clock all;
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const std::string reading = all.words();
    ReplayedLevel replayed(level, file, recording);
    const Clock seeking;
    const std::uint64_t begun = seek(replayed, step, StateCache(key_of(file, level)));
    fmt::print("seek to step {} from {}: {}; with reading ({}) and the level's App {}\n", step, begun,
               seeking.words(), reading, all.words());
    replayed.app().step();
    if (!replayed.comparison().divergences.empty()) {
        fmt::print("differs: {}\n", replayed.comparison().divergences.front().describe());
    }
}

void run(const std::string& name, std::size_t steps, const fs::path& folder) {
    const std::string source = support::repository_file("tests/replay/" + name + ".rec");
    const replay::Recording recording = replay::read_recording(source);
    const auto level = read_level(source, recording.header, "");
    const std::string file = (folder / "long.rec").string();
    replay::write_recording(file, played_again(*level, repeated(recording, steps), {}));
    fmt::print("{} steps ({:.1f} min): {} bytes\n", steps, static_cast<double>(steps) / 3600,
               fs::file_size(file));
    const Clock playing;
    {
        ReplayedLevel replayed(*level, file,
                               std::make_shared<const replay::Recording>(replay::read_recording(file)));
        seek(replayed, steps, StateCache(key_of(file, *level)));
        fmt::print("played from the beginning in {}; {} states differ\n", playing.words(),
                   replayed.comparison().divergences.size());
    }
    std::uintmax_t bytes = 0, states = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".state") {
            bytes += entry.file_size();
            ++states;
        }
    }
    fmt::print("{} states in the cache, {} bytes each\n", states,
               bytes / std::max<std::uintmax_t>(states, 1));
    for (const std::uint64_t share : {1, 2, 3}) {
        const std::uint64_t key = steps * share / 3 / kKeySteps * kKeySteps;
        seek_afresh(file, *level, std::min<std::uint64_t>(key + kKeySteps, steps) - 1);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("lanthorn-seek-{}", ::getpid());
    fs::create_directories(folder);
    ::setenv("XDG_CACHE_HOME", folder.c_str(), 1);
    int code = 0;
    try {
        run(argc > 1 ? argv[1] : "pool", argc > 2 ? std::stoul(argv[2]) : 216000, folder);
    } catch (const std::exception& e) {
        fmt::print(stderr, "bench_seek: {}\n", e.what());
        code = 2;
    }
    fs::remove_all(folder);
    return code;
}
