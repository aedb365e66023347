// The other half of animation: clips that change lights, cameras and materials (KHR_animation_pointer).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/lookup.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// One object a world; after Animator, which moves the layers on.
//
// Layers are blended by weight as poses are; what is missing to 1 is what the file says without a clip. What
// no layer's clip moves is left alone, and keeps what a clip made of it last. A material is the file's: all
// that show it change together, whichever player's clip it is. Between two steps it is the picture's: it is
// not put back for the next step, so what a simulation does must not follow from it.
class PropertyAnimator {
  public:
    using Players = ecs::Query<ecs::Read<AnimationPlayer>, ecs::Read<AnimationSet>, ecs::Read<Source>>;
    using Lamps = ecs::Lookup<ecs::Write<LightComponent>, ecs::Write<CameraComponent>>;

    // What is told of each value that a picture between two steps overwrites: what was there, what is now.
    struct Overwritten {
        std::function<void(ecs::Entity, const Light&, const Light&)> light;
        std::function<void(ecs::Entity, const Camera&, const Camera&)> camera;
    };

    // Writes what the clips say `back` seconds before where their layers are (fades not considered), and for
    // players by the clock at `clock`. Only what differs is written. A pure function of its arguments. Cost:
    // O(channels of the playing clips), each O(log keys), and a copy of each material that changes.
    // `overwritten` may be null.
    void animate(const Players& players, const Lamps& lamps, AssetStore& store, double back, double clock,
                 const Overwritten* overwritten = nullptr);

  private:
    struct Blended {
        const PropertyChannel* channel;
        double weight = 0;  // of the layers that move it
        PropertyValue sum{}, result{};
    };
    using Values = std::span<const Blended>;

    void blend(const AnimationPlayer& player, const AnimationSet& set, double back, double clock);
    void write_material(AssetStore& store, MaterialHandle handle, Values values) const;
    void write_lamp(const Lamps& lamps, const AnimationSet& set, const Blended& value,
                    const Overwritten* overwritten) const;

    std::vector<Blended> blended_;  // of the player at hand, by owner, object and property
    std::vector<double> scratch_;
};

}  // namespace lanthorn
