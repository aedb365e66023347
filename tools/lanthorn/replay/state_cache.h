// States before key steps, kept beside no recording but in the user's cache, so that a seek need not play
// from the beginning: ~/.cache/lanthorn/replay, or $XDG_CACHE_HOME. It may be deleted at any time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lanthorn::tools {

class StateCache {
  public:
    // `key`: what the states depend on (Verdict::key).
    explicit StateCache(const std::string& key);

    // The bytes of the last state at or before `step`, and its step; nothing where none is whole.
    struct Found {
        std::uint64_t step;
        std::string bytes;
    };
    std::optional<Found> before(std::uint64_t step) const;

    // Keeps a state, packed. Does nothing where there is no room or no cache.
    void keep(std::uint64_t step, const std::string& bytes) const;

  private:
    std::string folder_;  // empty: there is none
};

}  // namespace lanthorn::tools
