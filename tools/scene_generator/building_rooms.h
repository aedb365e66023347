// What stands in the rooms of the scene `building`: meshes that rooms share, placed by rules.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

class RoomFurniture {
  public:
    explicit RoomFurniture(Builder& b);
    // `room` decides what there is; its nodes are children of `parent`, whose origin is the middle of the
    // room's floor. `half`: from there to the walls, x and z. `back`: the -z wall has no doorway, so that
    // something may stand along it. `centre`: so may something in the middle.
    void put(std::uint32_t room, std::uint32_t parent, const dvec3& half, bool back, bool centre);

  private:
    using Kinds = std::vector<std::uint32_t>;  // the same shape in several materials
    Kinds add(const std::string& name, const Shape& shape, const Kinds& materials);
    void place(const std::string& name, const Kinds& kinds, std::uint64_t pick, const dvec3& position,
               double degrees, std::uint32_t parent);
    void shelf(std::uint32_t room, std::uint32_t parent, const dvec3& position);
    void table(std::uint32_t room, std::uint32_t parent);

    Builder& b_;
    Kinds shelf_, table_, chair_, bed_, pillow_, chest_, crate_, box_, jar_, ball_, globe_, column_, rug_,
        bowl_;
    std::vector<double> boards_;  // heights of the shelf's
};

}  // namespace lanthorn::scene_generator
