// One instance's points of light: where they are in this frame and what light is known there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gi_module/techniques/vertex-map/radiance_estimate.h"
#include "gi_module/techniques/vertex-map/surface_shares.h"
#include "gi_module/techniques/vertex-map/vertex_mesh.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

// How finely meshes are split, in metres.
struct VertexDetail {
    float edge = 1;      // of a triangle at most
    float reach = 1;     // the largest radius of an estimate
    int density = 0;     // levels more where photons lie close
    bool shared = true;  // corners
    bool operator==(const VertexDetail&) const = default;
};

// A corner's light.
struct CornerLight {
    LightEstimate estimate;
    std::uint64_t version = 0;  // of the photons that it was estimated from; 0: none
};

class VertexShape {
  public:
    VertexShape(const FrameScene& scene, const Instance& instance, const VertexDetail& detail);

    // Whether it is the instance's still, however that has moved.
    bool is_of(const FrameScene& scene, const Instance& instance) const;
    // Moves to where the instance is. False if it does not fit any more, being scaled: make another.
    // O(vertices) where it moved or was deformed.
    bool follow(const FrameScene& scene, const Instance& instance);
    // Splits triangles further, or less, by how close the photons of their corners' estimates lie: to edges
    // of at most the radius that the photons were found in (Jozwowski 2002, sec. 6, "Surface
    // Subdivision"). `coarser`: less, too; while light holds still that might be wanted back, for ever.
    // True if any is split otherwise. O(triangles).
    bool refine(bool coarser);

    // Corners of both sides where the material shows both: those of the back behind those of the front.
    const std::vector<EstimatePoint>& points() const { return points_; }
    const std::vector<std::uint32_t>& triangles() const { return triangles_; }  // 3 corners each
    std::vector<CornerLight>& light() { return light_; }
    const std::vector<CornerLight>& light() const { return light_; }
    const std::vector<HangingCorner>& hanging() const { return hanging_; }
    // Of corners: into hanging(), or -1.
    const std::vector<std::int32_t>& hangs() const { return hangs_; }

    // The point of one of the mesh's triangles, by the weights of its second and third vertex, on its front
    // or back: which of triangles() it lies on and the weights of that one's corners. Nothing on a back that
    // the material does not show.
    struct At {
        std::size_t triangle = 0;
        vec3 weights{0};
    };
    std::optional<At> at(std::uint32_t primitive, const vec2& barycentric, bool front) const;

    // Of circles about any point on it, once prepare_shares() has been called. O(triangles near by).
    SurfaceShares shares_at(const vec3& point, const vec3& normal) const {
        return surface_->about(point, normal, both_sides_);
    }
    // Must be called before shares_of() whenever the shape has moved. O(triangles) the first time after it.
    void prepare_shares(const VertexDetail& detail);
    // Of circles about a corner up to the detail's reach. Thread-safe for different corners.
    const SurfaceShares& shares_of(std::size_t corner);
    SurfaceKey key() const { return key_; }
    SurfaceKey lit_as() const { return lit_as_; }
    // Whose photons light it: its own, or those of what it is a copy of (photons/copies.h).
    void take_light_of(SurfaceKey surface);
    std::uint64_t pose() const { return pose_; }  // grows when it moves

  private:
    void place(const FrameScene& scene, const Instance& instance);
    void split();
    void set_points();

    SurfaceKey key_ = 0, lit_as_ = 0;
    std::uint64_t topology_ = 0;  // RefinedTopology::serial, 0: the mesh's own
    std::uint64_t mesh_version_ = 0;
    std::uint64_t deformed_ = 0;  // Instance::version
    bool both_sides_ = false;
    bool mirrored_ = false;  // its triangles go round the other way than the mesh's
    mat4 transform_{1};
    std::uint64_t pose_ = 1;
    VertexDetail detail_;
    std::vector<std::uint32_t> indices_;
    std::vector<vec3> positions_, normals_;  // by vertex, render space
    std::vector<float> longest_;             // edge of each triangle, metres, as it was first seen
    std::vector<std::uint8_t> levels_;
    VertexMesh mesh_;
    std::vector<EstimatePoint> points_;
    std::vector<std::uint32_t> triangles_;
    std::vector<HangingCorner> hanging_;
    std::vector<std::int32_t> hangs_;
    std::vector<CornerLight> light_;
    std::unique_ptr<SurfaceTriangles> surface_;
    std::vector<SurfaceShares> shares_;
    std::vector<std::uint8_t> has_shares_;
};

}  // namespace lanthorn::gi
