// cosine_direction() of random.glsl: its density, and that a rounding error in a wall's normal moves no
// photon.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace {

constexpr int kCount = 4096;  // directions a normal

// kCount about each normal, normal after normal.
std::vector<vec4> directions_about(const std::vector<vec3>& normals) {
    testing::context();
    std::vector<vec4> padded;
    for (const vec3& n : normals) {
        padded.emplace_back(n, 0);
    }
    const gpu::Buffer in = gpu::Buffer::from(padded);
    const std::size_t all = normals.size() * kCount;
    const gpu::Buffer out(all * sizeof(vec4));
    const gpu::Program program({"tests/gpu/render/directions.comp"});
    in.bind_storage(0);
    out.bind_storage(1);
    program.use();
    program.set("count", kCount);
    program.dispatch(static_cast<int>(all), 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    return out.read<vec4>(all);
}

// Unit, with that z.
vec3 normal_of(float turn, float z) {
    const float r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

// cos / pi: the mean is 2/3 n, the second moments are 1/2 along n and 1/4 across, the fourth along n is 1/3.
TEST(CosineDirection, HasTheDensityAboutEveryNormal) {
    std::vector<vec3> normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const float z : {0.9999f, 0.3f, 1e-4f, -1e-4f, -0.999e-3f, -1.001e-3f, -0.3f, -0.9999f}) {
        normals.push_back(normal_of(0.7f, z));
        normals.push_back(normal_of(3.9f, z));
    }
    const std::vector<vec4> directions = directions_about(normals);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const dvec3 n(normals[i]);
        SCOPED_TRACE(::testing::Message() << "normal " << n.x << " " << n.y << " " << n.z);
        dvec3 mean(0);
        glm::dmat3 second(0);
        double fourth = 0;
        for (int k = 0; k < kCount; ++k) {
            const dvec3 d(vec3(directions[i * kCount + static_cast<std::size_t>(k)]));
            const double cosine = glm::dot(d, n);
            ASSERT_NEAR(glm::length(d), 1, 1e-5);
            ASSERT_GE(cosine, -1e-6);
            mean += d / double(kCount);
            second += glm::outerProduct(d, d) / double(kCount);
            fourth += std::pow(cosine, 4) / kCount;
        }
        EXPECT_LT(glm::length(mean - n * (2.0 / 3)), 0.002);
        EXPECT_NEAR(fourth, 1.0 / 3, 0.002);
        const glm::dmat3 expected = glm::dmat3(0.25) + 0.25 * glm::outerProduct(n, n);
        for (int column = 0; column < 3; ++column) {
            EXPECT_LT(glm::length(second[column] - expected[column]), 0.002);
        }
    }
}

// Walls stand at n.z = 0, where a transform's last bit decides the sign.
TEST(CosineDirection, TheSignOfARoundingErrorMovesNothing) {
    std::vector<vec3> normals;
    constexpr int kTurns = 16;
    constexpr float kOff = 1e-6f;
    for (int i = 0; i < kTurns; ++i) {
        for (const float z : {kOff, -kOff}) {
            normals.push_back(normal_of(6.2831853f * static_cast<float>(i) / kTurns, z));
        }
    }
    const std::vector<vec4> directions = directions_about(normals);
    for (std::size_t i = 0; i < normals.size(); i += 2) {
        float farthest = 0;
        for (std::size_t k = 0; k < kCount; ++k) {
            farthest = std::max(farthest, glm::length(vec3(directions[i * kCount + k]) -
                                                      vec3(directions[(i + 1) * kCount + k])));
        }
        EXPECT_LT(farthest, 10 * kOff) << normals[i].x << " " << normals[i].y;
    }
}

}  // namespace
}  // namespace lanthorn
