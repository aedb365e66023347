// Where in a clip a layer is.
#pragma once

#include <cstdint>

namespace lanthorn {

// What a layer does when it comes to an end of its clip, forwards or backwards.
enum class LoopMode : std::uint8_t {
    once,      // stands still at the end it comes to
    loop,      // starts again; the last key and the first are the same moment
    ping_pong  // there and back
};

// A moment of a playback whose clip has `duration` seconds (0 or more).
struct ClipMoment {
    double time = 0;          // in the clip: 0..duration
    std::int64_t rounds = 0;  // how often the clip started again; of `loop` alone, negative for backwards
};

// `time` is what speed has added up to, in seconds; any finite number. A clip without duration is at 0.
ClipMoment clip_moment(LoopMode mode, double time, double duration);

}  // namespace lanthorn
