// What a store shares, counts, releases and refuses, and who sees an edit.
#include "lanthorn/scene/asset_store.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/spawn.h"
#include "tests/unit/scene/scenes.h"

namespace lanthorn {
namespace asset_store_test {

using namespace scene_test;

template <class Do>
std::string error_of(const Do& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

Image image(std::uint8_t grey) {
    return {"grey", 1, 1, {grey, grey, grey, 255}};
}

// A mesh whose material shows an image.
struct Painted {
    AssetStore store;
    ImageHandle image = store.add(asset_store_test::image(128));
    TextureHandle texture = store.add(Texture{image.slot, {}});
    MaterialHandle material;
    MeshHandle mesh;

    Painted() {
        Material m;
        m.name = "paint";
        m.base_colour_texture.texture = texture.slot;
        material = store.add(m);
        Mesh box = cube();
        box.material = material.slot;
        mesh = store.add(box);
    }
    const AssetVersion<Material>& version() const { return store.assets().materials.version(material.slot); }
};

TEST(AssetStore, AnEditIsUndoneAndDoneAgain) {
    Painted p;
    p.store.retain(p.mesh);
    const AssetVersion<Material> first = p.version();
    const Material* const painted = &p.store.get(p.material);
    const AssetBefore<Material> before = p.store.edit_material(p.material, [](Material& m) {
        m.roughness = 0.25f;
        m.base_colour_texture = {};
    });
    EXPECT_EQ(before.version, first);
    EXPECT_EQ(before.value.get(), painted) << "no copy";
    EXPECT_TRUE(p.store.alive(p.texture)) << "what was edited away is held";
    const AssetVersion<Material> edited = p.version();
    const AssetBefore<Material> after = p.store.restore(before);
    EXPECT_EQ(&p.store.get(p.material), painted);
    EXPECT_EQ(p.store.get(p.material).base_colour_texture.texture, p.texture.slot);
    EXPECT_GT(p.version().any, edited.any) << "what shows it sees a change";
    EXPECT_EQ(p.version().emission, first.emission) << "in what differs alone";
    EXPECT_EQ(after.value->roughness, 0.25f);
    p.store.restore(after);
    EXPECT_FALSE(p.store.get(p.material).base_colour_texture.present());

    const AssetBefore<Image> pixels = p.store.edit_image(p.image, [](Image& i) { i = image(7); });
    const AssetBefore<Mesh> shape = p.store.edit_mesh(p.mesh, [](Mesh& m) { m.vertices[0].position.x -= 1; });
    p.store.restore(pixels);
    p.store.restore(shape);
    EXPECT_EQ(p.store.get(p.image).rgba[0], 128);
    EXPECT_EQ(p.store.get(p.mesh).bounds.lower, shape.value->bounds.lower);
    p.store.release(p.mesh);
    EXPECT_NE(error_of([&] { p.store.restore(shape); }).find("has been released"), std::string::npos);
}

TEST(AssetStore, ABeforeImageLetsGoOfWhatItHeld) {
    Painted p;
    p.store.retain(p.mesh);
    {
        const AssetBefore<Material> before =
            p.store.edit_material(p.material, [](Material& m) { m.base_colour_texture = {}; });
        EXPECT_EQ(p.store.references(p.texture), 1u);
    }
    EXPECT_FALSE(p.store.alive(p.texture));
    EXPECT_FALSE(p.store.alive(p.image));
}

TEST(AssetStore, CountsWhoRefersToWhatAndReleasesTheLot) {
    Painted p;
    EXPECT_EQ(p.store.references(p.image), 1u);
    EXPECT_EQ(p.store.references(p.texture), 1u);
    EXPECT_EQ(p.store.references(p.material), 1u);
    EXPECT_EQ(p.store.references(p.mesh), 0u);
    p.store.retain(p.mesh);
    p.store.retain(p.mesh);
    p.store.release(p.mesh);
    EXPECT_TRUE(p.store.alive(p.mesh));
    const auto before = p.store.snapshot();
    p.store.release(p.mesh);
    EXPECT_FALSE(p.store.alive(p.mesh) || p.store.alive(p.material) || p.store.alive(p.texture) ||
                 p.store.alive(p.image));
    EXPECT_EQ((*before).meshes[p.mesh.slot].name, "cube") << "a frame under way keeps what it shows";
    EXPECT_FALSE(p.store.snapshot()->meshes.has(p.mesh.slot));
}

TEST(AssetStore, AReleasedAssetsSlotServesAgainUnderAnotherHandle) {
    Painted p;
    p.store.discard();
    const MaterialHandle next = p.store.add(Material());
    EXPECT_EQ(next.slot, p.material.slot);
    EXPECT_NE(next, p.material);
    EXPECT_EQ(
        error_of([&] { p.store.get(p.material); }),
        "material 0 of generation 0 is not in the store: it has been released, and generation 1 took the "
        "slot; expected the handle of an asset that somebody refers to");
    EXPECT_EQ(error_of([&] { p.store.edit_mesh(p.mesh, [](Mesh&) {}); }),
              "mesh 0 of generation 0 is not in the store: it has been released; expected the handle of an "
              "asset that somebody refers to");
    EXPECT_EQ(
        error_of([&] {
            p.store.retain(MeshHandle{9, 0});
        }),
        "mesh 9 of generation 0 is not in the store: no such slot; expected the handle of an asset that "
        "somebody refers to");
    EXPECT_EQ(error_of([&] { p.store.get(ImageHandle{}); }),
              "a null handle to a image: expected the handle of an asset that somebody refers to");
}

TEST(AssetStore, AnEditSaysWhatOfAMaterialDiffers) {
    Painted p;
    const auto before = p.store.snapshot();
    const AssetVersion<Material> first = p.version();
    p.store.edit_material(p.material, [](Material& m) { m.base_colour.r = 0.5f; });
    EXPECT_EQ(before->materials[p.material.slot].base_colour.r, 1) << "nobody sees it change";
    EXPECT_EQ(p.store.get(p.material).base_colour.r, 0.5f);
    EXPECT_EQ(p.store.snapshot()->meshes.shared(p.mesh.slot), before->meshes.shared(p.mesh.slot));
    const AssetVersion<Material> painted = p.version();
    EXPECT_TRUE(painted.any > first.any && painted.albedo > first.albedo);
    EXPECT_TRUE(painted.surface == first.surface && painted.emission == first.emission);
    EXPECT_TRUE(painted.pattern == first.pattern && painted.kept(0) == first.kept(0));
    EXPECT_NE(painted.kept(kNumberedMaterials), first.kept(kNumberedMaterials));
    p.store.edit_material(p.material, [](Material& m) { m.emissive = vec3(3); });
    EXPECT_TRUE(p.version().emission > painted.emission && p.version().albedo == painted.albedo);
    p.store.edit_material(p.material, [](Material& m) { m.roughness = 0.25f; });
    const AssetVersion<Material> rough = p.version();
    EXPECT_TRUE(rough.albedo > painted.albedo && rough.pattern > painted.pattern)
        << "a wider lobe reflects less";
    EXPECT_EQ(rough.surface, first.surface);
    p.store.edit_material(p.material, [](Material& m) { m.occlusion_strength = 0.5f; });
    EXPECT_TRUE(p.version().any > rough.any && p.version().albedo == rough.albedo);
    p.store.edit_material(p.material, [](Material& m) { m.alpha_mode = AlphaMode::mask; });
    EXPECT_TRUE(p.version().surface > rough.surface && p.version().albedo == rough.albedo);
    // Now what its texture shows leaves holes too.
    const AssetVersion<Material> masked = p.version();
    p.store.edit_image(p.image, [](Image& i) { i.rgba[3] = 0; });
    EXPECT_TRUE(p.version().surface > masked.surface && p.version().albedo > masked.albedo);
    EXPECT_TRUE(p.version().emission == masked.emission && p.version().pattern > masked.pattern);
    const AssetVersion<Material> holed = p.version();
    p.store.edit_material(p.material, [](Material& m) { m.metallic = 0.5f; });
    EXPECT_TRUE(p.version().pattern > holed.pattern && p.version().albedo > holed.albedo);
}

TEST(AssetStore, AnEditTakesReferencesAlong) {
    Painted p;
    p.store.edit_material(p.material, [](Material& m) { m.base_colour_texture = {}; });
    EXPECT_FALSE(p.store.alive(p.texture) || p.store.alive(p.image));
    const MaterialHandle other = p.store.add(Material());
    p.store.edit_mesh(p.mesh, [&](Mesh& m) {
        m.material = other.slot;
        m.vertices[0].position = vec3(-9, 0, 0);
    });
    EXPECT_FALSE(p.store.alive(p.material));
    EXPECT_EQ(p.store.material_of(p.mesh), other);
    EXPECT_EQ(p.store.get(p.mesh).bounds.lower.x, -9);
}

TEST(AssetStore, RefusesWhatCannotBeDrawn) {
    Painted p;
    const std::uint64_t serial = p.store.assets().serial;
    EXPECT_EQ(error_of([&] { p.store.edit_material(p.material, [](Material& m) { m.emissive.x = -1; }); }),
              "material 0 'paint': a colour is negative, expected 0 or more");
    EXPECT_EQ(error_of([&] {
                  p.store.edit_material(p.material, [](Material& m) { m.normal_texture.texture = 4; });
              }),
              "material 0 'paint': texture 4 is not in the store, expected a slot of its textures");
    EXPECT_EQ(error_of([&] { p.store.edit_mesh(p.mesh, [](Mesh& m) { m.indices[0] = 8; }); }),
              "mesh 0 'cube': index 8, expected less than its 8 vertices");
    EXPECT_EQ(error_of([&] { p.store.edit_mesh(p.mesh, [](Mesh& m) { m.material = 3; }); }),
              "mesh 0 'cube': material 3 is not in the store, expected a slot of its materials");
    EXPECT_EQ(error_of([&] { p.store.edit_image(p.image, [](Image& i) { i.width = 7; }); }),
              "image 0 'grey': 4 bytes of pixels, expected 28 for 7 x 1");
    EXPECT_EQ(p.store.assets().serial, serial) << "nothing has changed";
}

TEST(AssetStore, TheSameFileIsThereOnceWithItsEdits) {
    SceneData file = room();
    file.source = "room.glb";
    AssetStore store;
    const SceneHandle scene = store.add(file);
    EXPECT_EQ(store.find_scene("room.glb"), scene);
    EXPECT_FALSE(store.find_scene("hall.glb"));
    const MaterialHandle material = store.get(scene).materials[0];
    store.edit_material(material, [](Material& m) { m.base_colour = vec4(0.25f); });
    EXPECT_EQ(store.add(file), scene) << "as it was loaded, whatever was edited since";
    file.nodes[1].local.translation.x = 3;
    const SceneHandle changed = store.add(file);
    EXPECT_NE(changed, scene) << "another content is another scene";
    EXPECT_EQ(store.find_scene("room.glb"), changed);
}

}  // namespace asset_store_test
}  // namespace lanthorn
