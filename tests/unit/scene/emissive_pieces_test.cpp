#include "engine/scene/emissive_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lanthorn {
namespace {

struct Board {
    SceneAssets assets;
    Mesh mesh;
    Material material;
};

// A quad of 1 m whose texture of `side` texels glows where `lit` says so.
template <class Lit>
Board board(std::uint32_t side, const Lit& lit) {
    Board b;
    for (const vec2 corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
        Vertex vertex;
        vertex.position = vec3(corner, 0);
        vertex.uv0 = corner;
        b.mesh.vertices.push_back(vertex);
    }
    b.mesh.indices = {0, 1, 2, 0, 2, 3};
    Image image;
    image.width = image.height = side;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint8_t value = lit(i % side, i / side) ? 255 : 0;
        image.rgba.insert(image.rgba.end(), {value, value, value, 255});
    }
    b.assets.images.push_back(image);
    Texture texture;
    texture.sampler.mag = Filter::nearest;
    b.assets.textures.push_back(texture);
    b.material.emissive = vec3(1);
    b.material.emissive_texture.texture = 0;
    return b;
}

double area_of(const EmissivePiece& piece) {  // of the triangle's
    const vec3 u = piece.corners[1] - piece.corners[0], v = piece.corners[2] - piece.corners[0];
    return std::abs(static_cast<double>(u.y) * static_cast<double>(v.z) -
                    static_cast<double>(u.z) * static_cast<double>(v.y));
}

double light_of(const EmissivePieces& pieces) {  // of the board's, were it all lit
    double sum = 0;
    for (std::size_t t = 0; t < 2; ++t) {
        for (const EmissivePiece& piece : pieces.of(t)) {
            sum += 0.5 * area_of(piece) * static_cast<double>(piece.share.x);
        }
    }
    return sum;
}

TEST(EmissivePieces, ABoardThatGlowsEvenlyStaysWhole) {
    const Board b = board(16, [](auto, auto) { return true; });
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    for (std::size_t t = 0; t < 2; ++t) {
        ASSERT_EQ(pieces.of(t).size(), 1U);
        EXPECT_EQ(pieces.of(t)[0].share, vec3(1));
    }
}

TEST(EmissivePieces, LightLeavesFromThePatch) {
    const Board b = board(64, [](auto x, auto y) { return x >= 48 && x < 52 && y >= 8 && y < 12; });
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    EXPECT_NEAR(light_of(pieces) / (1.0 / 256), 1, 0.02);
    for (std::size_t t = 0; t < 2; ++t) {
        for (const EmissivePiece& piece : pieces.of(t)) {
            if (piece.share.x > 0) {
                const vec3 middle = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3.0f;
                const std::size_t first = 3 * t;
                vec3 at(0);
                for (std::size_t k = 0; k < 3; ++k) {
                    at += middle[static_cast<int>(k)] * b.mesh.vertices[b.mesh.indices[first + k]].position;
                }
                EXPECT_LT(glm::distance(at, vec3(50.0f / 64, 10.0f / 64, 0)), 4.0f / 64);
            }
        }
    }
}

// Noise is cut to the last piece, and no further.
TEST(EmissivePieces, NoiseKeepsItsLightAndIsBounded) {
    const Board b = board(512, [](auto x, auto y) { return ((x * 2654435761U) ^ (y * 40503U)) >> 7 & 1; });
    double lit = 0;
    for (std::size_t i = 0; i < b.assets.images[0].rgba.size(); i += 4) {
        lit += b.assets.images[0].rgba[i] / 255.0;
    }
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    EXPECT_LE(pieces.of(0).size() + pieces.of(1).size(), 16384U);
    EXPECT_NEAR(light_of(pieces) / (lit / (512.0 * 512)), 1, 0.02);
}

TEST(EmissivePieces, EachPointHasItsPiece) {
    const Board b = board(32, [](auto x, auto y) { return (x / 4 + y / 4) % 2 == 0; });
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    for (std::size_t t = 0; t < 2; ++t) {
        const auto of = pieces.of(t);
        ASSERT_GT(of.size(), 16U);
        double whole = 0;
        for (std::size_t n = 0; n < of.size(); ++n) {
            whole += area_of(of[n]);
            const auto& c = of[n].corners;
            EXPECT_EQ(pieces.piece_at(t, (c[0] + c[1] + c[2]) / 3.0f), n);
            EXPECT_EQ(pieces.piece_at(t, 0.98f * c[0] + 0.01f * c[1] + 0.01f * c[2]), n);
        }
        EXPECT_NEAR(whole, 1, 1e-5);
    }
}

// Gives the board's material that alpha mode, and its base colour a texture that is solid where `solid` says
// so.
template <class Solid>
void cover(Board& b, AlphaMode mode, std::uint32_t side, const Solid& solid) {
    Image image;
    image.width = image.height = side;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const std::uint8_t value = solid(i % side, i / side) ? 255 : 0;
        image.rgba.insert(image.rgba.end(), {90, 90, 90, value});
    }
    Texture texture;
    texture.image = static_cast<std::uint32_t>(b.assets.images.size());
    texture.sampler.mag = Filter::nearest;
    b.material.base_colour_texture.texture = static_cast<std::uint32_t>(b.assets.textures.size());
    b.assets.images.push_back(image);
    b.assets.textures.push_back(texture);
    b.material.alpha_mode = mode;
}

