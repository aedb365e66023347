#include "engine/scene/instance_shape.h"

namespace lanthorn {

Mesh posed_mesh(const InstanceShape& shape) {
    Mesh posed;
    posed.name = shape.mesh().name;
    posed.material = shape.mesh().material;
    posed.indices.assign(shape.indices().begin(), shape.indices().end());
    posed.vertices.resize(shape.vertex_count());
    const DeformedMesh* deformed = shape.deformed();
    const RefinedTopology* refined = deformed ? deformed->refined.get() : nullptr;
    for (std::size_t v = 0; v < posed.vertices.size(); ++v) {
        Vertex& vertex = posed.vertices[v];
        if (refined) {
            vertex.uv0 = refined->uv0[v];
            vertex.uv1 = refined->uv1[v];
            vertex.colour = refined->colours[v];
        } else {
            vertex = shape.mesh().vertices[v];
        }
        if (deformed) {
            const VertexFrame& frame = (*deformed->vertices)[v];
            vertex.position = frame.position;
            vertex.normal = frame.normal;
            vertex.tangent = frame.tangent;
        }
        posed.bounds.add(vertex.position);
    }
    return posed;
}

}  // namespace lanthorn
