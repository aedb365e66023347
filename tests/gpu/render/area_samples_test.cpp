// The points that stand for emissive surfaces shine as those do, to all sides.
#include "engine/render/area_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace {

std::vector<render::LightData> samples_of(const FrameScene& scene, int count) {
    testing::context();
    render::EmissiveTriangles emissive;
    emissive.update(scene);
    render::RenderSettings settings;
    settings.area_lights_samples = count;
    return make_area_samples(emissive, settings).lights;
}

FrameScene bulb(float radius) {
    testing::SceneBuilder b;
    Material lamp;
    lamp.emissive = vec3(100);
    b.add_sphere(b.add_material(lamp), vec3(0.3f, 2, -0.1f), radius);
    return b.build();
}

double area_of(const std::vector<render::LightData>& samples) {
    double area = 0;
    for (const render::LightData& s : samples) {
        area += static_cast<double>(s.area);
    }
    return area;
}

struct Extent {
    double least = 1e30, most = 0;
};

// Of what is seen of the samples' discs from far away in all directions, over a quarter of their area: what
// is seen of a convex surface in the mean (Cauchy 1841), and of a sphere from everywhere.
Extent seen(const std::vector<render::LightData>& samples) {
    constexpr int kDirections = 400;
    Extent extent;
    for (int i = 0; i < kDirections; ++i) {
        const double z = (2.0 * i + 1) / kDirections - 1;
        const double turn = 2.399963 * i;  // the golden angle
        const dvec3 l(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
        double disc = 0;
        for (const render::LightData& s : samples) {
            disc += static_cast<double>(s.area) * std::max(0.0, glm::dot(dvec3(s.direction), l));
        }
        extent.least = std::min(extent.least, 4 * disc / area_of(samples));
        extent.most = std::max(extent.most, 4 * disc / area_of(samples));
    }
    return extent;
}

TEST(AreaSamples, ABulbShinesToAllSides) {
    // Three times as many as for a panel: it faces all ways.
    const struct {
        int count;
        double least, most;
    } cases[] = {{4, 0.9, 1.1}, {8, 0.95, 1.05}, {16, 0.97, 1.03}};
    for (const auto& c : cases) {
        const auto samples = samples_of(bulb(0.05f), c.count);
        const Extent extent = seen(samples);
        std::printf("%zu samples of a bulb: %.3f to %.3f of it\n", samples.size(), extent.least, extent.most);
        EXPECT_LE(samples.size(), static_cast<std::size_t>(3 * c.count));
        EXPECT_GT(extent.least, c.least) << c.count;
        EXPECT_LT(extent.most, c.most) << c.count;
        EXPECT_NEAR(area_of(samples), 4 * 3.14159265 * 0.05 * 0.05, 0.02 * 0.0314) << c.count;
    }
}

// A sample's shadow map shows what lies before its plane: no part of its own surface may.
TEST(AreaSamples, NothingOfABulbStandsBeforeItsSamples) {
    for (const render::LightData& s : samples_of(bulb(0.05f), 4)) {
        const vec3 out = s.position - vec3(0.3f, 2, -0.1f);
        EXPECT_NEAR(glm::length(out), 0.05f, 1e-3f);
        EXPECT_GT(glm::dot(glm::normalize(out), s.direction), 0.97f);
    }
}

// Else a lamp that moves would flicker.
TEST(AreaSamples, TheyMoveWithTheBulb) {
    FrameScene scene = bulb(0.05f);
    const auto before = samples_of(scene, 8);
    const mat4 moved = glm::rotate(glm::translate(mat4(1), vec3(0.7f, 0.1f, -3)), 0.6f, vec3(1, 2, 3));
    scene.instances.front().transform = moved;
    const auto now = samples_of(scene, 8);
    ASSERT_EQ(before.size(), now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        EXPECT_GT(glm::dot(now[i].direction, mat3(moved) * before[i].direction), 1 - 1e-5f);
        EXPECT_LT(glm::distance(now[i].position, vec3(moved * vec4(before[i].position, 1))), 5e-3f);
        EXPECT_NEAR(now[i].area / before[i].area, 1, 1e-3);
    }
}

// Of a panel each stands for as much.
TEST(AreaSamples, APanelIsCutIntoEqualParts) {
    testing::SceneBuilder b;
    Material lamp;
    lamp.emissive = vec3(100);
    b.add_quad(b.add_material(lamp), vec3(0, 2, 0), vec3(0.5f, 0, 0), vec3(0, 0, 0.25f));
    for (const int count : {2, 4, 16}) {
        const auto samples = samples_of(b.build(), count);
        ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            EXPECT_NEAR(samples[i].area, 0.5f / static_cast<float>(count), 1e-5f);
            EXPECT_NEAR(samples[i].position.y, 2, 1e-6);
            for (std::size_t k = 0; k < i; ++k) {
                EXPECT_GT(glm::distance(samples[i].position, samples[k].position),
                          0.4f * std::sqrt(samples[i].area));
            }
        }
    }
}

}  // namespace
}  // namespace lanthorn
