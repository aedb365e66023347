// The G-buffer and the lights' maps against geometry known on paper; materials as they arrive in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace gbuffer_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(96, 64);

vec3 octahedral_decode(vec2 e) {
    vec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
    const float fold = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -fold : fold;
    n.y += n.y >= 0 ? -fold : fold;
    return glm::normalize(n);
}

class GBufferScale : public ::testing::TestWithParam<float> {};

TEST_P(GBufferScale, DistanceAndNormalOfATiltedPlane) {
    const float s = GetParam();
    for (const bool orthographic : {false, true}) {
        SceneBuilder b;
        const vec3 normal = glm::normalize(vec3(0.3f, 0.4f, 1));
        const vec3 u = glm::normalize(glm::cross(vec3(0, 1, 0), normal));
        const vec3 v = glm::cross(normal, u);
        const vec3 centre = s * vec3(0.1f, -0.2f, -2);
        b.add_quad(b.add_lambert(vec3(0.5f)), centre, 5 * s * u, 5 * s * v);
        const vec3 eye = s * vec3(0.2f, 0.1f, 1);
        if (orthographic) {
            b.look_orthographic(eye, eye + s * vec3(0, 0, -1), 1.5f * s, s);
        } else {
            b.look(eye, eye + s * vec3(0, 0, -1), 0.9f);
        }
        testing::context();
        render::FrameRenderer renderer;
        testing::render_once(renderer, b.build(), kSize);
        const auto depth = renderer.read(render::Aov::depth);
        const auto shading = renderer.read(render::Aov::normal);
        const std::vector<float> normals = renderer.gbuffer().normals().read_floats(4);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const vec2 p((static_cast<float>(x) + 0.5f) / 96 * 2 - 1,
                             1 - (static_cast<float>(y) + 0.5f) / 64 * 2);
                const float half = orthographic ? s : std::tan(0.45f);
                const vec2 offset = p * vec2(half * 1.5f, half);
                const vec3 origin = orthographic ? eye + vec3(offset, 0) : eye;
                const vec3 direction = orthographic ? vec3(0, 0, -1) : glm::normalize(vec3(offset, -1));
                const float want = glm::dot(centre - origin, normal) / glm::dot(direction, normal);
                const std::size_t i = static_cast<std::size_t>(y * kSize.x + x);
                ASSERT_NEAR(depth.pixels[i] / want, 1, 2e-5) << x << " " << y;
                const vec3 n(shading.pixels[3 * i], shading.pixels[3 * i + 1], shading.pixels[3 * i + 2]);
                ASSERT_GT(glm::dot(n, normal), 0.999999f);
                const std::size_t k = static_cast<std::size_t>((kSize.y - 1 - y) * kSize.x + x) * 4;
                const vec3 g = octahedral_decode(vec2(normals[k + 2], normals[k + 3]));
                ASSERT_GT(glm::dot(g, normal), 0.99999f);
            }
        }
    }
}

