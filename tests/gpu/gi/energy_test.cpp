// What a bounce stores is the albedo times what the bounce before it stored, as long as no photon escapes:
// in a closed room of one albedo, whatever stands in it (conservation of energy).
#include <gtest/gtest.h>

#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr float kCandela = kSphereLux;  // in the room as in the sphere
constexpr int kBounces = 8;

FrameScene room_with_blocks(float albedo) {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.6f), vec3(2.4f, 1.6f, 1.4f), false, 0),
         box(vec3(0.1f, 0, 2), vec3(1.5f, 0.5f, 2.6f), false, 0)},
        {lambertian(vec3(albedo))}, {point_light(vec3(0.8f, 2.1f, 1.5f), kCandela)}, vec3(3.7f, 1.6f, 2.7f),
        vec3(1.2f, 1, 1.1f));
}

// Worst difference of a bounce's ratio from the albedo, relative to the albedo.
double worst_loss(const FrameScene& scene, float albedo) {
    Bench bench;
    bench.settings.bounces = kBounces;
    bench.frame(scene, ivec2(32));
    const PhotonStatistics photons = bench.technique().statistics(true).of<PhotonStatistics>();
    const double emitted = 4 * static_cast<double>(kPi) * kCandela;
    EXPECT_NEAR(photons.flux_emitted.x / emitted, 1, 1e-3);
    EXPECT_EQ(photons.flux_stored.size(), static_cast<std::size_t>(kBounces));
    double before = photons.flux_emitted.x;
    double worst = 0;
    for (std::size_t b = 0; b < photons.flux_stored.size(); ++b) {
        const double ratio = photons.flux_stored[b].x / before;
        const double loss = 1 - ratio / static_cast<double>(albedo);
        worst = std::abs(loss) > std::abs(worst) ? loss : worst;
        before = photons.flux_stored[b].x;
    }
    return worst;
}

TEST(Energy, EveryBounceKeepsTheAlbedosShare) {
    for (const float albedo : {0.5f, 0.9f}) {
        const double sphere = worst_loss(closed_sphere(albedo), albedo);
        const double room = worst_loss(room_with_blocks(albedo), albedo);
        std::printf("albedo %g: worst loss of a bounce %.5f in the sphere, %.5f in the room\n",
                    static_cast<double>(albedo), sphere, room);
        EXPECT_NEAR(sphere, 0, 5.5e-4);
        EXPECT_NEAR(room, 0, 6.5e-3);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
