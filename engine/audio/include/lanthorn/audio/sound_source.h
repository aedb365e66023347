// Sound as a component: what an entity sounds like, from where it is.
//
//   {"name": "brook", "translation": [2, 0, 1], "extras": {"sound_source": {"sound": "water", "gain": 0.4}}}
//
//   audio::Speaker speaker({make_effects, {}});
//   app.add<audio::SoundPlugin>(speaker, std::vector<audio::SoundName>{{"step"}, {"water", true}});
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/audio/heard.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/plugin.h"

namespace lanthorn::audio {

class Speaker;

// Sounds where its entity is. Gameplay starts and ends it by `playing`: what loops goes on as long as that
// holds, what is played once begins each time that it becomes true.
struct SoundSource {
    std::string sound;    // a SoundName's
    float gain = 1;       // 0..1
    float pitch = 1;      // 0.5..2
    bool placed = true;   // else it is as loud everywhere, from nowhere
    bool playing = true;  // now
    bool operator==(const SoundSource&) const = default;
};

// "sound_source", for extras, snapshots and hashes.
void declare_sound_source(ecs::Registry& registry);

// An effect of a Repertoire, whose place in the list is its Kind.
struct SoundName {
    std::string name;
    bool loops = false;  // as Effect::loops
};

// Where the world is heard from: the camera of its View, or the origin without one.
Ears ears_of(const ecs::World& world);

// What sources sound like from one call to the next.
class SourceEar {
  public:
    explicit SourceEar(std::vector<SoundName> names) : names_(std::move(names)) {}

    // Adds what has begun since the call before, and what goes on. A source that is there at the first call
    // begins then. Sounds that there are none of are left out, and their names added to unknown().
    void listen(const ecs::World& world, Heard& heard);
    // Names that listen() met and found no sound of.
    const std::set<std::string>& unknown() const { return unknown_; }

  private:
    std::vector<SoundName> names_;
    std::map<ecs::Entity, bool> playing_;  // at the call before
    std::set<std::string> unknown_;
};

// Plays all sources of an App through a speaker, which must outlive it. An unknown sound is said once on
// standard error.
//
//   frame:  extract -> sound
class SoundPlugin final : public Plugin {
  public:
    SoundPlugin(Speaker& speaker, std::vector<SoundName> names)
        : speaker_(speaker), names_(std::move(names)) {}
    std::string_view name() const override { return "sound"; }
    void build(App& app) override;

  private:
    Speaker& speaker_;
    std::vector<SoundName> names_;
};

}  // namespace lanthorn::audio
