#include "lanthorn/audio/sound_source.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "lanthorn/audio/speaker.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::audio {

void declare_sound_source(ecs::Registry& registry) {
    using ecs::field;
    registry.component<SoundSource>(
        "sound_source", "sounds where it is",
        field("sound", &SoundSource::sound).words("a name of the program's sounds"),
        field("gain", &SoundSource::gain).range(0, 1).words("how loud"),
        field("pitch", &SoundSource::pitch).range(0.5, 2).words("how high, of the sound as it is"),
        field("placed", &SoundSource::placed).words("heard from where it is, else from nowhere"),
        field("playing", &SoundSource::playing).words("whether it sounds now"));
}

Ears ears_of(const ecs::World& world) {
    const ecs::Entity camera = world.resource<View>().camera;
    const WorldTransform* at = camera ? world.try_get<WorldTransform>(camera) : nullptr;
    if (at == nullptr) {
        return {};
    }
    return {dvec3(at->matrix[3]), -glm::normalize(dvec3(at->matrix[2])),
            glm::normalize(dvec3(at->matrix[1]))};
}

void SourceEar::listen(const ecs::World& world, Heard& heard) {
    std::map<ecs::Entity, bool> playing;
    world.query<ecs::Read<SoundSource>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const SoundSource& source, const WorldTransform& at) {
            playing[e] = source.playing;
            const auto found = std::ranges::find(names_, source.sound, &SoundName::name);
            if (found == names_.end()) {
                unknown_.insert(source.sound);
                return;
            }
            const auto before = playing_.find(e);
            const bool begins = source.playing && (before == playing_.end() || !before->second);
            if (source.playing && (found->loops || begins)) {
                (found->loops ? heard.going : heard.begun)
                    .push_back({.kind = static_cast<Kind>(found - names_.begin()),
                                .place = dvec3(at.matrix[3]),
                                .placed = source.placed,
                                .gain = source.gain,
                                .pitch = source.pitch,
                                .of = e});
            }
        });
    playing_ = std::move(playing);
}

void SoundPlugin::build(App& app) {
    declare_sound_source(app.registry());
    const auto ear = std::make_shared<SourceEar>(names_);
    const auto said = std::make_shared<std::set<std::string>>();
    app.frame_schedule()
        .add("sound",
             [&speaker = speaker_, ear, said](ecs::World& world) {
                 Heard heard;
                 ear->listen(world, heard);
                 for (const std::string& name : ear->unknown()) {
                     if (said->insert(name).second) {
                         std::fprintf(stderr, "sound_source: no sound '%s'\n", printable(name).c_str());
                     }
                 }
                 heard.ears = ears_of(world);
                 speaker.play(heard);
             })
        .after("extract");
}

}  // namespace lanthorn::audio
