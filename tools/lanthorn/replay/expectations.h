// What a recording says must happen in it: "solved before 1500", "door door.open after 700",
// "green-pane pushed.share > 0.9".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

// Whether the first `steps` steps of a session tell if a line holds: they do if it says `before` one of them.
bool is_told_within(const std::string& line, std::uint64_t steps);

class Expectations {
  public:
    // WHAT [before STEP | after STEP]: that WHAT holds for the first time before or after so many steps, or
    // at any time. WHAT is `solved`, or ENTITY COMPONENT.FIELD for one that is true or false, or that with =
    // < > and a value. Throws InputError, naming `file`, for what is none of these.
    Expectations(const std::string& file, const std::vector<std::string>& lines);

    // The world after `steps` steps. Throws InputError for an entity, component or field that it does not
    // have.
    void look(const ecs::World& world, const ecs::Registry& registry, std::uint64_t steps);

    // When the level was solved first, in steps.
    std::optional<std::uint64_t> solved_at() const { return solved_at_; }
    // One for all of them; none where nothing is expected.
    Check check() const;

  private:
    struct Expected {
        std::string line;
        std::string entity = {}, field = {}, value = {};  // empty: solved; value: empty where it is true
        char sign = '=';
        std::optional<std::uint64_t> after = {}, before = {};  // steps
        std::optional<std::uint64_t> at = {};                  // steps after which it held first

        bool kept() const { return at && (!before || *at < *before) && (!after || *at > *after); }
    };
    bool holds(const Expected& expected, const ecs::World& world, const ecs::Registry& registry) const;

    std::string file_;
    std::vector<Expected> expected_;
    std::optional<std::uint64_t> solved_at_;
};

}  // namespace lanthorn::tools
