// Sounds and music on the machine's device, by OpenAL Soft.
//
// OpenAL and not miniaudio, which Debian 12 does not package; it also places sounds in space, and has devices
// that write a file or nothing, for tests.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "game/presentation/sound/ear.h"

namespace lanthorn::game {

class Speaker {
  public:
    // Returns at once: a thread of its own opens the device, makes the sounds and the music of `seed`, and
    // plays them. Where there is no device it stays silent, and says nothing. A device that goes away while
    // it plays (a headset pulled out) gives way to the one that is there then, within a second or so.
    explicit Speaker(std::uint64_t seed);
    ~Speaker();  // waits for the thread, some hundredths of a second
    Speaker(const Speaker&) = delete;
    Speaker& operator=(const Speaker&) = delete;

    // 0..1 each.
    void set_volumes(double effects, double music);

    // What is heard from now on. What goes on and is not in `heard` any more fades out. Never waits for the
    // device: the thread takes it up within some hundredths of a second.
    void play(const Heard& heard);

    // Whether there is a device; false until the thread has looked.
    bool sounds() const;

  private:
    class Thread;
    std::unique_ptr<Thread> thread_;
};

}  // namespace lanthorn::game