// A point light in a box: each texel's stored distance is the distance to the wall its ray meets.
TEST_P(GBufferScale, LightMapsHoldRadialDistancesAndInwardNormals) {
    const float s = GetParam();
    SceneBuilder b;
    b.add_box(b.add_lambert(vec3(0.25f, 0.5f, 0.75f)), vec3(0), s * vec3(1), 0);
    const vec3 light = s * vec3(0.2f, -0.3f, 0.1f);
    b.add_point(light, 1);
    b.look(s * vec3(0, 0, 0.9f), vec3(0), 1);
    testing::context();
    render::FrameRenderer renderer;
    renderer.settings.shadow_resolution = 32;
    const FrameScene scene = b.build();
    testing::render_once(renderer, scene, kSize);
    const std::vector<float> distance = renderer.light_maps().distance().read_floats(1);
    const std::vector<float> normals = renderer.light_maps().normals().read_floats(2);
    const std::vector<float> albedo = renderer.light_maps().albedo().read_floats(4);
    ASSERT_EQ(distance.size(), 6u * 32 * 32);
    for (std::size_t i = 0; i < distance.size(); ++i) {
        const std::size_t face = i / 1024;
        const float a = (static_cast<float>(i % 32) + 0.5f) / 16 - 1;
        const float c = (static_cast<float>(i / 32 % 32) + 0.5f) / 16 - 1;
        const vec3 directions[6] = {{1, c, a}, {-1, c, -a}, {a, 1, c}, {-a, -1, c}, {-a, c, 1}, {a, c, -1}};
        const vec3 d = glm::normalize(directions[face]);
        float nearest = INFINITY;
        float second = INFINITY;
        vec3 inward(0);
        for (int axis = 0; axis < 3; ++axis) {
            const float wall = d[axis] > 0 ? s : -s;
            const float t = (wall - light[axis]) / d[axis];
            second = std::min(second, std::max(t, nearest));
            if (t < nearest) {
                nearest = t;
                inward = vec3(0);
                inward[axis] = d[axis] > 0 ? -1.0f : 1.0f;
            }
        }
        ASSERT_NEAR(distance[i] / nearest, 1, 1e-4) << i;
        if (second > nearest * 1.0001f) {  // else the ray ends in the edge of two walls
            ASSERT_GT(glm::dot(octahedral_decode(vec2(normals[2 * i], normals[2 * i + 1])), inward), 0.999f)
                << i;
        }
        // As kept_albedo.glsl reads it: what is stored times the colour of the material of that number.
        ASSERT_EQ(albedo[4 * i + 3], 1) << i;
        const vec3 colour(scene.assets->materials[0].base_colour);
        ASSERT_NEAR(albedo[4 * i] * colour.r, 0.25f, 0.005f);
        ASSERT_NEAR(albedo[4 * i + 2] * colour.b, 0.75f, 0.005f);
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, GBufferScale, ::testing::Values(1e-3f, 1.0f, 1e3f));

Image checker(std::uint8_t alpha_of_dark) {
    Image image{"checker", 8, 8, {}};
    for (int i = 0; i < 64; ++i) {
        const bool light = i % 8 < 4;  // left half opaque
        for (const int v : {255, 255, 255}) {
            image.rgba.push_back(static_cast<std::uint8_t>(light ? v : 0));
        }
        image.rgba.push_back(light ? std::uint8_t{255} : alpha_of_dark);
    }
    return image;
}

TEST(Materials, AMaskedTextureCutsHolesThatSightAndLightPass) {
    testing::context();
    SceneBuilder b;
    const auto white = b.add_lambert(vec3(1));
    Material masked;
    masked.metallic = 0;
    masked.alpha_mode = AlphaMode::mask;
    masked.double_sided = true;
    masked.base_colour_texture.texture = b.add_image(
        checker(0), {Wrap::clamp_to_edge, Wrap::clamp_to_edge, Filter::nearest, Filter::nearest, false});
    b.add_quad(white, vec3(0), vec3(2, 0, 0), vec3(0, 2, 0));
    b.add_quad(b.add_material(masked), vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0));
    b.add_directional(vec3(0.001f, 0, -1), 100);
    b.look_orthographic(vec3(0, 0, 3), vec3(0), 1.5f, 1.5f);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), {90, 90});
    const auto depth = renderer.read(render::Aov::depth);
    const auto direct = renderer.read(render::Aov::direct);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * 90 + x); };
    EXPECT_NEAR(depth.pixels[at(30, 45)], 2, 1e-4);  // the mask's opaque left half
    EXPECT_NEAR(depth.pixels[at(60, 45)], 3, 1e-4);  // through its right half
    EXPECT_GT(direct.pixels[3 * at(60, 45)], 30);    // lit through the hole

    // From between the two: the shadow of its left half alone.
    b.look(vec3(0, 0, 0.5f), vec3(0), 2.2f);
    render::FrameRenderer behind;
    testing::render_once(behind, b.build(), {90, 90});
    const auto shadowed = behind.read(render::Aov::direct);
    EXPECT_LT(shadowed.pixels[3 * at(25, 45)], 0.01f);
    EXPECT_GT(shadowed.pixels[3 * at(65, 45)], 30);
}

