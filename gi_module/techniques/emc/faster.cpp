#include "gi_module/techniques/emc/faster.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <map>
#include <string>

#include "lanthorn/gpu/context.h"

namespace lanthorn::gi {

namespace {

constexpr double kClearly = 0.8;
constexpr int kRounds = 3;

double now(bool software) {
    glFinish();
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return software ? static_cast<double>(std::clock()) / CLOCKS_PER_SEC
                    : std::chrono::duration<double>(wall).count();
}

}  // namespace

double seconds_of(const std::function<void()>& run) {
    const bool software = gpu::draws_in_software();
    const double start = now(software);
    run();
    return now(software) - start;
}

bool other_is_faster(std::string_view what, const std::function<void()>& usual,
                     const std::function<void()>& other) {
    static std::map<std::string, bool> known;
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string key = std::string(what) + " on " + (renderer != nullptr ? renderer : "");
    if (const auto found = known.find(key); found != known.end()) {
        return found->second;
    }
    usual();  // programs are compiled when they run first
    other();
    double usual_time = std::numeric_limits<double>::infinity();
    double other_time = usual_time;
    for (int round = 0; round < kRounds; ++round) {
        usual_time = std::min(usual_time, seconds_of(usual));
        other_time = std::min(other_time, seconds_of(other));
    }
    return known[key] = other_time < kClearly * usual_time;
}

}  // namespace lanthorn::gi
