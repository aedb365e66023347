#include "engine/animation/declare_components.h"

#include "lanthorn/animation/animation_player.h"

namespace lanthorn {

using ecs::field;

void declare_animation_components(ecs::Registry& registry) {
    using Target = PlayerBinding::Target;
    registry.structure("animation_layer", field("clip", &AnimationLayer::clip),
                       field("time", &AnimationLayer::time).unit("s"),
                       field("speed", &AnimationLayer::speed).words("seconds of the clip a second"),
                       field("loop", &AnimationLayer::loop).choices({"once", "loop", "ping_pong"}),
                       field("weight", &AnimationLayer::weight), field("fade_to", &AnimationLayer::fade_to),
                       field("fade_seconds", &AnimationLayer::fade_seconds).unit("s"),
                       field("leaves_after", &AnimationLayer::leaves_after),
                       field("hints", &AnimationLayer::hints).transient());
    registry.structure(
        "root_motion", field("node", &RootMotion::node), field("rotation", &RootMotion::rotation),
        field("vertical", &RootMotion::vertical), field("remove", &RootMotion::remove),
        field("translation", &RootMotion::translation).unit("m"), field("turn", &RootMotion::turn));
    registry.structure("player_target", field("node", &Target::node),
                       field("path", &Target::path).choices({"translation", "rotation", "scale", "weights"}),
                       field("width", &Target::width), field("first", &Target::first),
                       field("moves", &Target::moves), field("owned", &Target::owned),
                       field("weight", &Target::weight));
    registry.structure("player_binding", field("clips", &PlayerBinding::clips).opaque(),
                       field("nodes", &PlayerBinding::nodes), field("targets", &PlayerBinding::targets),
                       field("targets_of", &PlayerBinding::targets_of), field("rest", &PlayerBinding::rest),
                       field("pose", &PlayerBinding::pose), field("scratch", &PlayerBinding::scratch));
    registry
        .component<AnimationPlayer>(
            "animation_player", "the clips that play, blended by weight",
            field("layers", &AnimationPlayer::layers),
            field("root", &AnimationPlayer::root).words("movement taken from the clips"),
            field("by_clock", &AnimationPlayer::by_clock).words("the first layer's time is the clock's"),
            field("binding", &AnimationPlayer::binding).transient())
        .runtime()
        .not_in_extras();
    registry.component<StartClip>(
        "start_clip", "which of the file's clips plays, on any node; without it the first one does",
        field("clip", &StartClip::clip).words("its name, or none"));
}

}  // namespace lanthorn
