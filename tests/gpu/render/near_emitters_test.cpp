// Direct light beside emissive surfaces, millimetres to centimetres off them, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "engine/render/area_samples.h"
#include "tests/gpu/render/scenes.h"
#include "tests/support/closed_forms.h"

namespace lanthorn {
namespace near_emitters_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(96, 96);
constexpr float kNits = 100;

// A white floor of 2 m by 2 m, scaled, seen straight from above through what has its back to the camera.
SceneBuilder floor_scene(float scale, float half_width) {
    SceneBuilder b;
    b.add_quad(b.add_lambert(vec3(1)), vec3(0), scale * vec3(0, 0, 1), scale * vec3(1, 0, 0));
    b.look_orthographic(scale * vec3(0, 2, 0), vec3(0), scale * half_width, scale * half_width);
    return b;
}

std::uint32_t lamp_material(SceneBuilder& b) {
    Material lamp;
    lamp.base_colour = vec4(0, 0, 0, 1);
    lamp.emissive = vec3(kNits);
    return b.add_material(lamp);
}

// Irradiance of what a pixel of the floor shows, and where it is.
struct Lit {
    dvec3 at;
    double lux;
};

std::vector<Lit> floor_light(const SceneBuilder& b, float half_width) {
    testing::context();
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    EXPECT_EQ(renderer.nan_count(), 0u);
    const ImageF direct = renderer.read(render::Aov::direct);
    const ImageF albedo = renderer.read(render::Aov::albedo);
    std::vector<Lit> lit;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const std::size_t i = static_cast<std::size_t>(y * kSize.x + x) * 3;
            if (albedo.pixels[i] > 0.5f) {  // not the lamp
                const double across = (x + 0.5) / kSize.x * 2 - 1, along = (y + 0.5) / kSize.y * 2 - 1;
                lit.push_back({static_cast<double>(half_width) * dvec3(across, 0, along),
                               support::kPiD * static_cast<double>(direct.pixels[i])});
            }
        }
    }
    return lit;
}

struct Errors {
    double flux = 0;     // sum over the right one
    double relrmse = 0;  // by the right mean
    double local = 0;    // largest |error| over the right value, where that is a tenth of the mean or more
};

Errors against(const std::vector<Lit>& lit, const std::function<double(const dvec3&)>& right) {
    double sum = 0, squares = 0, right_sum = 0;
    std::vector<double> wanted;
    for (const Lit& l : lit) {
        wanted.push_back(right(l.at));
        sum += l.lux;
        right_sum += wanted.back();
        squares += (l.lux - wanted.back()) * (l.lux - wanted.back());
    }
    const double n = static_cast<double>(lit.size()), mean = right_sum / n;
    Errors e{sum / right_sum, std::sqrt(squares / n) / mean, 0};
    for (std::size_t i = 0; i < lit.size(); ++i) {
        if (wanted[i] > 0.1 * mean) {
            e.local = std::max(e.local, std::abs(lit[i].lux / wanted[i] - 1));
        }
    }
    return e;
}

// A panel of 60 cm by 40 cm that faces the floor from so near: a sign lit from behind.
class PanelBeside : public ::testing::TestWithParam<std::pair<float, float>> {};

TEST_P(PanelBeside, FollowsLambertsPolygonFormula) {
    const auto [scale, gap] = GetParam();
    SceneBuilder b = floor_scene(scale, 0.5f);
    const dvec3 c(0, gap, 0), u(0.3, 0, 0), v(0, 0, 0.2);
    b.add_quad(lamp_material(b), scale * vec3(c), scale * vec3(u), scale * vec3(v));
    const std::array<dvec3, 4> corners{c - u - v, c + u - v, c + u + v, c - u + v};
    const Errors e = against(floor_light(b, 0.5f), [&](const dvec3& p) {
        return static_cast<double>(kNits) * support::kPiD *
               support::polygon_factor(corners, p, dvec3(0, 1, 0));
    });
    std::printf("a panel %.3f off, scale %g: flux %.3f, relRMSE %.3f, at most %.3f\n",
                static_cast<double>(gap), static_cast<double>(scale), e.flux, e.relrmse, e.local);
    EXPECT_NEAR(e.flux, 1, 0.01);
    EXPECT_LT(e.relrmse, 0.02);
}

