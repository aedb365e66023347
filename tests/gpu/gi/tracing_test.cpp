// Image-space hits against exact ray casting: photons' second segments, each cast anew against every
// triangle.
#include <gtest/gtest.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

vec3 unpack_normal(std::uint32_t packed) {
    const float x =
        std::max(-1.0f, static_cast<float>(static_cast<std::int16_t>(packed & 0xffff)) / 32767.0f);
    const float y = std::max(-1.0f, static_cast<float>(static_cast<std::int16_t>(packed >> 16)) / 32767.0f);
    vec3 n(x, y, 1 - std::abs(x) - std::abs(y));
    const float fold = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -fold : fold;
    n.y += n.y >= 0 ? -fold : fold;
    return glm::normalize(n);
}

// Distance to the nearest triangle (Moeller and Trumbore 1997), infinite without.
float cast(const FrameScene& scene, const dvec3& origin, const dvec3& direction, double t_min) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.assets->meshes[instance.mesh];
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const dvec3 p0 = mesh.vertices[mesh.indices[i]].position;
            const dvec3 e1 = dvec3(mesh.vertices[mesh.indices[i + 1]].position) - p0;
            const dvec3 e2 = dvec3(mesh.vertices[mesh.indices[i + 2]].position) - p0;
            const dvec3 p = glm::cross(direction, e2);
            const double det = glm::dot(e1, p);
            if (std::abs(det) < 1e-15) {
                continue;
            }
            const dvec3 s = origin - p0;
            const double u = glm::dot(s, p) / det;
            const dvec3 q = glm::cross(s, e1);
            const double v = glm::dot(direction, q) / det;
            const double t = glm::dot(e2, q) / det;
            if (u >= 0 && v >= 0 && u + v <= 1 && t > t_min && t < nearest) {
                nearest = t;
            }
        }
    }
    return static_cast<float>(nearest);
}

// A furnished closed room: walls, two blocks, a table top on legs.
FrameScene furnished_room() {
    std::vector<Mesh> meshes{box(vec3(0), vec3(4, 2.6f, 4), true, 0),
                             box(vec3(0.4f, 0, 0.5f), vec3(1.4f, 1.5f, 1.2f), false, 1),
                             box(vec3(2.4f, 0, 2.3f), vec3(3.2f, 0.6f, 3.1f), false, 2),
                             box(vec3(2.0f, 0.7f, 0.5f), vec3(3.4f, 0.78f, 1.5f), false, 1)};
    for (const vec2& leg : {vec2(2.1f, 0.6f), vec2(3.2f, 0.6f), vec2(2.1f, 1.3f), vec2(3.2f, 1.3f)}) {
        meshes.push_back(box(vec3(leg.x, 0, leg.y), vec3(leg.x + 0.1f, 0.7f, leg.y + 0.1f), false, 2));
    }
    return scene_of(
        std::move(meshes),
        {lambertian(vec3(0.7f)), lambertian(vec3(0.6f, 0.2f, 0.2f)), lambertian(vec3(0.2f, 0.5f, 0.3f))},
        {point_light(vec3(2, 2.3f, 2), 200)}, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1));
}

struct Agreement {
    double good = 0;  // share of second segments whose hit lies within 2 % of the diagonal of the true one
    double lost = 0;  // share without a hit, in a closed room
};

Agreement agreement(const GiSettings& settings) {
    const FrameScene scene = furnished_room();
    Bench bench;
    bench.settings = settings;
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    bench.settings.photons = 4000;
    bench.frame(scene, ivec2(64));
    const auto& photons = static_cast<const EmcTechnique&>(bench.technique()).photons();
    const auto hits = photons.arrived().read();
    const auto n = static_cast<std::size_t>(bench.settings.photons);
    const float diagonal = scene.diagonal();
    int all = 0;
    int good = 0;
    int lost = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const PhotonHit& from = hits[i];
        const PhotonHit& to = hits[n + i];
        if (from.radius <= 0) {
            continue;
        }
        ++all;
        if (to.radius <= 0) {
            ++lost;
            continue;
        }
        const vec3 segment = to.position - from.position;
        const float length = glm::length(segment);
        const vec3 origin = from.position + unpack_normal(from.normal) * (2e-5f * diagonal);
        const float t = cast(scene, origin, glm::normalize(segment), 1e-4 * diagonal);
        good += std::abs(t - length) < 0.02f * diagonal ? 1 : 0;
    }
    EXPECT_GT(all, 3000);
    return {static_cast<double>(good) / all, static_cast<double>(lost) / all};
}

TEST(Tracing, TheMarchAgreesWithExactRays) {
    const Agreement a = agreement({});
    std::printf("furnished room, march %d: agreement %.4f, lost %.4f\n", EmcSettings().steps, a.good, a.lost);
    EXPECT_GT(a.good, 0.965);  // 0.9815
    EXPECT_LT(a.lost, 0.005);  // 0.0020
}

TEST(Tracing, MoreStepsAgreeBetter) {
    GiSettings coarse;
    coarse.edit<EmcSettings>().steps = 8;
    GiSettings fine;
    fine.edit<EmcSettings>().steps = 256;
    fine.edit<EmcSettings>().resolution = 256;
    const Agreement c = agreement(coarse);
    const Agreement f = agreement(fine);
    std::printf("furnished room: 8 steps %.4f, 256 steps at 256^2 %.4f\n", c.good, f.good);
    EXPECT_GT(f.good, c.good);
    EXPECT_GT(f.good, 0.98);  // 0.9927
}

TEST(Tracing, TheSecantIsThePapersAndWeaker) {
    GiSettings secant;
    secant.edit<EmcSettings>().search = Search::secant;
    secant.edit<EmcSettings>().threshold = 1e-3f;
    const Agreement s = agreement(secant);
    std::printf("furnished room, secant: agreement %.4f, lost %.4f\n", s.good, s.lost);
    EXPECT_GT(s.good, 0.92);  // 0.9317
    EXPECT_LT(s.good, agreement({}).good);
}

}  // namespace
}  // namespace lanthorn::gi::test
