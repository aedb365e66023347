// A file's word on which of its clips plays.
#pragma once

#include <string>

namespace lanthorn {

// The component, on any node of a scene: what plays where nobody asks for a clip. The first one counts.
struct StartClip {
    std::string clip;  // by its name; "none": nothing plays; empty: as if there were no such component
};

}  // namespace lanthorn
