// Sounds and music on the machine's device, by OpenAL Soft.
//
// OpenAL and not miniaudio, which Debian 12 does not package; it also places sounds in space, and has devices
// that write a file or nothing, for tests.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lanthorn/audio/heard.h"
#include "lanthorn/audio/samples.h"

namespace lanthorn::audio {

// A sound that can be played, any number of times at once.
struct Effect {
    Samples samples;
    bool loops = false;  // as long as it goes on; else it is played once
};

// What a program has to play. Both are called in the speaker's thread.
struct Repertoire {
    // The effects, a Sound's kind being their place here. Called for every device that is opened.
    std::function<std::vector<Effect>()> effects;
    // Fills in the next samples of endless music, left and right in turn. Empty: there is none.
    std::function<void(std::span<float> stereo)> music;
};

class Speaker {
  public:
    // Returns at once: a thread of its own opens the device, has the sounds and the music made, and plays
    // them. Where there is no device it stays silent, and says nothing. A device that goes away while
    // it plays (a headset pulled out) gives way to the one that is there then, within a second or so.
    explicit Speaker(Repertoire repertoire);
    ~Speaker();  // waits for the thread, some hundredths of a second
    Speaker(const Speaker&) = delete;
    Speaker& operator=(const Speaker&) = delete;

    // 0..1 each.
    void set_volumes(double effects, double music);

    // What is heard from now on; of a kind that there is no effect of, nothing. What goes on and is not in
    // `heard` any more fades out. Never waits for the device: the thread takes it up within some hundredths
    // of a second.
    void play(const Heard& heard);

    // Whether there is a device; false until the thread has looked.
    bool sounds() const;

  private:
    class Thread;
    std::unique_ptr<Thread> thread_;
};

}  // namespace lanthorn::audio
