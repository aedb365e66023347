#include "lanthorn/audio/speaker.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace lanthorn::audio {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 15ms;
constexpr auto kRetry = 1s;               // between two looks for another device
constexpr float kFade = 0.12f;            // of its gain, that what has ended loses in a tick
constexpr std::size_t kVoices = 24;       // sounds at once; the oldest gives way
constexpr std::size_t kMusicBuffers = 4;  // of a quarter of a second
constexpr std::size_t kMusicSamples = kSampleRate / 4;

std::vector<ALshort> to_words(std::span<const float> samples) {
    std::vector<ALshort> words(samples.size());
    std::ranges::transform(samples, words.begin(), [](float s) {
        return static_cast<ALshort>(std::lround(32767 * std::clamp(s, -1.0f, 1.0f)));
    });
    return words;
}

// Without a sound card in the kernel a sound server is all there can be; ALSA and sndio would look for a card
// and say on stderr that there is none.
void choose_drivers() {
    std::error_code none;
    if (!std::filesystem::exists("/dev/snd", none)) {
        ::setenv("ALSOFT_DRIVERS", "pulse", 0);
    }
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);
}

// What the thread owns: the device and what plays on it. OpenAL's context is the process's, so one at a time.
class Device {
  public:
    explicit Device(const Repertoire& repertoire) : repertoire_(repertoire) {
        device_ = alcOpenDevice(nullptr);
        if (device_ == nullptr) {
            return;
        }
        context_ = alcCreateContext(device_, nullptr);
        if (context_ == nullptr || alcMakeContextCurrent(context_) == ALC_FALSE) {
            return;
        }
        alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
        for (const Effect& effect : repertoire.effects()) {
            const std::vector<ALshort> words = to_words(effect.samples);
            Made& made = effects_.emplace_back();
            made.loops = effect.loops;
            alGenBuffers(1, &made.buffer);
            alBufferData(made.buffer, AL_FORMAT_MONO16, words.data(),
                         static_cast<ALsizei>(words.size() * sizeof(ALshort)), kSampleRate);
        }
        for (Voice& voice : voices_) {
            alGenSources(1, &voice.source);
        }
        works_ = alGetError() == AL_NO_ERROR;
    }
    ~Device() {
        if (context_ != nullptr) {
            for (Voice& voice : voices_) {
                alDeleteSources(1, &voice.source);
            }
            alDeleteSources(1, &music_);
            alDeleteBuffers(kMusicBuffers, music_buffers_.data());
            for (const Made& made : effects_) {
                alDeleteBuffers(1, &made.buffer);
            }
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context_);
        }
        if (device_ != nullptr) {
            alcCloseDevice(device_);
        }
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    bool works() const { return works_; }
    // False once the device is gone: a headset pulled out, a sound server that ended (ALC_EXT_disconnect).
    bool connected() const {
        ALCint connected = ALC_TRUE;
        if (alcIsExtensionPresent(device_, "ALC_EXT_disconnect") == ALC_TRUE) {
            alcGetIntegerv(device_, ALC_CONNECTED, 1, &connected);
        }
        return connected == ALC_TRUE;
    }

    void place(const Ears& ears) {
        // Places are relative to the ears: float is enough for them anywhere in the world.
        ears_ = ears;
        const std::array<float, 6> facing = {
            static_cast<float>(ears.ahead.x), static_cast<float>(ears.ahead.y),
            static_cast<float>(ears.ahead.z), static_cast<float>(ears.up.x),
            static_cast<float>(ears.up.y),    static_cast<float>(ears.up.z)};
        alListenerfv(AL_ORIENTATION, facing.data());
    }

