// The points of light of a whole scene, kept from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/techniques/vertex-map/photon_tree.h"
#include "gi_module/techniques/vertex-map/vertex_map_settings.h"
#include "gi_module/techniques/vertex-map/vertex_shape.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

class VertexScene {
  public:
    // Forgets everything.
    void clear();
    // Becomes this frame's scene: what the picture shows, which is all but blended surfaces. True if points
    // or triangles are others, or elsewhere. Lengths that settings give by the scene's size (its
    // diagonal, or the root of the sum of its things' squared ones, if that is less) stay what
    // they are until it is another by a quarter. O(instances), and what changed.
    bool follow(const FrameScene& scene, const VertexMapSettings& settings);
    // As VertexShape::refine(). True if any triangle is split otherwise.
    bool refine(bool coarser);

    // Both change with follow() and refine() alone.
    std::size_t triangles() const { return triangles_; }
    std::size_t corners() const { return corners_; }
    float reach() const { return detail_.reach; }  // metres: the largest radius of an estimate

    // All corners and triangles, shape after shape.
    void list_positions(std::vector<vec3>& positions) const;
    void list_triangles(std::vector<std::uint32_t>& triangles) const;
    // A part of the irradiance, lux; hanging corners have what the coarser edge has there.
    void list_light(std::vector<vec4>& light, vec3 LightEstimate::*part) const;

    // Estimates light at the corners of the triangles for which `wanted` is not 0 (as list_triangles() orders
    // them; empty: of all) and that have none of this `version` yet. Returns how many corners that were.
    // O(triangles + corners estimated (nearest + log photons)).
    std::size_t estimate(std::span<const std::uint32_t> wanted, std::uint64_t version, const PhotonTree& tree,
                         const PhotonStore& store, const VertexMapSettings& settings,
                         reference::TileWorkers& workers);

    // The point of an instance's triangle by what the picture's triangles have there: which of them, its
    // corners, both as list_triangles() and list_light() order them, and their weights. Nothing where the
    // instance has no light. O(1).
    struct At {
        std::size_t triangle = 0;
        std::array<std::uint32_t, 3> corners{};
        vec3 weights{0};
    };
    std::optional<At> at(std::uint32_t instance, std::uint32_t primitive, const vec2& barycentric,
                         bool front) const;
    // An estimate anywhere on an instance's surface. O(nearest + log photons).
    LightEstimate estimate_at(std::uint32_t instance, const vec3& position, const vec3& normal,
                              const PhotonTree& tree, const PhotonStore& store,
                              const VertexMapSettings& settings);

    // Which triangles face the camera and reach into what it sees, for skip = back_faces.
    std::vector<std::uint32_t> facing(const CameraView& camera) const;

  private:
    void count();

    VertexDetail detail_;
    float diagonal_ = 0;  // that the lengths were taken from
    EstimateSettings estimate_settings(const VertexMapSettings& settings) const;

    std::vector<std::unique_ptr<VertexShape>> shapes_;
    // By shape: its first triangle and corner among all.
    struct First {
        std::size_t triangle = 0;
        std::uint32_t corner = 0;
    };
    std::vector<First> firsts_;
    std::vector<std::int32_t> shape_of_;  // by instance; -1: it is blended
    std::size_t triangles_ = 0, corners_ = 0;
};

}  // namespace lanthorn::gi
