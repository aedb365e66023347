// What the schedules gain by threads: a scene's fixed step and frame without OpenGL (animation, transforms,
// physics, morphs, skinning, subdivision, bounds, extraction), one App on one thread beside one on all, frame
// by frame in turns. Prints medians in milliseconds, by system and of the whole.
//   bench_runtime SCENE.glb [FRAMES]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"

using namespace lanthorn;

namespace {

class Stage {
  public:
    Stage(const std::string& file, int threads) {
        add_scene_plugins(app_);
        app_.set_threads(threads);
        spawn_scene(app_, import_gltf(file), BadExtras::skip);
        play_clip(app_.world(), "", file);
    }

    void frame(bool measured) {
        const double start = support::wall_ms();
        app_.frame(kStepSeconds);
        const double whole = support::wall_ms() - start;
        if (!measured) {
            return;
        }
        whole_.push_back(whole);
        for (const auto& [phase, schedule] :
             {std::pair("step", &app_.fixed_schedule()), std::pair("frame", &app_.frame_schedule())}) {
            for (const ecs::Schedule::Report& r : schedule->report()) {
                systems_[fmt::format("{} {}", phase, r.name)].push_back(1e3 * r.seconds);
            }
        }
    }

    double whole() const { return support::median(whole_); }
    std::map<std::string, double> systems() const {
        std::map<std::string, double> medians;
        for (const auto& [name, values] : systems_) {
            medians[name] = support::median(values);
        }
        return medians;
    }

  private:
    App app_;
    std::vector<double> whole_;
    std::map<std::string, std::vector<double>> systems_;
};

void print(const std::string& name, double one, double all) {
    fmt::print("{:<28}{:>12.3f}{:>14.3f}{:>9.2f}\n", name, one, all, all > 0 ? one / all : 0.0);
}

void run(const std::string& file, int frames) {
    Stage one(file, 1);
    Stage all(file, 0);
    for (int i = 0; i <= frames; ++i) {
        one.frame(i > 0);
        all.frame(i > 0);
    }
    fmt::print("{}, medians of {} frames\n{:<28}{:>12}{:>14}{:>9}\n", file, frames, "ms", "one thread",
               "all threads", "gain");
    const std::map<std::string, double> parallel = all.systems();
    for (const auto& [name, ms] : one.systems()) {
        if (ms > 0.01) {
            print(name, ms, parallel.at(name));
        }
    }
    print("step and frame", one.whole(), all.whole());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fmt::print(stderr, "bench_runtime: expected SCENE.glb [FRAMES]\n");
        return 2;
    }
    try {
        run(argv[1], argc > 2 ? std::max(1, std::atoi(argv[2])) : 20);
    } catch (const Error& error) {
        fmt::print(stderr, "bench_runtime: {}\n", error.what());
        return 1;
    }
}
