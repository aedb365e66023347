#include "lanthorn/scene/instance_shape.h"

namespace lanthorn {

Vertex InstanceShape::vertex(std::size_t v) const {
    Vertex vertex;
    if (const RefinedTopology* refined = deformed_ ? deformed_->refined.get() : nullptr) {
        vertex.uv0 = refined->uv0[v];
        vertex.uv1 = refined->uv1[v];
        vertex.colour = refined->colours[v];
    } else {
        vertex = mesh_.vertices[v];
    }
    if (deformed_) {
        const VertexFrame& frame = (*deformed_->vertices)[v];
        vertex.position = frame.position;
        vertex.normal = frame.normal;
        vertex.tangent = frame.tangent;
    }
    return vertex;
}

Mesh posed_mesh(const InstanceShape& shape) {
    Mesh posed;
    posed.name = shape.mesh().name;
    posed.material = shape.mesh().material;
    posed.indices.assign(shape.indices().begin(), shape.indices().end());
    posed.vertices.reserve(shape.vertex_count());
    for (std::size_t v = 0; v < shape.vertex_count(); ++v) {
        posed.vertices.push_back(shape.vertex(v));
        posed.bounds.add(posed.vertices.back().position);
    }
    return posed;
}

}  // namespace lanthorn
