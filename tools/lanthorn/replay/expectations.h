// What a recording says must happen in it: "solved", "solved before 1500", "solved after 700".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

class Expectations {
  public:
    // Throws InputError, naming `file`, for one that is none of the above.
    Expectations(const std::string& file, std::vector<std::string> lines);

    // The world after `steps` steps.
    void look(const ecs::World& world, std::uint64_t steps);

    // When the level was solved first, in steps.
    std::optional<std::uint64_t> solved_at() const { return solved_at_; }
    // One for all of them; none where nothing is expected.
    Check check() const;

  private:
    struct Expected {
        std::string line;
        std::optional<std::uint64_t> after, before;  // steps
    };
    std::vector<Expected> expected_;
    std::optional<std::uint64_t> solved_at_;
};

}  // namespace lanthorn::tools
