#include "lanthorn/scene/extract.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "engine/scene/clear_sky.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/transforms.h"
#include "lanthorn/scene/view.h"
#include "tests/unit/scene/scenes.h"

namespace lanthorn {
namespace {

using namespace scene_test;
using ecs::Entity;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

class Extract : public testing::Test {
  protected:
    void load(SceneData scene) { e = spawn(world, std::move(scene)); }
    FrameScene extract() {
        transforms.update(world);
        return extractor.extract(world, camera);
    }
    Transform& local(std::size_t node) { return world.get_mut<LocalTransform>(e[node]).value; }

    ecs::World world;
    Transforms transforms;
    Extractor extractor;
    std::vector<Entity> e;
    Entity camera;
};

TEST_F(Extract, WithoutASkyOfItsOwnAWorldHasItsBackdrops) {
    const auto sky = [](float nits) {
        SkyImage image;
        image.width = 2;
        image.height = 1;
        image.radiance.assign(2, vec3(nits));
        Sky made;
        made.image = std::make_shared<const SkyImage>(std::move(image));
        return made;
    };
    load(room());
    EXPECT_FALSE(extract().sky);
    const Sky behind = sky(1), own = sky(2);
    world.insert_resource(Backdrop{behind});
    FrameScene frame = extract();
    ASSERT_TRUE(frame.sky);
    EXPECT_EQ(frame.sky->sky, behind);
    EXPECT_TRUE(frame.changes.lights);
    EXPECT_FALSE(extract().changes.lights);
    world.insert(e.front(), SkyComponent{own});
    frame = extract();
    ASSERT_TRUE(frame.sky);
    EXPECT_EQ(frame.sky->sky, own);
}

TEST_F(Extract, AViewsOwnAngleTakesTheCamerasPlace) {
    load(room());
    camera = world.query<ecs::With<CameraComponent>>().entities().front();
    const FrameScene before = extract();
    const FrameScene wide = extractor.extract(world, camera, 1.3f);
    EXPECT_EQ(wide.camera.camera.y_fov, 1.3f);
    EXPECT_EQ(wide.camera.view, before.camera.view);
    EXPECT_TRUE(wide.changes.camera);
    EXPECT_EQ(extract().camera, before.camera);
}

TEST_F(Extract, YieldsTheSkyTurnedWithItsNode) {
    SceneData data = room();
    NodeData node;
    node.sky = 0;
    node.local.translation = dvec3(5, 6, 7);
    node.local.rotation = glm::angleAxis(kPi / 2, vec3(0, 1, 0));  // +X of the image shines from -Z
    data.nodes.push_back(node);
    Sky sky;
    sky.image = std::make_shared<const SkyImage>(SkyImage{"grey", 2, 1, {vec3(1), vec3(2)}});
    sky.intensity = 3;
    data.skies.push_back(sky);
    load(std::move(data));
    camera = e[1];
    FrameScene frame = extract();
    ASSERT_TRUE(frame.sky);
    EXPECT_EQ(frame.sky->id, e.back().index);
    EXPECT_EQ(frame.sky->scale(), vec3(3));
    EXPECT_NEAR(glm::length(frame.sky->to_sky * vec3(0, 0, -1) - vec3(1, 0, 0)), 0, 1e-6);
    frame = extract();
    EXPECT_FALSE(frame.changes.lights);
    local(e.size() - 1).rotation = quat(1, 0, 0, 0);
    EXPECT_TRUE(extract().changes.lights) << "it has been turned";
    world.get_mut<SkyComponent>(e.back()).sky.intensity = 0;
    frame = extract();
    EXPECT_FALSE(frame.sky) << "black";
    EXPECT_TRUE(frame.changes.lights);
    world.get_mut<SkyComponent>(e.back()).sky.intensity = static_cast<float>(kNan);
    frame = extract();
    EXPECT_FALSE(frame.sky);
    ASSERT_EQ(extractor.warnings().size(), 1u);
    EXPECT_NE(extractor.warnings()[0].find("the sky's transform or strength is not finite"),
              std::string::npos);
}

TEST_F(Extract, AClearSkyStandsAboutItsSun) {
    load(room());
    const Entity sun = world.create(LocalTransform{}, WorldTransform{},
                                    LightComponent{clear_sun(vec3(0, 1, 0))}, ClearSky{});
    world.get_mut<LocalTransform>(sun).value.rotation =
        glm::angleAxis(-kPi / 2, vec3(1, 0, 0));  // it shines down
    world.get_mut<LightComponent>(sun).light.type = LightType::directional;
    const FrameScene noon = extract();
    ASSERT_TRUE(noon.sky);
    EXPECT_EQ(noon.sky->id, sun.index);
    EXPECT_NEAR(noon.sky->sky.intensity, 1, 1e-5);
    EXPECT_EQ(extract().sky->sky.image, noon.sky->sky.image) << "made once";
    // Half the sun and twice the factor, then a sun elsewhere, one that is off, and one below the horizon.
    world.get_mut<LightComponent>(sun).light.intensity *= 0.5f;
    world.get_mut<ClearSky>(sun).intensity = 4;
    EXPECT_NEAR(extract().sky->sky.intensity, 2, 1e-5);
    world.get_mut<LocalTransform>(sun).value.rotation = glm::angleAxis(-kPi / 4, vec3(1, 0, 0));
    const FrameScene later = extract();
    EXPECT_NE(later.sky->sky.image, noon.sky->sky.image);
    EXPECT_TRUE(later.changes.lights);
    world.get_mut<LightComponent>(sun).light.intensity = 0;
    EXPECT_FALSE(extract().sky);
    world.get_mut<LightComponent>(sun).light.intensity = 10;
    world.get_mut<LocalTransform>(sun).value.rotation = glm::angleAxis(kPi / 4, vec3(1, 0, 0));
    EXPECT_FALSE(extract().sky);
}

TEST_F(Extract, YieldsTheSceneInRenderSpace) {
    load(room());
    camera = e[1];
    const FrameScene frame = extract();
    EXPECT_EQ(frame.frame, 0u);
    EXPECT_EQ(frame.origin, dvec3(15, 0, 0));
    EXPECT_EQ(frame.assets, world.resource<AssetStore>().snapshot());
    ASSERT_EQ(frame.instances.size(), 2u);
    EXPECT_EQ(frame.instances[0].id, e[0].index);
    EXPECT_EQ(vec3(frame.instances[0].transform[3]), vec3(-5, 0, 0));
    EXPECT_EQ(frame.instances[1].bounds, (Aabb{vec3(4, -1, -1), vec3(6, 1, 1)}));
    EXPECT_EQ(frame.bounds, (Aabb{vec3(-6, -1, -1), vec3(6, 1, 1)}));
    ASSERT_EQ(frame.lights.size(), 1u);
    EXPECT_EQ(frame.lights[0].position, vec3(-5, 2, 0));
    EXPECT_EQ(frame.lights[0].direction, vec3(0, 0, -1));
    EXPECT_EQ(frame.camera.position, vec3(-5, 2, 0));
    EXPECT_TRUE(extractor.warnings().empty());
}

DeformedMesh deformed(std::uint64_t version, const vec3& lower, const vec3& upper) {
    DeformedMesh mesh;
    mesh.version = version;
    mesh.vertices = std::make_shared<std::vector<VertexFrame>>(8);
    mesh.bounds = {lower, upper};
    return mesh;
}

TEST_F(Extract, DeformedMeshesAreWhereTheirJointsSayAndMoveWhenTheirVerticesDo) {
    load(room());
    world.add(e[0], DeformedMeshes{{deformed(1, vec3(-1), vec3(2))}, false, {}});
    world.add(e[2], DeformedMeshes{{deformed(2, vec3(-1), vec3(1))}, true, dvec3(30, 1, 0)});
    const FrameScene first = extract();
    ASSERT_EQ(first.instances.size(), 2u);
    ASSERT_EQ(first.deformed.size(), 2u);
    EXPECT_EQ(first.deformed[first.instances[1].deformed].version, 2u);
    const vec3 table(dvec3(10, 0, 0) - first.origin);
    EXPECT_EQ(first.instances[0].bounds, (Aabb{table - vec3(1), table + vec3(2)}));
    EXPECT_EQ(vec3(first.instances[1].transform[3]), vec3(dvec3(30, 1, 0) - first.origin));
    for (std::uint32_t i = 0; i < kStaticAfter; ++i) {
        EXPECT_FALSE(extract().instances[1].is_static && i == 0);
    }
    const FrameScene still = extract();
    EXPECT_FALSE(still.changes.geometry);
    EXPECT_TRUE(still.instances[1].is_static);
    world.get_mut<DeformedMeshes>(e[2]).meshes[0].version = 3;
    const FrameScene moved = extract();
    EXPECT_EQ(moved.changes.moved, (std::vector<std::uint32_t>{1}));
    EXPECT_FALSE(moved.instances[1].is_static);
    EXPECT_TRUE(moved.instances[0].is_static);
}

TEST_F(Extract, TheFirstHasEverythingChanged) {
    load(room());
    const SceneChanges c = extract().changes;
    EXPECT_TRUE(c.assets && c.geometry && c.lights && c.camera);
    EXPECT_EQ(c.moved, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(c.dirty, (Aabb{vec3(-6, -1, -1), vec3(6, 1, 1)}));
    EXPECT_FALSE(c.nothing());
}

TEST_F(Extract, AStillSceneChangesNothing) {
    load(room());
    extract();
    local(0);  // written, not altered
    const FrameScene frame = extract();
    const SceneChanges& c = frame.changes;
    EXPECT_FALSE(c.assets || c.geometry || c.lights || c.camera);
    EXPECT_TRUE(c.moved.empty());
    EXPECT_TRUE(c.dirty.empty());
    EXPECT_TRUE(c.nothing());
    EXPECT_EQ(frame.frame, 1u);
}

TEST_F(Extract, TellsWhatMovedAndWhere) {
    load(room());
    extract();
    local(2).translation.x = 22;
    const FrameScene frame = extract();
    EXPECT_TRUE(frame.changes.geometry);
    EXPECT_FALSE(frame.changes.lights);
    EXPECT_EQ(frame.changes.moved, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(frame.changes.dirty, (Aabb{vec3(4, -1, -1), vec3(8, 1, 1)}));  // old and new place
    EXPECT_EQ(frame.origin, dvec3(15, 0, 0));                                // kept
    EXPECT_TRUE(extract().changes.nothing());
}

TEST_F(Extract, TellsLightsAndCameraApart) {
    load(room());
    camera = world.create(LocalTransform{}, CameraComponent{});
    extract();
    local(1).translation.y = 3;
    SceneChanges c = extract().changes;
    EXPECT_TRUE(c.lights);
    EXPECT_FALSE(c.geometry || c.camera || c.assets);
    world.get_mut<LightComponent>(e[1]).light.intensity = 7;
    EXPECT_TRUE(extract().changes.lights);
    world.get_mut<LocalTransform>(camera).value.translation.z = 3;
    c = extract().changes;
    EXPECT_TRUE(c.camera);
    EXPECT_TRUE(c.nothing());
    world.remove<LightComponent>(e[1]);
    c = extract().changes;
    EXPECT_TRUE(c.lights);
}

TEST_F(Extract, TellsWhatCameAndWent) {
    load(room());
    extract();
    world.destroy(e[2]);
    SceneChanges c = extract().changes;
    EXPECT_TRUE(c.geometry);
    EXPECT_TRUE(c.moved.empty());
    EXPECT_EQ(c.dirty, (Aabb{vec3(4, -1, -1), vec3(6, 1, 1)}));
    // The same index again at the same place is another thing.
    const Entity reborn = world.create(LocalTransform{}, MeshInstances{{MeshHandle{0, 0}}});
    EXPECT_EQ(reborn.index, e[2].index);
    world.get_mut<LocalTransform>(reborn).value.translation = {20, 0, 0};
    const FrameScene frame = extract();
    EXPECT_EQ(frame.changes.moved, (std::vector<std::uint32_t>{1}));
    world.destroy(reborn);
    Transform there;
    there.translation = {20, 0, 0};
    world.create(LocalTransform{there}, MeshInstances{{MeshHandle{0, 0}}});
    c = extract().changes;
    EXPECT_TRUE(c.geometry);
    EXPECT_EQ(c.moved.size(), 1u);
}

TEST_F(Extract, TellsWhichAssetsAreOther) {
    load(room());
    EXPECT_TRUE(extract().changes.replaced);
    AssetStore& store = asset_store(world);
    const MaterialHandle other = store.add(Material());
    SceneChanges c = extract().changes;
    EXPECT_TRUE(c.assets && c.nothing());
    EXPECT_EQ(c.materials, (std::vector<std::uint32_t>{other.slot}));
    EXPECT_TRUE(c.meshes.empty() && c.images.empty() && c.painted.empty() && !c.replaced);
    store.edit_material(other, [](Material& m) { m.emissive = vec3(1); });
    EXPECT_FALSE(extract().changes.emission) << "nothing shows it";

    const MeshHandle mesh = world.get<MeshInstances>(e[0]).meshes[0];
    const MaterialHandle shown = store.material_of(mesh);
    store.edit_material(shown, [](Material& m) { m.base_colour.r = 0.5f; });
    c = extract().changes;
    EXPECT_EQ(c.painted, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_FALSE(c.geometry || c.pattern || c.emission || c.relief || c.nothing());
    store.edit_material(shown, [](Material& m) { m.metallic = 0.5f; });
    c = extract().changes;
    EXPECT_TRUE(c.pattern && c.painted.size() == 2 && !c.geometry);
    store.edit_material(shown, [](Material& m) { m.emissive = vec3(1); });
    c = extract().changes;
    EXPECT_TRUE(c.emission && c.painted.empty());
    store.edit_material(shown, [](Material& m) { m.double_sided = true; });
    c = extract().changes;
    EXPECT_EQ(c.moved, (std::vector<std::uint32_t>{0, 1})) << "other sides of it are seen";
    store.edit_mesh(mesh, [](Mesh& m) { m.vertices[0].position.x -= 1; });
    c = extract().changes;
    EXPECT_TRUE(c.geometry && !c.replaced && c.arrived.empty());
    EXPECT_EQ(c.meshes, (std::vector<std::uint32_t>{mesh.slot}));
}

TEST_F(Extract, TellsWhatArrivedAndThatNothingIsLeft) {
    load(room());
    extract();
    const std::vector<Entity> more = spawn(world, world.get<Source>(e[0]).scene);
    SceneChanges c = extract().changes;
    EXPECT_EQ(c.arrived.size(), 2u);
    EXPECT_FALSE(c.replaced || c.assets) << "the same assets again";
    for (const Entity old : e) {
        world.destroy(old);
    }
    EXPECT_FALSE(extract().changes.replaced);
    world.destroy(more[0]);
    world.destroy(more[1]);
    world.destroy(more[2]);
    spawn(world, room());
    EXPECT_TRUE(extract().changes.replaced);
}

TEST_F(Extract, InstancesBecomeStaticAfterAWhile) {
    load(room());
    for (std::uint32_t i = 0; i < kStaticAfter; ++i) {
        EXPECT_FALSE(extract().instances[0].is_static);
    }
    const FrameScene frame = extract();
    EXPECT_TRUE(frame.instances[0].is_static);
    EXPECT_TRUE(frame.changes.nothing());
    local(0).translation.x += 1;
    FrameScene moved = extract();
    EXPECT_FALSE(moved.instances[0].is_static);
    EXPECT_TRUE(moved.instances[1].is_static);
}

TEST_F(Extract, IsSortedByIdThenMesh) {
    SceneData scene = room();
    scene.meshes.push_back(cube());
    scene.nodes[2].meshes = {1, 0};
    load(std::move(scene));
    world.add(e[0], Extras{});  // to another table
    const FrameScene frame = extract();
    ASSERT_EQ(frame.instances.size(), 3u);
    const auto key = [&](std::size_t i) { return std::pair(frame.instances[i].id, frame.instances[i].mesh); };
    EXPECT_LT(key(0), key(1));
    EXPECT_LT(key(1), key(2));
}

TEST_F(Extract, LooksTheSameFarFromTheOrigin) {
    load(room());
    camera = e[1];
    const FrameScene here = extract();

    ecs::World far_world;
    SceneData scene = room();
    const dvec3 offset(1e6, -2e6, 3e6);
    scene.nodes[0].local.translation += offset;
    scene.nodes[2].local.translation += offset;
    const std::vector<Entity> nodes = spawn(far_world, scene);
    Extractor far_extractor;
    const FrameScene there = far_extractor.extract(far_world, nodes[1]);
    EXPECT_EQ(there.origin, here.origin + offset);
    EXPECT_EQ(there.instances, here.instances);
    EXPECT_EQ(there.lights, here.lights);
    EXPECT_EQ(there.camera, here.camera);
    // A tenth of a millimetre still moves it.
    far_world.get_mut<LocalTransform>(nodes[2]).value.translation.x += 1e-4;
    Transforms().update(far_world);
    const FrameScene moved = far_extractor.extract(far_world, nodes[1]);
    EXPECT_EQ(moved.changes.moved.size(), 1u);
    EXPECT_NEAR(moved.instances[1].transform[3].x - there.instances[1].transform[3].x, 1e-4, 1e-6);
}

TEST_F(Extract, MovesTheOriginWhenTheSceneHasGoneFarAway) {
    load(room());
    extract();
    local(0).translation.x += 1e6;
    local(2).translation.x += 1e6;
    const FrameScene frame = extract();
    EXPECT_EQ(frame.origin, dvec3(1e6 + 15, 0, 0));
    EXPECT_TRUE(frame.changes.geometry && frame.changes.lights);
    EXPECT_EQ(frame.changes.moved.size(), 2u);
    EXPECT_LT(frame.changes.dirty.lower.x, -9e5);  // where it was
}

// fp32 has steps of 6 cm at 600 km.
TEST_F(Extract, TheOriginIsWhereMostThingsAreInAWideWorld) {
    load(room());
    extract();
    const dvec3 alone = extractor.origin();
    load(room());
    local(0).translation.x += 1e7;
    Extractor wide;
    transforms.update(world);
    const double x = wide.extract(world, camera).origin.x;
    EXPECT_NEAR(x, alone.x, 1e3);
}

TEST_F(Extract, TheOriginWaitsForGeometry) {
    const FrameScene empty = extract();
    EXPECT_TRUE(empty.instances.empty());
    EXPECT_TRUE(empty.bounds.empty());
    ASSERT_NE(empty.assets, nullptr);
    EXPECT_EQ(empty.diagonal(), 1);
    EXPECT_EQ(empty.origin, dvec3(0));
    load(room());
    EXPECT_EQ(extract().origin, dvec3(15, 0, 0));
}

TEST_F(Extract, LeavesOutWhatIsNotFiniteAndSaysSo) {
    for (const double bad : {kNan, kInf, 1e300}) {
        ecs::World w;
        const std::vector<Entity> nodes = spawn(w, room());
        w.get_mut<LocalTransform>(nodes[2]).value.translation.y = bad;
        Transforms().update(w);
        Extractor x;
        const FrameScene frame = x.extract(w);
        ASSERT_EQ(frame.instances.size(), 1u) << bad;
        ASSERT_EQ(x.warnings().size(), 1u) << bad;
        EXPECT_NE(x.warnings()[0].find("'ball'"), std::string::npos) << x.warnings()[0];
        EXPECT_TRUE(std::isfinite(frame.bounds.diagonal()));
        EXPECT_TRUE(std::isfinite(glm::length(frame.origin)));
        EXPECT_TRUE(x.extract(w).changes.nothing());
    }
    load(room());
    camera = e[1];
    local(1).translation.x = kNan;
    const FrameScene frame = extract();
    EXPECT_TRUE(frame.lights.empty());
    EXPECT_EQ(frame.camera, frame_all(frame.bounds));
    EXPECT_EQ(extractor.warnings().size(), 2u);
}

TEST_F(Extract, LightsKeepADirectionWithAnyScale) {
    load(room());
    const quat turn = glm::angleAxis(kPi / 2, vec3(0, 1, 0));  // -Z becomes -X
    for (const vec3 scale : {vec3(0), vec3(1, 1, 0), vec3(0, 1, 1), vec3(5), vec3(1e-20f), vec3(1, 0, 0)}) {
        local(1).rotation = 3.0f * turn / 3.0f;
        local(1).scale = scale;
        const FrameScene frame = extract();
        ASSERT_EQ(frame.lights.size(), 1u);
        const vec3 d = frame.lights[0].direction;
        EXPECT_NEAR(glm::distance(d, vec3(-1, 0, 0)), 0, 1e-5) << scale.x << ' ' << scale.y << ' ' << scale.z;
        EXPECT_NEAR(glm::length(d), 1, 1e-6);
    }
    local(0).scale = vec3(0);  // the parent's
    local(1).scale = vec3(1);
    EXPECT_NEAR(glm::distance(extract().lights[0].direction, vec3(-1, 0, 0)), 0, 1e-5);
    local(1).rotation = quat(2, 0, 0, 0);
    EXPECT_NEAR(glm::distance(extract().lights[0].direction, vec3(0, 0, -1)), 0, 1e-5);
}

TEST_F(Extract, TheCameraCanBeTheCallers) {
    load(room());
    transforms.update(world);
    dmat4 there(1);
    there[3] = dvec4(15, 1, 9, 1);
    const FrameScene frame = extractor.extract(world, Camera{}, there);
    EXPECT_EQ(frame.camera.position, vec3(0, 1, 9));
    EXPECT_EQ(extractor.extract(world, frame.camera).camera, frame.camera);
    EXPECT_EQ(extractor.extract(world).camera, frame_all(frame.bounds));
    EXPECT_THROW(extractor.extract(world, e[0]), ecs::Error);
}

TEST_F(Extract, MeshesThatDoNotExistOrShowNothingAreLeftOut) {
    SceneData scene = room();
    scene.meshes.push_back({});
    scene.nodes[0].meshes = {1};
    load(std::move(scene));
    world.get_mut<MeshInstances>(e[2]).meshes = {MeshHandle{7, 2}};  // as nobody should: insert refuses it
    EXPECT_TRUE(extract().instances.empty());
    ASSERT_EQ(extractor.warnings().size(), 1u);
    EXPECT_NE(extractor.warnings()[0].find("mesh 7 of generation 2 has been released or never was"),
              std::string::npos);
}

}  // namespace
}  // namespace lanthorn
