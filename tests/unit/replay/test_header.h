// What the tests of recorder and player record.
#pragma once

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

struct Input {
    std::int16_t walk = 0;
    std::uint16_t buttons = 0;
};

inline RecordingHeader header() {
    RecordingHeader h;
    h.level = "room.glb";
    h.level_hash = 5;
    h.seed = 9;
    h.input_format = "test-1";
    h.input_size = sizeof(Input);
    h.parts = {"door", "player"};
    h.schemas = {1, 2};
    h.sensors = {"far"};
    return h;
}

}  // namespace lanthorn::replay
