// Assets edited while frames are shown: the picture is that of a fresh start with them, the maps stay, and
// what is uploaded is what changed.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/render/scene_structs.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96, 72);
constexpr std::size_t kVertexBytes = 72;

Image chequered(std::uint8_t light) {
    Image image{"chequered", 2, 2, {}};
    for (const bool on : {true, false, false, true}) {
        const std::uint8_t v = on ? light : 60;
        image.rgba.insert(image.rgba.end(), {v, v, v, 255});
    }
    return image;
}

// A corner of a room with a block and a lamp; each mesh has a material of its own.
SceneData corner() {
    SceneData scene;
    scene.source = "corner";
    const auto add = [&](const char* name, Mesh mesh, const vec3& albedo) {
        mesh.name = name;
        mesh.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(lambertian(albedo));
        scene.materials.back().name = name;
        NodeData& node = scene.nodes.emplace_back();
        node.name = name;
        node.meshes = {static_cast<std::uint32_t>(scene.meshes.size())};
        scene.meshes.push_back(std::move(mesh));
    };
    add("floor", quad(vec3(0), vec3(0, 0, 4), vec3(4, 0, 0), 0), vec3(0.7f));
    add("back", quad(vec3(0), vec3(4, 0, 0), vec3(0, 3, 0), 0), vec3(0.7f));
    add("left", quad(vec3(0), vec3(0, 3, 0), vec3(0, 0, 4), 0), vec3(0.7f, 0.1f, 0.1f));
    add("block", box(vec3(1.2f, 0, 1.2f), vec3(2, 1, 2), false, 0), vec3(0.5f));
    add("lamp", quad(vec3(2.4f, 2.6f, 1.4f), vec3(0.6f, 0, 0), vec3(0, 0, 0.6f), 0), vec3(0));
    scene.materials.back().emissive = vec3(400);
    scene.images.push_back(chequered(200));
    scene.textures.resize(1);
    scene.materials[0].base_colour_texture.texture = 0;
    NodeData& light = scene.nodes.emplace_back();
    light.local.translation = {3, 2, 3};
    light.light = 0;
    scene.lights.resize(1);
    scene.lights[0].intensity = 60;
    return scene;
}

struct Stage {
    ecs::World world;
    std::vector<ecs::Entity> entities = spawn(world, corner());
    AssetStore& store = asset_store(world);
    const SceneAsset& file = store.get(world.get<Source>(entities[0]).scene);
    Extractor extractor;
    CameraView camera;
    Bench bench;

    Stage() {
        FrameScene view;
        support::look(view, vec3(3.7f, 1.5f, 3.6f), vec3(1, 0.8f, 1));
        camera = view.camera;
        camera.position -= vec3(shown_origin());
        camera.view = glm::translate(camera.view, vec3(shown_origin()));
        bench.settings.photons = 20000;
    }
    dvec3 shown_origin() {
        Extractor probe;
        return probe.extract(world).origin;
    }
    FrameScene scene() { return extractor.extract(world, camera); }
    std::vector<float> frame() { return bench.frame(scene(), kSize).pixels; }
    // By a renderer and a technique that have seen nothing before.
    std::vector<float> fresh() {
        Extractor unused;
        Bench other;
        other.settings = bench.settings;
        return other.frame(unused.extract(world, camera), kSize).pixels;
    }
    bool on(const char* pass) { return bench.technique().statistics(false).plan.on(pass); }
    const render::GpuScene::Uploaded& uploaded() { return bench.renderer().gpu_scene().uploaded(); }
    void expect_nothing_uploaded() {
        EXPECT_EQ(uploaded().geometry + uploaded().images + uploaded().materials + uploaded().instances, 0u);
    }
};

// Chose all maps anew and uploaded everything; later drew all maps that saw the material.
TEST(AssetEdits, AColourRelightsAndKeepsTheMaps) {
    Stage stage;
    stage.frame();
    const std::vector<float> before = stage.frame();
    stage.store.edit_material(stage.file.materials[2],
                              [](Material& m) { m.base_colour = vec4(0.1f, 0.1f, 0.8f, 1); });
    const std::vector<float> edited = stage.frame();
    EXPECT_FALSE(stage.on("selection"));
    EXPECT_TRUE(stage.on("emission") && !stage.on("environment_maps"));
    EXPECT_EQ(stage.bench.renderer().light_maps().layers_drawn(), 0);
    EXPECT_NE(edited, before);
    EXPECT_EQ(edited, stage.fresh()) << "bit by bit";
    EXPECT_EQ(stage.uploaded().materials, sizeof(render::MaterialData));
    EXPECT_EQ(stage.uploaded().geometry + stage.uploaded().images + stage.uploaded().instances, 0u);
    stage.frame();
    EXPECT_FALSE(stage.on("emission") || stage.on("environment_maps"));
    stage.expect_nothing_uploaded();
}

