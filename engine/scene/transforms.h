// World transforms of the scene's hierarchy, recomputed only below what changed.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// T * R * S * shear in double precision.
dmat4 local_matrix(const Transform& local, const mat3& shear = mat3(1));

// One object a world. As a system: schedule.add("transforms", [t = Transforms()](ecs::World& w) mutable {
// t.update(w); }).
class Transforms {
  public:
    // Brings WorldTransform up to date with LocalTransform, Shear and Parent, and adds it where it is
    // missing. A WorldTransform counts as changed only if its value did. Returns how many were computed.
    // Throws ecs::Error for a parent that is dead or has no LocalTransform, and for a cycle of parents: names
    // the entities. Cost: O(changed and all below them); O(n log n) of all that have or are parents when a
    // Parent changed.
    std::size_t update(ecs::World& world);

  private:
    // In depth-first order, so that what is below a node follows it directly.
    struct Node {
        ecs::Entity entity;
        std::uint32_t parent;  // index; kNone for a root
        std::uint32_t end;     // one past the last node below
    };

    void rebuild(ecs::World& world);
    bool hierarchy_changed(ecs::World& world) const;
    const Node* find(ecs::Entity e) const;
    void compute(ecs::World& world, ecs::Entity e, const dmat4* parent) const;

    std::uint64_t world_id_ = 0;
    ecs::Tick since_ = 0;
    std::size_t parents_ = 0;   // number of Parent components in nodes_
    std::size_t children_ = 0;  // of them with a LocalTransform
    std::size_t shears_ = 0;
    std::vector<Node> nodes_;  // all that have or are parents
    std::vector<std::uint32_t> roots_;
    std::vector<std::uint32_t> node_of_;  // by entity index; kNone: none
};

}  // namespace lanthorn
