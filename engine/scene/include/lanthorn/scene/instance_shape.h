// An instance's triangles as they stand in this frame: its mesh's own, or what deformation made of it.
#pragma once

#include <span>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

class InstanceShape {
  public:
    // `scene` must outlive this, and `instance` be one of its instances. O(1).
    InstanceShape(const FrameScene& scene, const Instance& instance)
        : mesh_(scene.mesh(instance)),
          deformed_(instance.deformed == Instance::kNotDeformed ? nullptr
                                                                : &scene.deformed[instance.deformed]) {}

    // A mesh as it is, placed nowhere yet.
    explicit InstanceShape(const Mesh& mesh) : mesh_(mesh), deformed_(nullptr) {}

    const Mesh& mesh() const { return mesh_; }  // undeformed, for what deformation leaves alone
    const DeformedMesh* deformed() const { return deformed_; }  // null: the mesh as it is
    // 3 a triangle, counter-clockwise front.
    std::span<const std::uint32_t> indices() const {
        return deformed_ && deformed_->refined ? deformed_->refined->indices : mesh_.indices;
    }
    // Of the deformed vertices, if it is deformed.
    std::size_t vertex_count() const {
        return deformed_ ? deformed_->vertices->size() : mesh_.vertices.size();
    }
    // In the space that Instance::transform takes to render space.
    vec3 position(std::size_t vertex) const {
        return deformed_ ? (*deformed_->vertices)[vertex].position : mesh_.vertices[vertex].position;
    }
    // The same with every attribute.
    Vertex vertex(std::size_t vertex) const;
    // Half the cross product of triangle `t`'s edges in render space, for triangles that `linear`, the
    // instance's transform without its translation, takes there: its length is the area.
    vec3 half_cross(std::size_t t, const mat3& linear) const {
        const auto corners = indices().subspan(3 * t, 3);
        const vec3 p0 = position(corners[0]);
        return 0.5f * glm::cross(linear * (position(corners[1]) - p0), linear * (position(corners[2]) - p0));
    }

  private:
    const Mesh& mesh_;
    const DeformedMesh* deformed_;
};

// The same as a separate mesh, every attribute included. O(vertices + indices).
Mesh posed_mesh(const InstanceShape& shape);

}  // namespace lanthorn