TEST(Materials, BackFacesOfSingleSidedOnesAreNotSeenUnlessMirrored) {
    testing::context();
    SceneBuilder b;
    const auto white = b.add_lambert(vec3(1));
    b.add_quad(white, vec3(-0.5f, 0, 0), vec3(0.3f, 0, 0), vec3(0, 0.3f, 0));  // faces the camera
    b.add_quad(white, vec3(0.5f, 0, 0), vec3(0, 0.3f, 0), vec3(0.3f, 0, 0));   // faces away
    b.look(vec3(0, 0, 2), vec3(0), 1);
    FrameScene scene = b.build();
    render::FrameRenderer renderer;
    testing::render_once(renderer, scene, {64, 64});
    const auto seen = renderer.read(render::Aov::depth);
    EXPECT_GT(seen.pixels[32 * 64 + 20], 0);
    EXPECT_EQ(seen.pixels[32 * 64 + 44], 0);

    // Mirrored in z the front still is the front: its normal now points the other way.
    for (Instance& instance : scene.instances) {
        instance.transform = glm::scale(mat4(1), vec3(1, 1, -1));
    }
    ++scene.frame;
    testing::render_once(renderer, scene, {64, 64});
    const auto mirrored = renderer.read(render::Aov::depth);
    const auto normals = renderer.read(render::Aov::normal);
    EXPECT_EQ(mirrored.pixels[32 * 64 + 20], 0);
    EXPECT_GT(mirrored.pixels[32 * 64 + 44], 0);
    EXPECT_NEAR(normals.pixels[3 * (32 * 64 + 44) + 2], 1, 1e-4);
}

TEST(Materials, TexturesAreReadInTheRightEncodingAndOrientation) {
    testing::context();
    SceneBuilder b;
    Material m;
    m.metallic = 1;
    m.roughness = 0.5f;
    Image colours{"colours", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 188, 188, 188, 255}};
    Image surface{"surface", 1, 1, {0, 128, 64, 255}};
    m.base_colour_texture.texture =
        b.add_image(colours, {Wrap::repeat, Wrap::repeat, Filter::nearest, Filter::nearest, false});
    m.metallic_roughness_texture.texture = b.add_image(surface);
    b.add_quad(b.add_material(m), vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
    b.look_orthographic(vec3(0, 0, 1), vec3(0), 1, 1);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), {32, 32});
    const auto stored = renderer.gbuffer().albedo().read_floats(4);  // rows upwards
    const auto material = renderer.gbuffer().material().read_floats(4);
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * 32 + x) * 4; };
    // uv (0, 0) is the quad's lower left and, in glTF, the image's upper left.
    EXPECT_NEAR(stored[at(8, 8)], 1, 0.01);
    EXPECT_NEAR(stored[at(24, 8) + 1], 1, 0.01);
    EXPECT_NEAR(stored[at(8, 24) + 2], 1, 0.01);
    EXPECT_NEAR(stored[at(24, 24)], 0.5029, 0.01);  // sRGB 188
    EXPECT_NEAR(stored[at(24, 24) + 3], 64 / 255.0, 0.01);
    EXPECT_NEAR(material[at(24, 24)], 0.5 * 128 / 255.0, 0.01);
    EXPECT_NEAR(material[at(24, 24) + 1], 0.04, 0.003);
    const auto albedo = renderer.read(render::Aov::albedo);
    EXPECT_NEAR(albedo.pixels[3 * (8 * 32 + 24)], 0.5029 * (1 - 64 / 255.0), 0.01);  // rows downwards
}

