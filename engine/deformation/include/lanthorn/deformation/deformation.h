// Deformation: from poses to vertices. Morph targets, then skinning, as glTF 2.0 says (3.7.2.2, 3.7.3), then
// subdivision (OpenSubdiv 3.5).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lanthorn/deformation/detail.h"
#include "lanthorn/ecs/commands.h"
#include "lanthorn/ecs/lookup.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// One object a world; after Transforms::update and before the Extractor.
//
// Skinned vertices are in world orientation relative to the first joint's world position
// (DeformedMeshes::skinned_at), so that they are as exact 100 km from the world's origin as at it: about 1e-6
// of the mesh's size. Others stay in object space. A mesh without influences on an entity with a skin moves
// with the entity.
//
// A mesh with a cage becomes its limit surface at one level of refinement for everyone: the cage's own, or
// without loss what `hints` ask for. DeformedMesh::refined has its triangles. A cage that cannot be
// subdivided is drawn as it is, deformed.
//
// Under joints most of which mirror, DeformedMesh::refined holds the mesh's own triangles turned round, so
// that their front stays counter-clockwise.
class Deformation {
  public:
    Deformation();
    Deformation(Deformation&&) noexcept;
    Deformation& operator=(Deformation&&) noexcept;
    ~Deformation();

    // Writes DeformedMeshes of every entity whose MeshInstances has a mesh that deforms (of the AssetStore
    // resource), and removes it where it no longer applies.
    //
    // A mesh is recomputed only if its joints' matrices relative to each other, its weights or its data
    // changed; else its DeformedMesh is the same, version included. World transforms must be up to date.
    //
    // Never throws for bad data and never writes a NaN: an entity whose joints are missing, too few or not
    // finite keeps its last shape, or if it has none its meshes as they are; see warnings().
    //
    // The first frame of a mesh's level builds its stencils, about 5 us a refined vertex.
    //
    // Cost: O(entities with meshes + joints + vertices that changed); on oneTBB, with the same bits for any
    // number of threads. Allocates nothing once every mesh has its arrays: one more than frames that are held
    // at a time.
    void update(ecs::World& world, const DetailHints* hints = nullptr);

    // The same in four steps, which are systems of the frame
    // (engine/runtime/include/lanthorn/runtime/deformation_plugin.h). Entities and their components stay as
    // they are from the first to the last, which alone writes.
    void morph(const ecs::World& world);                           // which targets are on
    void skin(const ecs::World& world, const DetailHints* hints);  // vertices, the targets added on the way
    void subdivide();                                              // limit surfaces over them
    // Bounds; writes DeformedMeshes, by command where it comes or goes.
    using Writes = ecs::Lookup<ecs::Write<DeformedMeshes>>;
    // Last of the four: `writes` gives meshes of entities that have DeformedMeshes already, `commands` what
    // comes or goes.
    void publish(const ecs::World& world, const Writes& writes, ecs::Commands& commands);

    // Of the last update: what could not be deformed and why, one line each.
    const std::vector<std::string>& warnings() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lanthorn