INSTANTIATE_TEST_SUITE_P(GapsAndScales, PanelBeside,
                         ::testing::Values(std::pair(1.0f, 0.005f), std::pair(1.0f, 0.01f),
                                           std::pair(1.0f, 0.02f), std::pair(1.0f, 0.1f),
                                           std::pair(1e-3f, 0.02f), std::pair(1e3f, 0.02f)));

// A panel that stands on the floor, or in it: what is below the horizon sends nothing.
TEST(NearEmitters, OnesThatCrossTheHorizon) {
    for (const double below : {0.0, 0.05}) {
        SceneBuilder b = floor_scene(1, 0.5f);
        const double high = 0.5;
        b.add_quad(lamp_material(b), vec3(-0.1f, static_cast<float>((high - below) / 2), 0),
                   vec3(0, static_cast<float>((high + below) / 2), 0), vec3(0, 0, 0.2f));
        const std::array<dvec3, 4> corners{dvec3(-0.1, 0, -0.2), dvec3(-0.1, high, -0.2),
                                           dvec3(-0.1, high, 0.2), dvec3(-0.1, 0, 0.2)};
        const Errors e = against(floor_light(b, 0.5f), [&](const dvec3& p) {
            return p.x < -0.1 ? 0
                              : static_cast<double>(kNits) * support::kPiD *
                                    support::polygon_factor(corners, p, dvec3(0, 1, 0));
        });
        std::printf("a panel that stands %.2f in the floor: flux %.3f, relRMSE %.3f\n", below, e.flux,
                    e.relrmse);
        EXPECT_NEAR(e.flux, 1, 0.02);
        EXPECT_LT(e.relrmse, 0.1);
    }
}

// A ball of radius r whose middle is at distance d sends pi L (r / d)^2 square to it.
TEST(NearEmitters, ABulbBesideAFloor) {
    for (const float gap : {0.005f, 0.01f, 0.02f}) {
        SceneBuilder b = floor_scene(1, 0.1f);
        const float r = 0.04f;
        b.add_sphere(lamp_material(b), vec3(0, gap + r, 0), r);
        const Errors e = against(floor_light(b, 0.1f), [&](const dvec3& p) {
            const dvec3 d = dvec3(0, gap + r, 0) - p;
            const double l = glm::length(d);
            return static_cast<double>(kNits * r * r) * support::kPiD * d.y / (l * l * l);
        });
        std::printf("a bulb %.3f off: flux %.3f, relRMSE %.3f, at most %.3f\n", static_cast<double>(gap),
                    e.flux, e.relrmse, e.local);
        EXPECT_NEAR(e.flux, 1, 0.07);  // twelve points of a bulb have 0.93 to 1.08 of its light further off
        EXPECT_LT(e.relrmse, 0.08);
    }
}

// A ring of neon about the y axis.
Mesh ring(std::uint32_t material, float big, float small, float height) {
    constexpr std::uint32_t kAround = 96, kAcross = 12;
    Mesh mesh;
    mesh.material = material;
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (std::uint32_t k = 0; k < kAcross; ++k) {
            const float a = 2 * kPi * static_cast<float>(i) / kAround;
            const float t = 2 * kPi * static_cast<float>(k) / kAcross;
            const vec3 out(std::cos(a), 0, std::sin(a));
            Vertex vertex;
            vertex.normal = std::cos(t) * out + vec3(0, std::sin(t), 0);
            vertex.position = big * out + vec3(0, height, 0) + small * vertex.normal;
            vertex.tangent = vec4(-std::sin(a), 0, std::cos(a), 1);
            mesh.vertices.push_back(vertex);
            mesh.bounds.add(vertex.position);
            const std::uint32_t next = (i + 1) % kAround * kAcross, up = (k + 1) % kAcross;
            for (const std::uint32_t index :
                 {i * kAcross + k, i * kAcross + up, next + up, i * kAcross + k, next + up, next + k}) {
                mesh.indices.push_back(index);
            }
        }
    }
    return mesh;
}

