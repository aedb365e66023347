#include "engine/scene/kept_emissive_pieces.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace lanthorn {
namespace {

Image checks(std::uint32_t side) {
    Image image;
    image.width = image.height = side;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint8_t value = (i % side + i / side) % 2 == 0 ? 255 : 0;
        image.rgba.insert(image.rgba.end(), {value, value, value, value});
    }
    return image;
}

Mesh board(std::uint32_t material) {
    Mesh mesh;
    for (const vec2 corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
        Vertex vertex;
        vertex.position = vec3(corner, 0);
        vertex.uv0 = corner;
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = material;
    return mesh;
}

enum Slot : std::uint32_t { kGlows, kCovers, kOther };

// Two boards: one glows by a texture, one by another as far as a third covers it. And an image, a texture and
// a material that neither shows.
SceneAssets boards(AlphaMode mode) {
    SceneAssets assets;
    for (std::uint32_t i = 0; i < 4; ++i) {
        assets.images.push_back(checks(4 << i));
        Texture texture;
        texture.image = i;
        assets.textures.push_back(texture);
    }
    Material glows, covers;
    glows.emissive = covers.emissive = vec3(10);
    glows.emissive_texture.texture = 0;
    covers.emissive_texture.texture = 1;
    covers.base_colour_texture.texture = 2;
    covers.alpha_mode = mode;
    assets.materials.push_back(glows);
    assets.materials.push_back(covers);
    assets.materials.emplace_back();
    for (const std::uint32_t material : {kGlows, kCovers, kOther}) {
        assets.meshes.push_back(board(material));
    }
    return assets;
}

struct Edit {
    std::string what;
    std::function<void(SceneAssets&)> edit;
    bool glows, covers;  // whose board it cuts again
};

void expect_cuts(AlphaMode mode, const std::vector<Edit>& edits) {
    for (const Edit& e : edits) {
        SceneAssets assets = boards(mode);
        KeptEmissivePieces kept;
        const auto glows = kept.of(assets, kGlows), covers = kept.of(assets, kCovers);
        ASSERT_TRUE(glows && covers);
        e.edit(assets);
        assets.serial = next_asset_version();
        EXPECT_EQ(kept.of(assets, kGlows) != glows, e.glows) << e.what;
        EXPECT_EQ(kept.of(assets, kCovers) != covers, e.covers) << e.what;
    }
}

template <class Alter>
std::function<void(SceneAssets&)> material(std::uint32_t slot, const Alter& alter) {
    return [=](SceneAssets& assets) { assets.materials.edit(slot, alter); };
}

TEST(KeptEmissivePieces, AreCutAgainByWhatTheyHangOnAlone) {
    const auto texel = [](std::size_t image) {
        return [=](SceneAssets& assets) { assets.images.edit(image, [](Image& i) { i.rgba[0] ^= 0xff; }); };
    };
    const auto sampler = [](std::size_t texture) {
        return [=](SceneAssets& assets) {
            assets.textures.edit(texture, [](Texture& t) { t.sampler.mag = Filter::nearest; });
        };
    };
    expect_cuts(
        AlphaMode::blend,
        {
            {"nothing", [](SceneAssets&) {}, false, false},
            {"another material", material(kOther, [](Material& m) { m.emissive = vec3(1); }), false, false},
            {"another image", texel(3), false, false},
            {"another texture", sampler(3), false, false},
            {"another mesh",
             [](SceneAssets& a) { a.meshes.edit(kOther, [](Mesh& m) { m.vertices[0].uv0 = vec2(2); }); },
             false, false},
            {"more of everything",
             [](SceneAssets& a) {
                 a.images.push_back(checks(2));
                 a.textures.emplace_back();
                 a.materials.emplace_back();
                 a.meshes.push_back(board(3));
             },
             false, false},
            {"how bright it is", material(kGlows, [](Material& m) { m.emissive = vec3(1, 2, 3); }), false,
             false},
            {"roughness", material(kCovers, [](Material& m) { m.roughness = 0.5f; }), false, false},
            // It is a factor of all pieces: emitted().
            {"a blended one's alpha", material(kCovers, [](Material& m) { m.base_colour.a = 0.5f; }), false,
             false},
            {"its cutoff", material(kCovers, [](Material& m) { m.alpha_cutoff = 0.1f; }), false, false},
            {"a texel", texel(0), true, false},
            {"a texel of the other's", texel(1), false, true},
            {"a texel that covers", texel(2), false, true},
            {"a sampler", sampler(0), true, false},
            {"a sampler of what covers", sampler(2), false, true},
            {"another texture is shown",
             material(kGlows, [](Material& m) { m.emissive_texture.texture = 3; }), true, false},
            {"the texture is turned",
             material(kGlows, [](Material& m) { m.emissive_texture.uv_transform[0] = vec3(2, 0, 0); }), true,
             false},
            {"another texture covers", material(kCovers, [](Material& m) { m.base_colour_texture = {}; }),
             false, true},
            {"how alpha counts", material(kCovers, [](Material& m) { m.alpha_mode = AlphaMode::mask; }),
             false, true},
            {"a mesh's coordinates",
             [](SceneAssets& a) {
                 a.meshes.edit(kGlows, [](Mesh& m) { m.vertices[0].uv0 = vec2(0.5f, 0); });
             },
             true, false},
            {"a vertex' alpha",
             [](SceneAssets& a) { a.meshes.edit(kCovers, [](Mesh& m) { m.vertices[0].colour.a = 0; }); },
             false, true},
            {"another material of a mesh",
             [](SceneAssets& a) { a.meshes.edit(kGlows, [](Mesh& m) { m.material = kCovers; }); }, true,
             false},
        });
    expect_cuts(AlphaMode::mask,
                {{"a masked one's alpha", material(kCovers, [](Material& m) { m.base_colour.a = 0.3f; }),
                  false, true},
                 {"its cutoff", material(kCovers, [](Material& m) { m.alpha_cutoff = 0.1f; }), false, true}});
    expect_cuts(AlphaMode::opaque,
                {{"an opaque one's alpha", material(kCovers, [](Material& m) { m.base_colour.a = 0.3f; }),
                  false, false},
                 {"its base colour", texel(2), false, false}});
}

// A table of another world in which slots have the same numbers.
TEST(KeptEmissivePieces, AreOfTheAssetsAtHand) {
    const SceneAssets first = boards(AlphaMode::blend), second = boards(AlphaMode::blend);
    KeptEmissivePieces kept;
    const auto of_first = kept.of(first, kGlows);
    EXPECT_NE(kept.of(second, kGlows), of_first);
    const SceneAssets copy = second;
    EXPECT_EQ(kept.of(copy, kGlows), kept.of(second, kGlows));
}

TEST(KeptEmissivePieces, AreNoneOfWhatGlowsEvenlyOrNotAtAll) {
    SceneAssets assets = boards(AlphaMode::blend);
    KeptEmissivePieces kept;
    EXPECT_EQ(kept.of(assets, kOther), nullptr);
    const std::weak_ptr<const EmissivePieces> glowed = kept.of(assets, kGlows);
    EXPECT_FALSE(glowed.expired());
    assets.materials.edit(kGlows, [](Material& m) { m.emissive = vec3(0); });
    EXPECT_EQ(kept.of(assets, kGlows), nullptr);
    EXPECT_TRUE(glowed.expired()) << "what nobody needs is not kept";
    assets.materials.edit(kGlows, [](Material& m) {
        m.emissive = vec3(1);
        m.emissive_texture = {};
    });
    EXPECT_EQ(kept.of(assets, kGlows), nullptr);
}

}  // namespace
}  // namespace lanthorn