// What is not the base colour's factor is in the maps.
TEST(AssetEdits, MetalIsDrawnWhereItIsSeen) {
    Stage stage;
    stage.frame();
    stage.frame();
    stage.store.edit_material(stage.file.materials[2], [](Material& m) { m.metallic = 0.5f; });
    const std::vector<float> edited = stage.frame();
    EXPECT_FALSE(stage.on("selection"));
    EXPECT_TRUE(stage.on("environment_maps") && stage.on("emission"));
    EXPECT_EQ(edited, stage.fresh()) << "bit by bit";
}

// Slots that a half float cannot count: the maps hold the colour itself, and are drawn again.
TEST(AssetEdits, AColourBeyondTheNumberedMaterialsIsDrawn) {
    Stage stage;
    stage.world.clear();
    for (std::uint32_t i = 0; i < kNumberedMaterials; ++i) {
        stage.store.add(Material());
    }
    stage.entities = spawn(stage.world, corner());
    const SceneAsset& file = stage.store.get(stage.world.get<Source>(stage.entities[0]).scene);
    ASSERT_GE(file.materials[2].slot, kNumberedMaterials);
    const std::vector<float> before = stage.frame();
    // But for the halves' rounding, 2^-11 at each of two surfaces.
    const std::vector<float> numbered = Stage().frame();
    ASSERT_EQ(before.size(), numbered.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_NEAR(before[i], numbered[i], 1e-3f * numbered[i]) << i;
    }
    stage.store.edit_material(file.materials[2],
                              [](Material& m) { m.base_colour = vec4(0.1f, 0.1f, 0.8f, 1); });
    const std::vector<float> edited = stage.frame();
    EXPECT_TRUE(stage.on("environment_maps"));
    EXPECT_EQ(edited, stage.fresh()) << "bit by bit";
}

TEST(AssetEdits, ALampThatFlickersRelightsAlone) {
    Stage stage;
    stage.frame();
    for (const float nits : {200.0f, 0.0f, 700.0f}) {
        stage.store.edit_material(stage.file.materials[4], [&](Material& m) { m.emissive = vec3(nits); });
        const std::vector<float> edited = stage.frame();
        EXPECT_FALSE(stage.on("selection") || stage.on("environment_maps")) << nits;
        EXPECT_TRUE(stage.on("emission")) << nits;
        EXPECT_EQ(edited, stage.fresh()) << nits;
    }
}

TEST(AssetEdits, AnImageIsUploadedAlone) {
    Stage stage;
    stage.frame();
    stage.store.edit_image(stage.file.images[0], [](Image& image) { image = chequered(90); });
    const std::vector<float> edited = stage.frame();
    EXPECT_EQ(stage.uploaded().images, 16u);
    EXPECT_EQ(stage.uploaded().geometry, 0u);
    EXPECT_EQ(edited, stage.fresh());
}

// What deforms moves for a while: the picture is that of maps drawn anew, but for the centres that the
// progressive update may choose.
TEST(AssetEdits, AMeshIsUploadedAloneAndRedrawnWhereItIsSeen) {
    Stage stage;
    stage.frame();
    stage.store.edit_mesh(stage.file.meshes[3], [](Mesh& mesh) {
        for (Vertex& v : mesh.vertices) {
            v.position.y *= 1.5f;
        }
    });
    stage.frame();
    const Mesh& block = stage.store.get(stage.file.meshes[3]);
    EXPECT_EQ(stage.uploaded().geometry,
              block.vertices.size() * kVertexBytes + block.indices.size() * sizeof(std::uint32_t));
    EXPECT_FALSE(stage.on("selection"));
    EXPECT_TRUE(stage.on("environment_maps"));
}

TEST(AssetEdits, TheSameSceneAgainUploadsInstancesAlone) {
    Stage stage;
    stage.frame();
    spawn(stage.world, stage.world.get<Source>(stage.entities[0]).scene);
    stage.frame();
    EXPECT_EQ(stage.uploaded().geometry + stage.uploaded().images + stage.uploaded().materials, 0u);
    EXPECT_EQ(stage.uploaded().instances, 10 * sizeof(render::InstanceData)) << "the buffer has grown";
}

