// The system: what is redone when, what is kept, and what it says of bad data.
#include "lanthorn/deformation/deformation.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstring>

#include "tests/unit/deformation/allocations.h"
#include "tests/unit/deformation/rig.h"

namespace deformation_test {
namespace {

// Some figures of one rig, with morphs.
struct Troupe : Stage {
    Random random{11};
    Mesh mesh;
    std::vector<Figure> figures;

    explicit Troupe(std::uint32_t count = 1, std::uint32_t vertices = 3000) {
        mesh = cloud(vertices, random);
        add_skin(mesh, 30, 4, random);
        mesh.morphs = {target(mesh, 60, random), target(mesh, vertices - 1, random)};
        mesh.morph_weights = {0, 0};
        show({mesh});
        for (std::uint32_t i = 0; i < count; ++i) {
            figures.push_back(figure(0, 30, random));
            world.add(figures.back().entity, MorphWeights{{0.5f, 0.25f}});
        }
    }
    const DeformedMesh& only(std::size_t i = 0) { return deformed(figures[i]).meshes.at(0); }
    void expect_right(std::size_t i = 0) {
        const DeformedMeshes& d = deformed(figures[i]);
        const auto& weights = world.get<MorphWeights>(figures[i].entity).weights;
        expect_near(d.meshes.at(0),
                    skinned(mesh, weights, joint_matrices(figures[i]), figures[i].inverse_binds),
                    d.skinned_at, mesh.bounds.diagonal());
    }
};

TEST(Deformation, AnUnchangedPoseKeepsItsVersion) {
    Troupe troupe(2);
    troupe.update();
    const DeformedMesh before = troupe.only(0), other = troupe.only(1);
    const ecs::Tick since = troupe.world.mark();
    troupe.update();
    EXPECT_EQ(troupe.only(0).version, before.version);
    EXPECT_EQ(troupe.only(0).vertices, before.vertices);
    EXPECT_FALSE(troupe.world.changed<DeformedMeshes>(troupe.figures[0].entity, since));

    troupe.pose(troupe.figures[0], troupe.random);
    troupe.update();
    EXPECT_NE(troupe.only(0).version, before.version);
    EXPECT_NE(troupe.only(0).vertices, before.vertices);
    EXPECT_EQ(troupe.only(1).version, other.version);
    troupe.expect_right(0);

    troupe.world.get_mut<MorphWeights>(troupe.figures[1].entity).weights[0] = 0.75f;
    troupe.update();
    EXPECT_NE(troupe.only(1).version, other.version);
    troupe.expect_right(1);
}

TEST(Deformation, AFigureThatOnlyWalksOnKeepsItsVersion) {
    Troupe troupe;
    for (const ecs::Entity joint : troupe.figures[0].joints) {
        // Powers of two add without rounding.
        dmat4& m = troupe.world.get_mut<WorldTransform>(joint).matrix;
        for (int axis = 0; axis < 3; ++axis) {
            m[3][axis] = std::round(m[3][axis] * 256) / 256;
        }
    }
    troupe.update();
    const std::uint64_t version = troupe.only().version;
    const dvec3 at = troupe.deformed(troupe.figures[0]).skinned_at;
    for (const ecs::Entity joint : troupe.figures[0].joints) {
        troupe.world.get_mut<WorldTransform>(joint).matrix[3] += dvec4(1024, 0, -512, 0);
    }
    troupe.update();
    EXPECT_EQ(troupe.only().version, version);
    EXPECT_EQ(troupe.deformed(troupe.figures[0]).skinned_at, at + dvec3(1024, 0, -512));
    troupe.expect_right();
}

TEST(Deformation, VersionsOfOneWorldRiseInTheSameOrderInEveryRun) {
    const auto order = [] {
        Troupe troupe(9, 64);
        troupe.update();
        std::vector<std::uint64_t> versions;
        for (std::size_t i = 0; i < 9; ++i) {
            versions.push_back(troupe.only(i).version - troupe.only(0).version);
        }
        return versions;
    };
    EXPECT_EQ(order(), order());
}

TEST(Deformation, AnyNumberOfThreadsGivesTheSameBits) {
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 8);
    const auto vertices = [](int threads) {
        std::vector<VertexFrame> all;
        tbb::task_arena(threads).execute([&] {
            Troupe troupe(5, 5000);
            troupe.update();
            for (std::size_t i = 0; i < 5; ++i) {
                all.insert(all.end(), troupe.only(i).vertices->begin(), troupe.only(i).vertices->end());
            }
        });
        return all;
    };
    const auto one = vertices(1);
    for (const int threads : {2, 3, 8}) {
        const auto many = vertices(threads);
        ASSERT_EQ(many.size(), one.size());
        EXPECT_EQ(std::memcmp(many.data(), one.data(), one.size() * sizeof(VertexFrame)), 0) << threads;
    }
}

TEST(Deformation, AllocatesNothingOnceItRuns) {
    Troupe troupe(4);
    const auto frame = [&] {
        for (const Figure& f : troupe.figures) {
            troupe.pose(f, troupe.random);
        }
        troupe.world.get_mut<MorphWeights>(troupe.figures[1].entity).weights[1] += 0.01f;
        troupe.update();
    };
    std::vector<DeformedMesh> last[2];
    const auto hold = [&](int frame_number) {
        auto& frames = last[frame_number % 2];
        frames.clear();
        for (std::size_t i = 0; i < troupe.figures.size(); ++i) {
            frames.push_back(troupe.only(i));
        }
    };
    for (int i = 0; i < 10; ++i) {
        frame();
        hold(i);
    }
    const std::uint64_t before = allocations();
    for (int i = 0; i < 20; ++i) {
        frame();
        hold(i);
    }
    EXPECT_EQ(allocations(), before);
}

TEST(Deformation, WhatAFrameHoldsIsNeverWrittenAgain) {
    Troupe troupe;
    troupe.update();
    const DeformedMesh held = troupe.only();
    const std::vector<VertexFrame> copy = *held.vertices;
    for (int i = 0; i < 6; ++i) {
        troupe.pose(troupe.figures[0], troupe.random);
        troupe.update();
        EXPECT_NE(troupe.only().vertices, held.vertices);
    }
    EXPECT_EQ(*held.vertices, copy);
}

TEST(Deformation, FollowsTheAssets) {
    Troupe troupe;
    troupe.update();
    const std::uint64_t version = troupe.only().version;
    troupe.show({troupe.mesh});  // another serial, the same data
    troupe.update();
    EXPECT_EQ(troupe.only().version, version);
    troupe.mesh.vertices[5].position.x += 1;
    troupe.show({troupe.mesh});
    troupe.update();
    EXPECT_NE(troupe.only().version, version);
    troupe.expect_right();

    Mesh stiff = troupe.mesh;
    stiff.skin.clear();
    stiff.morphs.clear();
    troupe.show({stiff});
    troupe.update();
    EXPECT_FALSE(troupe.world.has<DeformedMeshes>(troupe.figures[0].entity));
}

// The first mesh goes with its last figure; the next takes its slot.
TEST(Deformation, AnotherMeshInAReleasedSlotIsDeformedItself) {
    Troupe troupe;
    troupe.update();
    const MeshHandle gone = troupe.shown[0];
    const ecs::Entity figure = troupe.figures[0].entity;
    troupe.world.insert(figure, MeshInstances{});
    AssetStore& store = asset_store(troupe.world);
    ASSERT_FALSE(store.alive(gone));
    troupe.mesh.vertices[5].position.x += 1;
    const MaterialHandle material = store.add(Material());
    troupe.mesh.material = material.slot;
    troupe.shown[0] = store.add(troupe.mesh);
    ASSERT_EQ(troupe.shown[0].slot, gone.slot);
    troupe.world.insert(figure, MeshInstances{{troupe.shown[0]}});
    troupe.update();
    troupe.expect_right();
}

TEST(Deformation, LeavesEntitiesAloneWhoseMeshesDoNotDeform) {
    Stage stage;
    Random random(12);
    stage.show({cloud(10, random)});
    const Figure figure = stage.figure(0, 0, random);
    stage.update();
    EXPECT_FALSE(stage.world.has<DeformedMeshes>(figure.entity));
}

TEST(Deformation, ASkinnedMeshWithoutASkinIsDrawnAsItIs) {
    Stage stage;
    Random random(13);
    Mesh mesh = cloud(10, random);
    add_skin(mesh, 2, 2, random);
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    stage.update();
    EXPECT_FALSE(stage.deformed(figure).skinned);
    EXPECT_FALSE(stage.deformed(figure).meshes.at(0).vertices);
}

struct BadSkin {
    const char* name;
    void (*spoil)(Troupe&);
    const char* says;
};

class Bad : public testing::TestWithParam<BadSkin> {};

TEST_P(Bad, IsNamedAndTheLastShapeKept) {
    for (const bool had_a_shape : {true, false}) {
        Troupe troupe;
        troupe.world.add(troupe.figures[0].entity, Name{"puppet"});
        if (had_a_shape) {
            troupe.update();
        }
        const DeformedMesh before = had_a_shape ? troupe.only() : DeformedMesh{};
        GetParam().spoil(troupe);
        troupe.update();
        EXPECT_EQ(troupe.only().vertices, before.vertices);
        EXPECT_EQ(troupe.only().version, before.version);
        ASSERT_EQ(troupe.deformation.warnings().size(), 1u);
        const std::string& line = troupe.deformation.warnings()[0];
        EXPECT_NE(line.find("'puppet'"), std::string::npos) << line;
        EXPECT_NE(line.find(GetParam().says), std::string::npos) << line;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Skins, Bad,
    testing::Values(
        BadSkin{"TooFewJoints",
                [](Troupe& t) {
                    auto& skin = t.world.get_mut<SkinInstance>(t.figures[0].entity);
                    skin.joints.resize(29);
                    skin.inverse_binds.resize(5);
                },
                "fewer joints"},
        BadSkin{"TooFewInverseBinds",
                [](Troupe& t) { t.world.get_mut<SkinInstance>(t.figures[0].entity).inverse_binds.resize(5); },
                "inverse bind matrices"},
        BadSkin{"ADeadJoint", [](Troupe& t) { t.world.destroy(t.figures[0].joints[7]); }, "is gone"},
        BadSkin{"ANaNJoint",
                [](Troupe& t) {
                    t.world.get_mut<WorldTransform>(t.figures[0].joints[3]).matrix[1][1] = std::nan("");
                },
                "not finite"},
        BadSkin{"AnInfiniteFirstJoint",
                [](Troupe& t) {
                    t.world.get_mut<WorldTransform>(t.figures[0].joints[0]).matrix[3][0] = INFINITY;
                },
                "not finite"}),
    [](const auto& info) { return info.param.name; });

TEST(Deformation, WeightsThatAreNotFiniteCountAsZero) {
    Troupe troupe;
    troupe.world.get_mut<MorphWeights>(troupe.figures[0].entity).weights = {std::nanf(""), INFINITY};
    troupe.update();
    ASSERT_EQ(troupe.deformation.warnings().size(), 1u);
    troupe.world.get_mut<MorphWeights>(troupe.figures[0].entity).weights = {0, 0};
    troupe.expect_right();
}

TEST(Deformation, VerticesThrownToInfinityAreNotDrawn) {
    Troupe troupe;
    troupe.world.get_mut<MorphWeights>(troupe.figures[0].entity).weights = {3e38f, 3e38f};
    for (const ecs::Entity joint : troupe.figures[0].joints) {
        troupe.world.get_mut<WorldTransform>(joint).matrix = dmat4(1);
        troupe.world.get_mut<WorldTransform>(joint).matrix[0][0] = 1e20;
    }
    troupe.update();
    EXPECT_FALSE(troupe.only().vertices);
    ASSERT_EQ(troupe.deformation.warnings().size(), 1u);
    EXPECT_NE(troupe.deformation.warnings()[0].find("beyond all bounds"), std::string::npos);
}

TEST(Deformation, AMeshThatIsTakenAwayOrAWorldThatIsAnotherLeavesNothingBehind) {
    Troupe troupe(2);
    troupe.update();
    troupe.world.insert(troupe.figures[0].entity, MeshInstances{});
    troupe.world.destroy(troupe.figures[1].entity);
    troupe.update();
    EXPECT_FALSE(troupe.world.has<DeformedMeshes>(troupe.figures[0].entity));

    Troupe other;
    troupe.deformation.update(other.world);
    other.expect_right();
}

}  // namespace
}  // namespace deformation_test
