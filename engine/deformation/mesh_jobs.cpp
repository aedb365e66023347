#include "engine/deformation/mesh_jobs.h"

#include <algorithm>

namespace lanthorn::deform {

SubdivisionSurface* surface_of(const MeshState& mesh) {
    SubdivisionSurface* const surface = mesh.mesh->surface.get();
    return surface && surface->problem().empty() ? surface : nullptr;
}

void run(Job& job) {
    const BindPose& pose = job.mesh->mesh->pose;
    const std::span<const VertexGroup> all(pose.groups);
    VertexGroup morphed[kBlockGroups];
    for (std::uint32_t block = job.first_block; block < job.end_block; ++block) {
        const std::uint32_t first = block * kBlockGroups;
        auto groups = all.subspan(first, std::min<std::size_t>(kBlockGroups, all.size() - first));
        if (!job.mesh->morphs.empty()) {
            std::copy(groups.begin(), groups.end(), morphed);
            add_morphs(pose, block, job.mesh->morphs, {morphed, groups.size()});
            groups = {morphed, groups.size()};
        }
        VertexFrame* const to = job.to + std::size_t{block} * kBlockVertices;
        const Pose& joints = job.entity->pose;
        if (!joints.skinned) {
            copy_groups(pose, first, groups, to, job.bounds);
        } else if (pose.skin.empty()) {
            move_groups(pose, joints.joints.back(), first, groups, to, job.bounds);
        } else {
            skin_groups(pose, joints.joints, first, groups, to, job.bounds);
        }
    }
}

void run(RefineJob& job) {
    evaluate(*job.stencils, job.mesh->controls, job.mirrored, job.first, job.end, job.to, job.bounds);
}

bool moves(const EntityState& entity, const MeshState& mesh) {
    return entity.pose.skinned || !mesh.mesh->pose.morphs.empty();
}

void gather_controls(const EntityState& entity, MeshState& mesh) {
    const auto& vertices = mesh.mesh->surface->cage().control_vertices;
    mesh.controls.resize(vertices.size());
    const bool moved = moves(entity, mesh);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::uint32_t v = vertices[i];
        const vec3 p =
            moved ? mesh.cage[v].position : lane_of(mesh.mesh->pose.groups[v / kLanes].position, v % kLanes);
        mesh.controls[i] = Lanes{p.x, p.y, p.z, 0};
    }
}

Extent extent_of(const EntityState& entity, const MeshState& mesh) {
    Aabb box;
    float scale = 0;
    const auto add = [&](const mat4& m) {
        box.add(transformed(mesh.mesh->bounds, m));
        for (int axis = 0; axis < 3; ++axis) {
            scale = std::max(scale, glm::length(vec3(m[axis])));
        }
    };
    dvec3 at(0);
    if (entity.pose.skinned) {
        at = entity.pose.at;
        for (const JointMatrix& joint : entity.pose.joints) {
            add(matrix(joint));
        }
    } else if (entity.sources.transform) {
        dmat4 matrix = entity.sources.transform->matrix;
        at = dvec3(matrix[3]);
        matrix[3] = dvec4(0, 0, 0, 1);
        add(mat4(matrix));
    } else {
        add(mat4(1));
    }
    return {at + dvec3(box.lower), at + dvec3(box.upper), double(scale) * mesh.mesh->surface->longest_edge()};
}

}  // namespace lanthorn::deform
