// From the world to the FrameScene: the one place where the renderer's view of things is taken.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {

// Extractions without a move after which an instance is static.
inline constexpr std::uint32_t kStaticAfter = 8;

// Remembers the last extraction, so as to tell what changed. World transforms must be up to date
// (Transforms::update), and deformed meshes (Deformation::update).
//
// The origin is the centre of the geometry's bounds at the first extraction that finds any (before: 0); or of
// most things, where those lie more than a thousand of their sizes off it. It stays until the scene is more
// than kOriginReach of its own diagonals away from it.
class Extractor {
  public:
    static constexpr double kOriginReach = 64;

    // As seen by an entity with CameraComponent and WorldTransform (throws ecs::Error if it lacks one); from
    // frame_all() for the null entity or a camera whose transform is not finite. O(instances log instances).
    // `y_fov`: radians, in place of the camera's own.
    FrameScene extract(const ecs::World& world, ecs::Entity camera = ecs::kNullEntity,
                       std::optional<float> y_fov = {});
    // As seen by a camera at a transform of the caller's (interpolated between steps, say).
    FrameScene extract(const ecs::World& world, const Camera& camera, const dmat4& camera_to_world);
    // With a view in the render space of origin().
    FrameScene extract(const ecs::World& world, const CameraView& view);

    // World position of render-space 0, of the last extraction.
    const dvec3& origin() const { return origin_; }
    // Of the last extraction: what was left out and why, one line each.
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    struct Source {
        ecs::Entity entity;
        const WorldTransform* transform;
        const MeshInstances* meshes;
        const DeformedMeshes* deformed;  // null: none is

        // Mesh `k` as deformed; null: as it is.
        const DeformedMesh* deformed_mesh(std::size_t k) const;
        // From where the vertices of mesh `k` are given to world space.
        dmat4 to_world(std::size_t k) const;
    };

    // One mesh of a source.
    struct Part {
        std::uint32_t id, mesh;       // as Instance's
        std::uint32_t source, place;  // into sources_, into its MeshInstances::meshes
        const Mesh* asset;            // of the frame's assets
    };

    // Everything but the camera and what changed.
    FrameScene gather(const ecs::World& world);
    void order_parts(const SceneAssets& assets, const ecs::World& world);
    void place_origin();
    void add_instances(FrameScene& frame, const ecs::World& world);
    void add_lights(FrameScene& frame, const ecs::World& world);
    void add_sky(FrameScene& frame, const ecs::World& world);
    void add_clear_sky(FrameScene& frame, const ecs::World& world);
    void add_sensors(FrameScene& frame, const ecs::World& world);
    FrameScene finish(FrameScene frame);
    // Tells those that have been still for long; `earlier`: by instance, its index in last_.
    void mark_static(FrameScene& frame, const std::vector<std::uint32_t>& earlier);

    std::uint64_t frames_ = 0;
    dvec3 origin_{0};
    bool have_origin_ = false;
    std::vector<std::string> warnings_;
    // The newest clear day that a ClearSky asked for.
    std::shared_ptr<const SkyImage> clear_sky_;
    vec3 clear_to_sun_{0};
    float clear_turbidity_ = 0;

    // Of this extraction, kept for their memory.
    std::vector<Source> sources_;
    std::vector<Part> parts_;  // in the order of instances
    // The last extraction, but for what is deformed: that memory is to be free for the next.
    FrameScene last_;
    std::vector<std::uint32_t> unmoved_;  // extractions since each instance's last move
};

}  // namespace lanthorn
