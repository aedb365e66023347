// What passes are made from, by version: a pass is due once one of its inputs has another version than when
// it ran last, and the first such input is the reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// Versions of the parts of a scene: each grows in a frame in which SceneChanges says that its part differs.
struct SceneVersions {
    std::uint64_t geometry = 0;  // instances added, removed, moved, or of another shape
    std::uint64_t surfaces = 0;  // what materials reflect, emit or show as relief; any asset
    std::uint64_t lights = 0;    // and the sky
    std::uint64_t camera = 0;
    std::uint64_t whole = 0;  // nothing of what was there before is left
    // Parts of `surfaces`.
    std::uint64_t assets = 0;
    std::uint64_t paint = 0;    // what materials reflect diffusely
    std::uint64_t pattern = 0;  // of that more than the base colour
    std::uint64_t emission = 0;
    std::uint64_t relief = 0;

    void follow(const SceneChanges& changes) {
        geometry += changes.geometry ? 1 : 0;
        surfaces += !changes.painted.empty() || changes.emission || changes.relief || changes.assets ? 1 : 0;
        lights += changes.lights ? 1 : 0;
        camera += changes.camera ? 1 : 0;
        whole += changes.replaced ? 1 : 0;
        assets += changes.assets ? 1 : 0;
        paint += !changes.painted.empty() ? 1 : 0;
        pattern += changes.pattern ? 1 : 0;
        emission += changes.emission ? 1 : 0;
        relief += changes.relief ? 1 : 0;
    }
};

// A value and how often it has become another.
template <class T>
class Versioned {
  public:
    void follow(T now) {
        if (!value_ || !(*value_ == now)) {
            value_ = std::move(now);
            ++version_;
        }
    }
    std::uint64_t version() const { return version_; }

  private:
    std::optional<T> value_;
    std::uint64_t version_ = 0;
};

// What a pass was last made from. `Input`: an enum that numbers inputs from 0.
template <class Input, std::size_t kInputs>
class Stamps {
  public:
    using Versions = std::array<std::uint64_t, kInputs>;  // by Input

    // Of a pass that is made from these inputs alone, those whose change is the better reason first.
    Stamps(std::initializer_list<Input> inputs) {
        for (const Input input : inputs) {
            uses_[used_++] = input;
        }
    }

    // Nothing has been made, or it has been forgotten.
    bool empty() const { return !made_from_; }
    // The first input that differs from what there is; none if none does, or there is nothing.
    std::optional<Input> other(const Versions& now) const {
        for (std::size_t i = 0; i < used_; ++i) {
            if (differs(uses_[i], now)) {
                return uses_[i];
            }
        }
        return std::nullopt;
    }
    // Whether this one differs from what there is; not where there is nothing.
    bool differs(Input input, const Versions& now) const {
        const auto i = static_cast<std::size_t>(input);
        return made_from_ && (*made_from_)[i] != now[i];
    }
    bool due(const Versions& now) const { return empty() || other(now); }
    void made(const Versions& from) { made_from_ = from; }
    void forget() { made_from_.reset(); }

  private:
    std::array<Input, kInputs> uses_{};
    std::size_t used_ = 0;
    std::optional<Versions> made_from_;
};

}  // namespace lanthorn::gi
