// What moves from one look at the scene to the next, and where: for pictures of it that keep what stands
// still and draw only the rest again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

class SceneMotion {
  public:
    // Compares with the scene of the last call, whatever happened in between. At first, after another origin,
    // and when nothing is left of what was there, everything stands still. An instance that came, moved, was
    // deformed, or whose mesh or surface is of another version moves from then on until it is_static. One
    // whose material has another pattern (AssetVersion::kept) is painted in that call. O(instances); O(1)
    // where FrameScene::changes and the assets' serial say that nothing happened.
    void compare(const FrameScene& scene);

    bool restarted() const { return restarted_; }  // what was known before the last call means nothing now
    bool changed() const { return changed_; }      // anything came, left, moved, was deformed or painted

    // By index into FrameScene::instances of the last call.
    bool moving(std::uint32_t instance) const { return known_[instance].state == State::moving; }
    // Moved until the call before, and stands still as of the last: true for one call.
    bool rested(std::uint32_t instance) const { return known_[instance].state == State::rested; }
    const Aabb& bounds(std::uint32_t instance) const { return known_[instance].bounds; }  // render space
    bool any_moving() const { return !moving_.empty(); }  // as of the last call

    // What has happened within a viewer's reach.
    struct Seen {
        bool left = false;    // where something stood still that now moves or is gone
        bool rested = false;  // something that moved until the last call and now stands still
        bool moving = false;
        bool painted = false;  // something that stands still and has another pattern than at the last call
    };
    // What of it a viewer has to do with; `touches` is asked with boxes in render space.
    template <class Touches>
    Seen seen(const Touches& touches) const {
        const auto touches_instance = [&](std::uint32_t i) { return touches(known_[i].bounds); };
        return {std::ranges::any_of(left_, touches), std::ranges::any_of(rested_, touches_instance),
                std::ranges::any_of(moving_, touches_instance),
                std::ranges::any_of(painted_, touches_instance)};
    }

  private:
    enum class State : std::uint8_t { still, rested, moving };
    struct Known {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t version = 0;
        std::uint64_t mesh_version = 0;
        std::uint64_t surface = 0;  // AssetVersion<Material>
        std::uint64_t kept = 0;     // likewise
        mat4 transform{1};
        Aabb bounds;
        State state = State::still;

        bool same_shape(const Known& o) const {
            return transform == o.transform && version == o.version && mesh_version == o.mesh_version &&
                   surface == o.surface && bounds == o.bounds;
        }
    };
    void stand_still();
    void leave(const Known& before);

    std::vector<Known> known_;  // in order of instances
    std::vector<Aabb> left_;
    std::vector<std::uint32_t> rested_;
    std::vector<std::uint32_t> moving_;
    std::vector<std::uint32_t> painted_;
    std::uint64_t serial_ = 0;
    std::uint64_t last_frame_ = ~0ull - 1;
    dvec3 origin_{0};
    bool restarted_ = false;
    bool changed_ = false;
};

}  // namespace lanthorn
