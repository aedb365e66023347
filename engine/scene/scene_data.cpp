#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

dmat4 Transform::matrix() const {
    const mat3 r = glm::mat3_cast(rotation);
    return {dvec4(dvec3(r[0] * scale.x), 0), dvec4(dvec3(r[1] * scale.y), 0), dvec4(dvec3(r[2] * scale.z), 0),
            dvec4(translation, 1)};
}

std::uint64_t SceneData::triangle_count() const {
    std::uint64_t count = 0;
    for (const Mesh& mesh : meshes) {
        count += mesh.indices.size() / 3;
    }
    return count;
}

}  // namespace lanthorn
