// The photons of the last frames: a place for every hit of every photon that is kept, so that new ones take
// the places of the oldest (Jozwowski 2002, sec. 4.1.2 and 4.2, fig. 11, 13, 16 and 17).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// Whose surface a photon lies on: an instance by id and mesh, the same in every frame.
using SurfaceKey = std::uint64_t;
inline SurfaceKey surface_key(std::uint32_t id, std::uint32_t mesh) {
    return static_cast<SurfaceKey>(id) << 32 | mesh;
}

// A hit: light that arrived at a surface.
struct StoredPhoton {
    vec3 position{0};  // render space
    vec3 normal{0};    // of the triangle, unit, on the side that the light came from
    vec3 flux{0};      // lumen
    SurfaceKey surface = 0;
    bool used = false;       // fig. 13: whether it counts; not at a mirror, nor once the light has ended
    bool from_lamp = false;  // straight: a first hit, direct light
};

class PhotonStore {
  public:
    // `total` photons of at most `levels` hits each (max_level), none of them used.
    void reset(std::size_t total, std::size_t levels);

    std::size_t total() const { return total_; }
    std::size_t levels() const { return levels_; }
    std::size_t used() const { return used_; }  // places

    // The hits of photon `photon`, first one first, take the place of what it had before (fig. 16): levels
    // past theirs end unused. More hits than levels are dropped. O(levels).
    void replace(std::size_t photon, std::span<const StoredPhoton> hits);

    // Takes the photons of surfaces that have moved along with them: `moves` by surface, rigid, render space.
    // O(places) where there are any.
    void carry(const std::unordered_map<SurfaceKey, mat4>& moves);

    // Of the photon's hit of a level (fig. 11).
    std::size_t place(std::size_t photon, std::size_t level) const { return level * total_ + photon; }
    const StoredPhoton& operator[](std::size_t place) const { return places_[place]; }
    std::span<const StoredPhoton> places() const { return places_; }

    // Places that were written since forget_changed(), once each, in the order of their writing.
    std::span<const std::uint32_t> changed() const { return changed_; }
    void forget_changed();

  private:
    void note_change(std::size_t place);

    std::size_t total_ = 0, levels_ = 0, used_ = 0;
    std::vector<StoredPhoton> places_;
    std::vector<std::uint32_t> changed_;
    std::vector<bool> is_changed_;
};

}  // namespace lanthorn::gi
