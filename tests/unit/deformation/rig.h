// Figures made for these tests, and the world they stand in.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/spawn.h"
#include "tests/unit/deformation/evaluator.h"

namespace deformation_test {

// Numbers of one seed; the same everywhere.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    float between(float low, float high) {
        return low + (high - low) * float(engine_()) / float(std::mt19937::max());
    }
    vec3 vector(float reach) {
        return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
    }
    vec3 direction();
    quat rotation();
    std::uint32_t below(std::uint32_t n) { return std::uint32_t(engine_() % n); }

  private:
    std::mt19937 engine_;
};

// A cloud of vertices about one metre wide with triangles between them.
Mesh cloud(std::uint32_t vertices, Random& random);
// Gives each vertex `influences` joints of `joints`.
void add_skin(Mesh& mesh, std::uint32_t joints, std::uint32_t influences, Random& random);
// A target that moves `moved` of the vertices, with normals and tangents.
MorphTarget target(const Mesh& mesh, std::uint32_t moved, Random& random);

// An entity with one mesh; joints are entities without parents whose world transforms the test writes.
struct Figure {
    ecs::Entity entity;
    std::vector<ecs::Entity> joints;
    std::vector<mat4> inverse_binds;
};

struct Stage {
    ecs::World world;
    Deformation deformation;

    std::vector<MeshHandle> shown;

    // Puts these meshes in the place of those shown before.
    void show(const std::vector<Mesh>& meshes);
    // Joints posed at random near `at`.
    Figure figure(std::uint32_t mesh, std::uint32_t joints, Random& random, const dvec3& at = dvec3(0));
    void pose(const Figure& figure, Random& random, const dvec3& at = dvec3(0));
    std::vector<dmat4> joint_matrices(const Figure& figure);
    void update() { deformation.update(world); }
    const DeformedMeshes& deformed(const Figure& figure) { return world.get<DeformedMeshes>(figure.entity); }
};

// Vertices against the answer; `at` is where they are relative to, `size` what the tolerances are relative
// to.
void expect_near(const DeformedMesh& mesh, const std::vector<ExactVertex>& exact, const dvec3& at,
                 double size);
// Finite, of unit length where due, and bounds that hold them tightly.
void expect_sound(const DeformedMesh& mesh);

}  // namespace deformation_test
