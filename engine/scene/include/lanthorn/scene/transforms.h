// World transforms of the scene's hierarchy, recomputed only below what changed.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/ecs/kept_query.h"
#include "lanthorn/ecs/lookup.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// T * R * S * shear in double precision.
dmat4 local_matrix(const Transform& local, const mat3& shear = mat3(1));

// One object a world. engine/runtime/include/lanthorn/runtime/scene_plugin.h has it as systems.
class Transforms {
  public:
    // Brings WorldTransform up to date with LocalTransform, Shear and Parent, and adds it where it is
    // missing. A parent that is dead or has no LocalTransform counts as none. A WorldTransform counts as
    // changed only if its value did. Returns how many were computed.
    // Cost: O(changed and all below them); O(all that have or are parents) when a Parent came, changed or
    // went, of which only those with another parent and all below them are computed.
    std::size_t update(ecs::World& world);

    // The same where entities without a WorldTransform are left out: for systems, whose writes are dated
    // `now`. What it reads of `world` is LocalTransform, Shear, Parent and Children.
    using Writes = ecs::Lookup<ecs::Write<WorldTransform>>;
    // See above: `writes` gives the entities' WorldTransforms. Returns how many were computed.
    std::size_t update(const ecs::World& world, const Writes& writes, ecs::Tick now);

  private:
    struct Node {
        ecs::Entity entity;
        std::uint32_t parent;  // index; kNone for a root
        std::uint32_t end;     // one past the last node below
    };

    // All that have or are parents; `nodes` in depth-first order, so that what is below one follows it
    // directly.
    struct Tree {
        std::vector<Node> nodes;
        std::vector<std::uint32_t> node_of;  // by entity index; kNone: none

        std::uint32_t find(ecs::Entity e) const;          // kNone: none
        ecs::Entity parent_of(std::uint32_t node) const;  // null for a root
    };
    // How many have what; an entity that gained it shows as added, so that a change of hands is seen too.
    struct Counts {
        std::size_t parents = 0;   // Parent
        std::size_t children = 0;  // Parent and LocalTransform
        std::size_t inner = 0;     // Children and LocalTransform
        bool operator==(const Counts&) const = default;
    };

    bool hierarchy_changed(const ecs::World& world);
    Counts count(const ecs::World& world);
    void rebuild(const ecs::World& world);
    void add_tree(const ecs::World& world, ecs::Entity root);
    // Adds to `dirty` the nodes that have another parent in `before` than now.
    void compare(const ecs::World& world, const Tree& before, std::vector<ecs::Entity>& dirty) const;
    // Both return where the WorldTransform's matrix is; null if it has none.
    const dmat4* compute(const ecs::World& world, const Writes& writes, ecs::Entity e,
                         const dmat4* parent) const;
    const dmat4* matrix_of(const Writes& writes, std::uint32_t node) const;

    std::uint64_t world_id_ = 0;
    ecs::Tick since_ = 0;
    Counts counts_;
    std::size_t shears_ = 0;
    Tree tree_;
    ecs::KeptQuery<ecs::With<Parent>> parents_;
    ecs::KeptQuery<ecs::With<Parent, LocalTransform>> children_;
    ecs::KeptQuery<ecs::With<Children, LocalTransform>> inner_;
    ecs::KeptQuery<ecs::Changed<Parent>> new_parents_;
    ecs::KeptQuery<ecs::With<Parent>, ecs::Added<LocalTransform>> new_children_;
    ecs::KeptQuery<ecs::With<Children>, ecs::Added<LocalTransform>> new_inner_;
    ecs::KeptQuery<ecs::With<LocalTransform>, ecs::Added<WorldTransform>> new_worlds_;
    ecs::KeptQuery<ecs::With<LocalTransform>, ecs::Changed<LocalTransform, Shear>> moved_;
    ecs::KeptQuery<ecs::With<Shear>> sheared_;
};

}  // namespace lanthorn
