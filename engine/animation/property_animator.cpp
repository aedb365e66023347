#include "engine/animation/property_animator.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "engine/animation/key_sampler.h"
#include "lanthorn/animation/playback.h"

namespace lanthorn {

namespace {

auto place_of(const PropertyChannel& channel) {
    return std::tuple(owner_of(channel.property), channel.object, channel.property);
}

// Whether 0 stands for "infinitely far".
bool zero_is_infinite(AnimatedProperty property) {
    return property == AnimatedProperty::attenuation_distance || property == AnimatedProperty::camera_z_far;
}

// Of layers whose weights are `weight`, together with what is missing to the whole.
PropertyValue mean(const PropertyChannel& channel, const PropertyValue& sum, double weight, double total) {
    const double whole = std::max(total, 1.0), missing = std::max(whole - weight, 0.0);
    PropertyValue value{};
    if (missing > 0 && channel.rest[0] == 0 && zero_is_infinite(channel.property)) {
        return value;  // with any share of what is infinite
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        const double rest = missing > 0 ? missing * channel.rest[i] : 0;  // which may be infinite: a range
        value[i] = (sum[i] + rest) / whole;
    }
    return value;
}

// What the clip multiplies the channel by.
double scale_at(const AnimationClip& clip, const PropertyChannel& channel, double time) {
    const PropertyChannel* next = &channel + 1;
    const bool scaled = channel.property == AnimatedProperty::emissive &&
                        next != clip.properties.data() + clip.properties.size() &&
                        next->property == AnimatedProperty::emissive_scale &&
                        next->object == channel.object && next->keys.width == 1;
    double scale = 1;
    std::uint32_t hint = 0;
    if (scaled) {
        sample(next->keys, time, hint, {&scale, 1});
    }
    return scale;
}

template <class Component, class Value>
void write(const PropertyAnimator::Lamps& lamps, ecs::Entity entity, Value Component::*member,
           AnimatedProperty property, const PropertyValue& to,
           const std::function<void(ecs::Entity, const Value&, const Value&)>* overwritten) {
    const Component* old = lamps.try_get<Component>(entity);
    if (old == nullptr) {
        return;
    }
    const Value before = old->*member;
    Value value = before;
    set_property(value, property, to);
    if (value == before) {
        return;
    }
    if (overwritten != nullptr) {
        (*overwritten)(entity, before, value);
    }
    lamps.try_get_mut<Component>(entity)->*member = value;
}

}  // namespace

void PropertyAnimator::blend(const AnimationPlayer& player, const AnimationSet& set, double back,
                             double clock) {
    blended_.clear();
    double total = 0;  // weight
    for (std::size_t l = 0; l < player.layers.size(); ++l) {
        const AnimationLayer& layer = player.layers[l];
        if (layer.clip >= set.clips->size()) {
            continue;
        }
        const AnimationClip& clip = (*set.clips)[layer.clip];
        const double at = !player.by_clock ? layer.time - back * layer.speed : l == 0 ? clock : layer.time;
        const double time = clip_moment(layer.loop, finite_or_zero(at), clip.duration).time;
        const double weight = std::max(finite_or_zero(layer.weight), 0.0);
        total += weight;
        for (const PropertyChannel& channel : clip.properties) {
            if (channel.property == AnimatedProperty::emissive_scale) {
                continue;  // see scale_at
            }
            const auto place = std::ranges::lower_bound(
                blended_, place_of(channel), {}, [](const Blended& b) { return place_of(*b.channel); });
            const bool known = place != blended_.end() && place_of(*place->channel) == place_of(channel);
            Blended& value = known ? *place : *blended_.insert(place, Blended{&channel});
            scratch_.assign(channel.keys.width, 0);
            std::uint32_t hint = 0;
            sample(channel.keys, time, hint, scratch_);
            const double share = weight * scale_at(clip, channel, time);
            for (std::size_t i = 0; i < scratch_.size() && i < value.sum.size(); ++i) {
                value.sum[i] += share * scratch_[i];
            }
            value.weight += weight;
        }
    }
    for (Blended& value : blended_) {
        value.result = mean(*value.channel, value.sum, value.weight, total);
    }
}

void PropertyAnimator::write_material(AssetStore& store, MaterialHandle handle, Values values) const {
    const Material& before = store.get(handle);
    Material material = before;
    for (const Blended& value : values) {
        set_property(material, value.channel->property, value.result);
    }
    const bool differs = std::ranges::any_of(values, [&](const Blended& value) {
        const AnimatedProperty property = value.channel->property;
        return property_of(before, property) != property_of(material, property);
    });
    if (differs) {
        store.edit_material(handle, [&](Material& m) { m = material; });
    }
}

void PropertyAnimator::write_lamp(const Lamps& lamps, const AnimationSet& set, const Blended& value,
                                  const Overwritten* overwritten) const {
    const AnimatedProperty property = value.channel->property;
    for (const std::uint32_t node : value.channel->nodes) {
        const ecs::Entity entity = node < set.nodes.size() ? set.nodes[node] : ecs::kNullEntity;
        if (owner_of(property) == PropertyOwner::light) {
            write(lamps, entity, &LightComponent::light, property, value.result,
                  overwritten ? &overwritten->light : nullptr);
        } else {
            write(lamps, entity, &CameraComponent::camera, property, value.result,
                  overwritten ? &overwritten->camera : nullptr);
        }
    }
}

void PropertyAnimator::animate(const Players& players, const Lamps& lamps, AssetStore& store, double back,
                               double clock, const Overwritten* overwritten) {
    players.each([&](const AnimationPlayer& player, const AnimationSet& set, const Source& source) {
        if (!set.clips || player.layers.empty()) {
            return;
        }
        blend(player, set, back, clock);
        for (auto first = blended_.begin(); first != blended_.end();) {
            const PropertyChannel& channel = *first->channel;
            if (owner_of(channel.property) != PropertyOwner::material) {
                write_lamp(lamps, set, *first++, overwritten);
                continue;
            }
            const auto end = std::find_if(
                first, blended_.end(), [&](const Blended& b) { return b.channel->object != channel.object; });
            const std::vector<MaterialHandle>& materials = store.get(source.scene).materials;
            if (channel.object < materials.size()) {
                write_material(store, materials[channel.object], Values(first, end));
            }
            first = end;
        }
    });
}

}  // namespace lanthorn