// By its triangles' own form factors; in the plane of the floor nothing of it hides more than a sliver.
double ring_light(const Mesh& mesh, const dvec3& p) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        const dvec3 a = corner(0), b = corner(1), c = corner(2);
        if (glm::dot(glm::cross(b - a, c - a), p - a) > 0) {
            sum += support::polygon_factor({a, b, c, c}, p, dvec3(0, 1, 0));
        }
    }
    return static_cast<double>(kNits) * support::kPiD * sum;
}

TEST(NearEmitters, ARingOfNeonHasNoSpots) {
    for (const float gap : {0.005f, 0.01f, 0.02f}) {
        SceneBuilder b = floor_scene(1, 0.5f);
        const float big = 0.3f, small = 0.008f;
        const std::uint32_t quad = b.add_quad(lamp_material(b), vec3(0), vec3(1, 0, 0), vec3(0, 0, 1));
        const Mesh mesh = ring(1, big, small, gap + small);
        b.assets.meshes.edit(1, [&](Mesh& m) { m = mesh; });
        b.scene.instances[quad].bounds = mesh.bounds;
        const auto all = floor_light(b, 0.5f);
        std::vector<Lit> lit;
        for (std::size_t i = 0; i < all.size(); i += 7) {
            lit.push_back(all[i]);
        }
        const Errors e = against(lit, [&](const dvec3& p) { return ring_light(mesh, p); });
        // Round and round beside the ring it is as bright.
        double least = 1e30, most = 0;
        for (const Lit& l : lit) {
            const double r = std::hypot(l.at.x, l.at.z);
            if (r > static_cast<double>(big) - 0.04 && r < static_cast<double>(big) - 0.015) {
                const double ratio = l.lux / ring_light(mesh, l.at);
                least = std::min(least, ratio);
                most = std::max(most, ratio);
            }
        }
        std::printf("a ring %.3f off: flux %.3f, relRMSE %.3f, around it %.3f to %.3f of its light\n",
                    static_cast<double>(gap), e.flux, e.relrmse, least, most);
        EXPECT_NEAR(e.flux, 1, 0.05);
        if (gap >= 0.01f) {  // nearer, single places lie in their points' shadow, or not, by rounding
            EXPECT_LT(e.relrmse, 0.1);
        }
        EXPECT_GT(least, 0.9);
        EXPECT_LT(most, 1.1);
    }
}

// Lamps in one mesh that do not hang together have no near parts where a sample stands for several of them:
// what lies between them and a wall is not what lies before its point.
TEST(NearEmitters, WhatStandsApartHasNone) {
    testing::context();
    SceneBuilder b;
    b.add_quad(lamp_material(b), vec3(0, 3, 0), vec3(0.1f, 0, 0), vec3(0, 0, 0.1f));
    Mesh mesh = b.assets.meshes[0];
    const Mesh one = mesh;
    constexpr int kLamps = 40;
    for (int n = 1; n < kLamps; ++n) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (Vertex vertex : one.vertices) {
            vertex.position.x += static_cast<float>(n);
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t index : one.indices) {
            mesh.indices.push_back(first + index);
        }
    }
    b.assets.meshes.edit(0, [&](Mesh& m) { m = mesh; });
    render::EmissiveTriangles emissive;
    emissive.update(b.build());
    const render::AreaSamples samples = make_area_samples(emissive, render::RenderSettings());
    ASSERT_LT(samples.lights.size(), static_cast<std::size_t>(kLamps));
    int with_parts = 0;
    for (const render::LightData& light : samples.lights) {
        // A lamp's own area, 0.04 m^2, or that of several.
        EXPECT_TRUE(light.cone_offset <= light.cone_scale || light.area < 0.041f);
        with_parts += light.cone_offset > light.cone_scale ? 1 : 0;
    }
    EXPECT_LT(with_parts, static_cast<int>(samples.lights.size()));
}

}  // namespace near_emitters_test
}  // namespace lanthorn
