// Work on bytes that nobody vouches for, in a copy of the process: it may crash, run on or ask for any amount
// of memory, and costs the copy alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace lanthorn {

// The copy's side: sends records, each whole or not at all, and asks for more time and memory once it knows
// how much there is to do.
class Sender {
  public:
    explicit Sender(int to) : to_(to) {}
    void send(std::uint8_t kind, std::span<const std::byte> record);
    // From now on. Seconds of processor time in all, bytes beside what the copy has.
    static void allow(double seconds, std::uint64_t bytes);

  private:
    int to_;
};

inline constexpr std::size_t kLargestRecord = 1u << 20;  // bytes
inline constexpr double kWorkSeconds = 10;               // before allow() says more
inline constexpr std::uint64_t kWorkBytes = 1u << 30;

// Runs `work` in a copy of the process, made anew for each call: a thread of its own, no other one's. `take`
// gets each record as it comes; false ends the work. Returns why it did not come to its end, the end of a
// sentence ("ends its reader ..."); empty if it did. The copy prints nothing. Thread-safe; some milliseconds.
std::string work_apart(const std::function<void(Sender&)>& work,
                       const std::function<bool(std::uint8_t kind, std::span<const std::byte> record)>& take);

}  // namespace lanthorn