    void begin(const Sound& sound, float volume) {
        if (sound.kind >= effects_.size()) {
            return;
        }
        const Made& made = effects_[sound.kind];
        Voice& voice = free_voice();
        alSourceStop(voice.source);
        voice.sound = sound;
        voice.gain = sound.gain * volume;
        voice.ending = false;
        voice.begun = ++begun_;
        alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(made.buffer));
        alSourcei(voice.source, AL_LOOPING, made.loops ? AL_TRUE : AL_FALSE);
        alSourcef(voice.source, AL_REFERENCE_DISTANCE, 1.5f);
        show(voice);
        alSourcePlay(voice.source);
    }

    void go_on(const std::vector<Sound>& going, float volume) {
        for (Voice& voice : voices_) {
            if (is_going(voice)) {
                voice.ending = std::ranges::none_of(going, [&](const Sound& s) { return is_of(voice, s); });
            }
        }
        for (const Sound& sound : going) {
            const auto found = std::ranges::find_if(
                voices_, [&](const Voice& voice) { return is_going(voice) && is_of(voice, sound); });
            if (found == voices_.end()) {
                begin(sound, volume);
                continue;
            }
            found->sound = sound;
            found->gain = sound.gain * volume;
            show(*found);
        }
    }

    void tick(float music_volume) {
        for (Voice& voice : voices_) {
            if (!voice.ending) {
                continue;
            }
            voice.gain = std::max(voice.gain - kFade, 0.0f);
            alSourcef(voice.source, AL_GAIN, voice.gain);
            if (voice.gain == 0) {
                alSourceStop(voice.source);
                voice.ending = false;
            }
        }
        stream(music_volume);
    }

  private:
    struct Made {
        ALuint buffer = 0;
        bool loops = false;
    };
    struct Voice {
        ALuint source = 0;
        Sound sound;
        float gain = 0;
        bool ending = false;  // fades out
        std::uint64_t begun = 0;
    };

    static bool is_playing(const Voice& voice) {
        ALint state = 0;
        alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
        return state == AL_PLAYING;
    }
    bool is_going(const Voice& voice) const {
        return voice.sound.kind < effects_.size() && effects_[voice.sound.kind].loops && is_playing(voice);
    }
    static bool is_of(const Voice& voice, const Sound& sound) {
        return voice.sound.kind == sound.kind && voice.sound.of == sound.of;
    }

    Voice& free_voice() {
        for (Voice& voice : voices_) {
            if (!is_playing(voice)) {
                return voice;
            }
        }
        return *std::ranges::min_element(voices_, {}, &Voice::begun);
    }

    void show(const Voice& voice) const {
        const Sound& sound = voice.sound;
        const vec3 at = sound.placed ? vec3(sound.place - ears_.place) : vec3(0);
        alSourcei(voice.source, AL_SOURCE_RELATIVE, sound.placed ? AL_FALSE : AL_TRUE);
        alSource3f(voice.source, AL_POSITION, at.x, at.y, at.z);
        alSourcef(voice.source, AL_GAIN, voice.gain);
        alSourcef(voice.source, AL_PITCH, sound.pitch);
    }

    // Silent music is not made.
    void stream(float volume) {
        if (!repertoire_.music || (music_ == 0 && volume == 0)) {
            return;
        }
        if (music_ == 0) {
            alGenSources(1, &music_);
            alGenBuffers(kMusicBuffers, music_buffers_.data());
            alSourcei(music_, AL_SOURCE_RELATIVE, AL_TRUE);
            for (const ALuint buffer : music_buffers_) {
                queue(buffer);
            }
        }
        alSourcef(music_, AL_GAIN, volume);
        ALint done = 0, state = 0;
        alGetSourcei(music_, AL_SOURCE_STATE, &state);
        if (volume == 0) {
            alSourcePause(music_);
            return;
        }
        alGetSourcei(music_, AL_BUFFERS_PROCESSED, &done);
        for (; done > 0; --done) {
            ALuint buffer = 0;
            alSourceUnqueueBuffers(music_, 1, &buffer);
            queue(buffer);
        }
        if (state != AL_PLAYING) {
            alSourcePlay(music_);
        }
    }
    void queue(ALuint buffer) const {
        std::array<float, 2 * kMusicSamples> samples;
        repertoire_.music(samples);
        const std::vector<ALshort> words = to_words(samples);
        alBufferData(buffer, AL_FORMAT_STEREO16, words.data(),
                     static_cast<ALsizei>(words.size() * sizeof(ALshort)), kSampleRate);
        alSourceQueueBuffers(music_, 1, &buffer);
    }

    const Repertoire& repertoire_;
    ALCdevice* device_ = nullptr;
    ALCcontext* context_ = nullptr;
    bool works_ = false;
    Ears ears_;
    std::vector<Made> effects_;
    std::array<Voice, kVoices> voices_;
    std::uint64_t begun_ = 0;
    ALuint music_ = 0;
    std::array<ALuint, kMusicBuffers> music_buffers_{};
};

}  // namespace

class Speaker::Thread {
  public:
    explicit Thread(Repertoire repertoire) : repertoire_(std::move(repertoire)), thread_([this] { run(); }) {}
    ~Thread() {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        wakes_.notify_one();
        thread_.join();
    }
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    // Held for as long as it takes to copy a few sounds.
    void set_volumes(float effects, float music) {
        const std::lock_guard lock(mutex_);
        effects_volume_ = effects;
        music_volume_ = music;
    }
    void play(const Heard& heard) {
        const std::lock_guard lock(mutex_);
        if (ended_) {
            return;
        }
        wanted_.ears = heard.ears;
        wanted_.going = heard.going;
        for (const Sound& sound : heard.begun) {
            if (wanted_.begun.size() < kVoices) {  // more cannot be told apart
                wanted_.begun.push_back(sound);
            }
        }
        fresh_ = true;
    }
    bool sounds() const { return sounds_; }

  private:
    void run() {
        std::optional<Device> device(std::in_place, repertoire_);
        sounds_ = device->works();
        std::unique_lock lock(mutex_);
        if (!device->works()) {
            ended_ = true;
            wanted_ = {};
            return;
        }
        while (!ends_) {
            const Heard now{wanted_.ears, std::exchange(wanted_.begun, {}), wanted_.going};
            const bool fresh = std::exchange(fresh_, false);
            const float effects = effects_volume_, music = music_volume_;
            lock.unlock();
            if (!device->works() || !device->connected()) {
                device.reset();  // before the next: OpenAL's context is the process's
                device.emplace(repertoire_);
                sounds_ = device->works();
            } else if (fresh) {
                device->place(now.ears);
                for (const Sound& sound : now.begun) {
                    device->begin(sound, effects);
                }
                device->go_on(now.going, effects);
            }
            if (device->works()) {
                device->tick(music);
            }
            lock.lock();
            const auto pause = device->works() ? std::chrono::milliseconds(kTick) : kRetry;
            wakes_.wait_for(lock, pause, [this] { return ends_; });
        }
    }

    std::mutex mutex_;
    std::condition_variable wakes_;
    Heard wanted_;
    bool fresh_ = false, ends_ = false, ended_ = false;
    float effects_volume_ = 1, music_volume_ = 1;
    std::atomic<bool> sounds_ = false;
    const Repertoire repertoire_;
    std::thread thread_;
};

Speaker::Speaker(Repertoire repertoire) {
    choose_drivers();
    thread_ = std::make_unique<Thread>(std::move(repertoire));
}

Speaker::~Speaker() = default;

void Speaker::set_volumes(double effects, double music) {
    thread_->set_volumes(static_cast<float>(effects), static_cast<float>(music));
}

void Speaker::play(const Heard& heard) {
    thread_->play(heard);
}

bool Speaker::sounds() const {
    return thread_->sounds();
}

}  // namespace lanthorn::audio