TEST(EmissivePieces, LightLeavesFromWhatIsCovered) {
    for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
        Board b = board(2, [](auto x, auto) { return x == 0; });
        cover(b, mode, 64, [](auto x, auto y) { return x >= 30 && x < 34 && y >= 8 && y < 12; });
        const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
        EXPECT_NEAR(light_of(pieces) / (0.5 / 256), 1, 0.02);
    }
    Board opaque = board(1, [](auto, auto) { return true; });
    cover(opaque, AlphaMode::opaque, 64, [](auto, auto) { return false; });
    EXPECT_NEAR(light_of(emissive_pieces(opaque.assets, opaque.mesh, opaque.material)), 1, 1e-6);
}

// Along a fade of vertex colours; of a masked board what is above its cutoff.
TEST(EmissivePieces, ColoursOfVerticesCoverToo) {
    Board b = board(1, [](auto, auto) { return true; });
    b.material.emissive_texture = {};
    for (Vertex& vertex : b.mesh.vertices) {
        vertex.colour.a = vertex.position.x;
    }
    b.material.alpha_mode = AlphaMode::blend;
    const EmissivePieces fade = emissive_pieces(b.assets, b.mesh, b.material);
    EXPECT_NEAR(light_of(fade), 0.5, 1e-3);
    EXPECT_GT(fade.of(0).size(), 8U);
    EXPECT_LE(fade.of(0).size(), 256U);
    b.material.alpha_mode = AlphaMode::mask;
    b.material.alpha_cutoff = 0.75f;
    EXPECT_NEAR(light_of(emissive_pieces(b.assets, b.mesh, b.material)), 0.25, 0.02);
    b.material.base_colour.a = 0.5f;
    EXPECT_EQ(light_of(emissive_pieces(b.assets, b.mesh, b.material)), 0);
}

// What covers evenly, however little, stays whole; its factor is emitted()'s.
TEST(EmissivePieces, AnEvenCoverStaysWhole) {
    Board b = board(16, [](auto, auto) { return true; });
    cover(b, AlphaMode::blend, 16, [](auto, auto) { return true; });
    b.material.base_colour.a = 0.25f;
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    ASSERT_EQ(pieces.of(0).size(), 1U);
    EXPECT_EQ(pieces.of(0)[0].share, vec3(1));
    EXPECT_EQ(emitted(b.material), vec3(0.25f));
    EXPECT_TRUE(gives_light(b.material));
    b.material.base_colour.a = 0;
    EXPECT_FALSE(gives_light(b.material));
}

TEST(EmissivePieces, AlphaOfNoiseKeepsItsLightAndIsBounded) {
    Board b = board(1, [](auto, auto) { return true; });
    cover(b, AlphaMode::blend, 512,
          [](auto x, auto y) { return ((x * 2654435761U) ^ (y * 40503U)) >> 7 & 1; });
    double solid = 0;
    for (std::size_t i = 3; i < b.assets.images[1].rgba.size(); i += 4) {
        solid += b.assets.images[1].rgba[i] / 255.0;
    }
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    EXPECT_LE(pieces.of(0).size() + pieces.of(1).size(), 16384U);
    EXPECT_NEAR(light_of(pieces) / (solid / (512.0 * 512)), 1, 0.02);
}

// A fade over the board's left half, which alone glows: the mean of the product, not that of each of them.
TEST(EmissivePieces, TheMeanIsOfEmissionTimesAlphaOverTheArea) {
    Board b = board(2, [](auto x, auto) { return x == 0; });
    b.material.alpha_mode = AlphaMode::blend;
    for (Vertex& vertex : b.mesh.vertices) {
        vertex.colour.a = vertex.position.x;
    }
    const EmissivePieces pieces = emissive_pieces(b.assets, b.mesh, b.material);
    EXPECT_NEAR(mean_share(b.mesh, mat4(1), pieces).x, 1.0 / 8, 2e-3);
    EXPECT_NEAR(mean_share(b.mesh, glm::scale(mat4(1), vec3(2, 0.1f, 3)), pieces).x, 1.0 / 8, 2e-3);
    // The second triangle, above the diagonal, with three times its area. What glows below it has 1/24, the
    // integral of x^2 from 0 to 1/2.
    b.mesh.vertices[3].position.z = 2;
    const double below = 2.0 / 24, above = 2 * (1.0 / 8 - 1.0 / 24);  // means
    EXPECT_NEAR(mean_share(b.mesh, mat4(1), pieces).x, (below + 3 * above) / 4, 2e-3);
    EXPECT_EQ(mean_share(Mesh(), mat4(1), emissive_pieces(b.assets, Mesh(), b.material)), vec3(0));
}

// Coordinates that are no number, and a texture without texels.
TEST(EmissivePieces, BadInputHasAPieceATriangle) {
    Board b = board(4, [](auto, auto) { return true; });
    b.mesh.vertices[2].uv0 = vec2(std::nanf(""), 0);
    EXPECT_EQ(emissive_pieces(b.assets, b.mesh, b.material).of(0).size(), 1U);
    b.assets.images.edit(0, [](Image& image) { image = Image(); });
    EXPECT_GE(emissive_pieces(b.assets, b.mesh, b.material).of(1).size(), 1U);
}

}  // namespace
}  // namespace lanthorn
