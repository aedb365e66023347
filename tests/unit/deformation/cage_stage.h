// A cage on a stage of its own, and what holds of every surface that comes of one.
#pragma once

#include "tests/unit/deformation/rig.h"

namespace deformation_test {

// One cage on an entity of its own.
struct Cage : Stage {
    Figure figure;
    Random random{21};

    explicit Cage(const Mesh& mesh, std::uint32_t joints = 0) {
        show({mesh});
        figure = Stage::figure(0, joints, random);
        update();
    }
    const DeformedMesh& result() { return deformed(figure).meshes.at(0); }
    const std::vector<VertexFrame>& vertices() { return *result().vertices; }
    const RefinedTopology& topology() { return *result().refined; }
};

inline void expect_whole(const DeformedMesh& mesh) {
    ASSERT_TRUE(mesh.refined);
    const RefinedTopology& topology = *mesh.refined;
    EXPECT_NE(topology.serial, 0u);
    EXPECT_EQ(topology.uv0.size(), mesh.vertices->size());
    EXPECT_EQ(topology.uv1.size(), mesh.vertices->size());
    EXPECT_EQ(topology.colours.size(), mesh.vertices->size());
    ASSERT_EQ(topology.indices.size() % 3, 0u);
    for (const std::uint32_t i : topology.indices) {
        ASSERT_LT(i, mesh.vertices->size());
    }
    expect_sound(mesh);
}

}  // namespace deformation_test
