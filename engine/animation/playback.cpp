#include "lanthorn/animation/playback.h"

#include <algorithm>
#include <cmath>

namespace lanthorn {

ClipMoment clip_moment(LoopMode mode, double time, double duration) {
    constexpr double kMostRounds = 1e15;  // still exact as integers, and as numbers of seconds
    if (!(duration > 0)) {
        return {};
    }
    switch (mode) {
        case LoopMode::once:
            return {std::clamp(time, 0.0, duration), 0};
        case LoopMode::loop: {
            const double rounds = std::clamp(std::floor(time / duration), -kMostRounds, kMostRounds);
            const double rest = time - rounds * duration;
            // Rounding may leave the range by a last digit.
            if (rest >= duration) {
                return {0, static_cast<std::int64_t>(rounds) + 1};
            }
            return {std::max(rest, 0.0), static_cast<std::int64_t>(rounds)};
        }
        case LoopMode::ping_pong: {
            const double rest =
                std::clamp(time - std::floor(time / (2 * duration)) * (2 * duration), 0.0, 2 * duration);
            return {rest <= duration ? rest : 2 * duration - rest, 0};
        }
    }
    return {};
}

}  // namespace lanthorn