// 16 bits, linear: off by half a step of 1 / 65535. Eight bits of sRGB are off by 9e-5 to 3e-3 here.
TEST(Materials, TheAlbedoIsKeptFinerThanEightBits) {
    testing::context();
    for (const float albedo : {0.5f, 0.2f, 0.021f, 0.001f}) {
        SceneBuilder b;
        b.add_quad(b.add_lambert(vec3(albedo)), vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
        b.look_orthographic(vec3(0, 0, 1), vec3(0), 1, 1);
        render::FrameRenderer renderer;
        testing::render_once(renderer, b.build(), {8, 8});
        EXPECT_NEAR(renderer.gbuffer().albedo().read_floats(4).front(), albedo, 1e-5);
    }
}

// The level of detail must not depend on how finely a surface is cut: 2x2 pixels that straddle triangles are
// where it shows.
TEST(Materials, AFinelyCutSurfaceHasTheTextureOfAWholeOne) {
    testing::context();
    constexpr int kTexels = 64;
    Image pattern{"pattern", kTexels, kTexels, {}};
    for (int i = 0; i < kTexels * kTexels; ++i) {
        const auto bit = [&](int n) {
            return static_cast<std::uint8_t>((i * 2654435761u) >> n & 1u ? 255 : 0);
        };
        pattern.rgba.insert(pattern.rgba.end(), {bit(20), bit(24), bit(28), 255});
    }
    const auto picture = [&](int cells) {
        SceneBuilder b;
        Material m;
        m.metallic = 0;
        m.base_colour_texture.texture = b.add_image(pattern);
        m.base_colour_texture.uv_transform = {vec3(1, 0, 0), vec3(0, -1, 1)};
        b.add_quad(b.add_material(m), vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
        b.assets.meshes.edit(0, [&](Mesh& mesh) {
            const Vertex corner = mesh.vertices.front();
            mesh.vertices.clear();
            mesh.indices.clear();
            const auto row = static_cast<std::uint32_t>(cells + 1);
            for (std::uint32_t i = 0; i < row * row; ++i) {
                const vec2 uv = vec2(i % row, i / row) / static_cast<float>(cells);
                Vertex v = corner;
                v.position = vec3(2.0f * uv - 1.0f, 0);
                v.uv0 = uv;
                mesh.vertices.push_back(v);
                if (i % row + 1 < row && i / row + 1 < row) {
                    mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + row, i + 1, i + row + 1, i + row});
                }
            }
        });
        b.look_orthographic(vec3(0, 0, 1), vec3(0), 1, 1);
        render::FrameRenderer renderer;
        testing::render_once(renderer, b.build(), ivec2(kTexels));
        return renderer.read(render::Aov::albedo).pixels;
    };
    const auto whole = picture(1);
    const auto cut = picture(37);
    double difference = 0;
    double contrast = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        difference += std::abs(whole[i] - cut[i]);
        contrast += std::abs(whole[i] - 0.5f);
    }
    EXPECT_GT(contrast / static_cast<double>(whole.size()), 0.45);  // the finest level, not its average
    EXPECT_LT(difference / static_cast<double>(whole.size()), 0.002);
}

TEST(Materials, AnImageTooLargeForTheDriverIsShrunkNotRefused) {
    testing::context();
    SceneBuilder b;
    Image line{"line", 100000, 1, {}};
    line.rgba.assign(400000, 255);
    for (std::size_t i = 0; i < 50000; ++i) {
        line.rgba[4 * i] = 0;
    }
    Material m;
    m.metallic = 0;
    m.base_colour_texture.texture = b.add_image(line);
    b.add_quad(b.add_material(m), vec3(0), vec3(1, 0, 0), vec3(0, 1, 0));
    b.look_orthographic(vec3(0, 0, 1), vec3(0), 1, 1);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), {32, 32});
    const auto albedo = renderer.read(render::Aov::albedo);
    EXPECT_LT(albedo.pixels[3 * (16 * 32 + 8)], 0.01f);
    EXPECT_GT(albedo.pixels[3 * (16 * 32 + 24)], 0.99f);
}

TEST(Emissive, TrianglesSumUpToTheFlux) {
    testing::context();
    SceneBuilder b;
    Material lamp;
    lamp.emissive = vec3(10, 20, 30);
    Material both = lamp;
    both.double_sided = true;
    b.add_quad(b.add_material(lamp), vec3(0), vec3(1, 0, 0), vec3(0, 0.5f, 0));     // 2 m^2
    b.add_quad(b.add_material(both), vec3(3), vec3(0.5f, 0, 0), vec3(0, 0.5f, 0));  // 1 m^2, twice
    render::EmissiveTriangles emissive;
    FrameScene scene = b.build();
    emissive.update(scene);
    EXPECT_EQ(emissive.count(), 4);
    EXPECT_NEAR(emissive.flux().x, kPi * 10 * 4, 1e-3);
    EXPECT_NEAR(emissive.flux().z, kPi * 30 * 4, 1e-3);
    EXPECT_NEAR(emissive.triangles()[1].p0.w, 0.5, 1e-6);
    EXPECT_EQ(emissive.triangles()[3].p0.w, 1);
    EXPECT_EQ(emissive.triangles()[0].p1.w, 0);
    EXPECT_EQ(emissive.triangles()[2].p1.w, 1);

    const auto version = emissive.version();
    emissive.update(scene);  // says changed, is not
    EXPECT_EQ(emissive.version(), version);
    scene.instances[0].transform = glm::scale(mat4(1), vec3(2));
    emissive.update(scene);
    EXPECT_NEAR(emissive.flux().x, kPi * 10 * (8 + 2), 1e-3);
}

}  // namespace gbuffer_test
}  // namespace lanthorn