// A scene takes over the slots of one that was released, and none of the other's data shows.
TEST(AssetEdits, AnotherSceneInReleasedSlotsIsAsFresh) {
    Stage stage;
    stage.frame();
    const SceneHandle first = stage.world.get<Source>(stage.entities[0]).scene;
    const std::vector<float> before = stage.frame();
    stage.world.clear();
    EXPECT_FALSE(stage.store.alive(first));
    stage.frame();  // nothing is shown
    SceneData other = corner();
    other.images[0] = chequered(90);
    other.materials[1].base_colour = vec4(0.2f, 0.7f, 0.3f, 1);
    std::swap(other.meshes[3], other.meshes[4]);
    for (std::uint32_t i : {3u, 4u}) {
        other.meshes[i].material = i;
        for (Vertex& v : other.meshes[i].vertices) {
            v.position.x += 0.25f;
        }
    }
    stage.entities = spawn(stage.world, other);
    const SceneHandle second = stage.world.get<Source>(stage.entities[0]).scene;
    ASSERT_EQ(second.slot, first.slot);
    EXPECT_NE(second, first);
    const std::vector<float> shown = stage.frame();
    EXPECT_EQ(shown, stage.fresh()) << "bit by bit";
    EXPECT_NE(shown, before);
}

// An entity that shows another mesh, whose slot, material's slot and image's slot are those of the last one.
TEST(AssetEdits, AnotherAssetInTheSameSlotIsSeenAsOther) {
    Stage stage;
    const auto painted = [&](const vec3& colour, std::uint8_t light) {
        const ImageHandle image = stage.store.add(chequered(light));
        Material material = lambertian(colour);
        material.base_colour_texture.texture = stage.store.add(Texture{image.slot, {}}).slot;
        Mesh mesh = quad(vec3(3.9f, 0, 0), vec3(0, 0, 4), vec3(0, 3, 0), 0);
        mesh.material = stage.store.add(material).slot;
        return stage.store.add(std::move(mesh));
    };
    const MeshHandle red = painted(vec3(0.9f, 0.1f, 0.1f), 250);
    const ecs::Entity wall = stage.world.create(WorldTransform{}, MeshInstances{{red}});
    stage.frame();
    const std::vector<float> before = stage.frame();
    stage.world.insert(wall, MeshInstances{});
    EXPECT_FALSE(stage.store.alive(red));
    const MeshHandle green = painted(vec3(0.1f, 0.9f, 0.1f), 120);
    ASSERT_EQ(green.slot, red.slot);
    stage.world.insert(wall, MeshInstances{{green}});
    const std::vector<float> edited = stage.frame();
    EXPECT_EQ(stage.uploaded().materials, sizeof(render::MaterialData));
    EXPECT_EQ(stage.uploaded().images, 16u);
    EXPECT_EQ(stage.uploaded().geometry, 4 * kVertexBytes + 6 * sizeof(std::uint32_t));
    EXPECT_EQ(edited, stage.fresh()) << "bit by bit";
    EXPECT_NE(edited, before);
}

// One that changed its level uploaded all vertices and triangles of the scene.
TEST(AssetEdits, ACageThatIsRefinedFurtherUploadsItself) {
    Stage stage;
    FrameScene scene = stage.scene();
    const auto refined = [&](std::size_t vertices) {
        auto topology = std::make_shared<RefinedTopology>();
        topology->serial = next_asset_version();
        topology->uv0.resize(vertices);
        topology->uv1.resize(vertices);
        topology->colours.resize(vertices, vec4(1));
        topology->indices = {0, 1, 2};
        DeformedMesh mesh;
        mesh.version = next_asset_version();
        mesh.vertices = std::make_shared<const std::vector<VertexFrame>>(vertices);
        mesh.refined = topology;
        return mesh;
    };
    scene.deformed = {refined(12), refined(40)};
    for (const std::uint32_t i : {0u, 1u}) {
        scene.instances[i].deformed = i;
        scene.instances[i].version = scene.deformed[i].version;
    }
    render::GpuScene gpu_scene;
    gpu_scene.update(scene);
    for (const std::size_t vertices : {100u, 30u, 5000u}) {
        ++scene.frame;
        scene.deformed[1] = refined(vertices);
        scene.instances[1].version = scene.deformed[1].version;
        gpu_scene.update(scene);
        EXPECT_EQ(gpu_scene.uploaded().geometry, vertices * kVertexBytes + 3 * sizeof(std::uint32_t));
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
