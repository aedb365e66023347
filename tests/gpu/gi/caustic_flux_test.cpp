// How much light caustic photons bring in a closed room: the solid angle of what they meet, once, and all
// that is sent on.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/reference/path_tracer.h"
#include "tests/gpu/gi/caustics_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

TEST_F(Caustics, FluxIsTheSolidAngles) {
    const float radius = 0.4f;
    const vec3 lamp(0.3f, 1.2f, -0.9f);
    const double sine2 = radius * radius / glm::dot(lamp, lamp);
    const double share = 0.5 * (1 - std::sqrt(1 - sine2));
    const std::vector<Mesh> ball{support::sphere(vec3(0), radius, 5, false, 1)};
    const double point =
        stored_flux(room_with(ball, {metal(vec3(1), 0)}, {point_light(lamp, 10)}), settings_of(40'000));
    EXPECT_NEAR(point / (4 * kPi * 10 * share), 1, 0.01);
    const double spot =
        stored_flux(room_with(ball, {metal(vec3(1), 0)}, {support::spot_light(lamp, -lamp, 10, 0.9f, 1.0f)}),
                    settings_of(40'000));
    EXPECT_NEAR(spot / (4 * kPi * 10 * share), 1, 0.01);
    const double beam =
        stored_flux(room_with({box(vec3(-0.3f, 0, -0.3f), vec3(0.3f, 0.1f, 0.3f), false, 1)},
                              {metal(vec3(1), 0)}, {support::directional_light(vec3(0, -1, 0), 10)}),
                    settings_of(40'000));
    EXPECT_NEAR(beam / (10 * 0.36), 0, 0.001);  // the ceiling is in the way
    // A small lamp that emits to one side, as seen from the ball: Lambert's cosine.
    const vec3 n = glm::normalize(-lamp);
    const vec3 u = glm::normalize(glm::cross(n, vec3(1, 0, 0))) * 0.02f, v = glm::cross(n, u);
    std::vector<Mesh> lit = ball;
    lit.push_back(quad(lamp - 0.5f * (u + v), u, v, 2));
    const double emitter =
        stored_flux(room_with(lit, {metal(vec3(1), 0), support::lamp(vec3(1e5f))}, {}), settings_of(40'000));
    EXPECT_NEAR(emitter / (1e5 * 0.0004 * kPi * sine2), 1, 0.01);
}

// In a closed room: what lands of all that mirrors and glass send on.
TEST_F(Caustics, ThroughMapsAsMuchLandsAsByExactRays) {
    const std::vector<Mesh> ball{support::sphere(vec3(0, -0.6f, 0), 0.4f, 5, false, 1)};
    for (const auto& [name, material] :
         {std::pair("metal", metal(vec3(1), 0)), std::pair("glass", glass(1.5f))}) {
        const FrameScene scene = room_with(ball, {material}, {point_light(vec3(0.3f, 1.2f, -0.9f), 10)});
        const double exact = stored_flux(scene, settings_of(40'000));
        const double maps = stored_flux(scene, settings_of(40'000, EmcFinal::splat, EmcRays::maps));
        std::printf("a ball of %s in a room, through maps: flux %.4f of exact rays'\n", name, maps / exact);
        EXPECT_NEAR(maps / exact, 1, 0.05);
    }
}

TEST_F(Caustics, OverlappingTargetsAreCountedOnce) {
    // Two mirrors of which one hides half of the other, as the lamp sees them; and the same as one thing.
    const Mesh near = quad(vec3(-0.3f, 0, -0.2f), vec3(0, 0, 0.4f), vec3(0.3f, 0, 0), 1);
    const Mesh far = quad(vec3(-0.4f, -0.3f, -0.3f), vec3(0, 0, 0.6f), vec3(0.8f, 0, 0), 1);
    Mesh both = near;
    both.vertices.insert(both.vertices.end(), far.vertices.begin(), far.vertices.end());
    for (const std::uint32_t i : far.indices) {
        both.indices.push_back(i + 4);
    }
    both.bounds.add(far.bounds);
    const LightInstance lamp = point_light(vec3(0, 1.5f, 0), 10);
    const double two = stored_flux(room_with({near, far}, {metal(vec3(1), 0)}, {lamp}), settings_of(60'000));
    const double one = stored_flux(room_with({both}, {metal(vec3(1), 0)}, {lamp}), settings_of(60'000));
    EXPECT_NEAR(two / one, 1, 0.01);
}

TEST_F(Caustics, ALightInsideGlassGetsOut) {
    // At the middle of a ball all light meets it squarely, again and again.
    const double flux = stored_flux(
        room_with({support::sphere(vec3(0), 0.3f, 4, false, 1)}, {glass(1.5f)}, {point_light(vec3(0), 10)}),
        settings_of(20'000));
    EXPECT_NEAR(flux / (4 * kPi * 10), 1, 0.01);
}

TEST_F(Caustics, ExtremesStayWithinWhatIsEmitted) {
    for (const float roughness : {0.0f, 1.0f}) {
        for (const float ior : {1.0f, 3.0f}) {
            Material m = glass(ior);
            m.roughness = roughness;
            for (const float thickness : {0.0f, 0.1f}) {
                m.thickness = thickness;
                CausticStatistics all;
                const double flux = stored_flux(room_with({support::sphere(vec3(0), 0.5f, 3, false, 1)}, {m},
                                                          {point_light(vec3(0, 1.2f, 0), 10)}),
                                                settings_of(5000), &all);
                EXPECT_GT(flux, 0);
                EXPECT_LT(flux, 4 * kPi * 10 * 0.06);
                EXPECT_EQ(all.bad_values, 0u);
            }
        }
    }
}

TEST_F(Caustics, AMirrorThatFillsTheViewIsNoTrouble) {
    FrameScene scene = room_with({quad(vec3(-1.9f, -1.9f, -1), vec3(3.8f, 0, 0), vec3(0, 3.8f, 0), 1)},
                                 {metal(vec3(1), 0)}, {point_light(vec3(0, 1, 1), 10)});
    support::look(scene, vec3(0, 0, -0.9f), vec3(0, 0, -1));
    EXPECT_GT(stored_flux(scene, settings_of(5000)), 0);
}

// By each final stage, and what the path tracer finds.
struct ScatteredCaustics {
    double gather = 0, splat = 0, wanted = 0;
};

// A spot shines at a wall alone: all that the ball sends on has been scattered before. The path tracer finds
// it, too.
ScatteredCaustics scattered_caustics(const Material& material) {
    constexpr ivec2 size(48);
    FrameScene scene = room_with({support::sphere(vec3(0, -1.2f, 0), 0.6f, 4, false, 1)}, {material},
                                 {support::spot_light(vec3(0, 1, 0), vec3(-1, 0.2f, 0), 300, 0.4f, 0.5f)});
    support::look(scene, vec3(0.9f, 1.9f, 0.7f), vec3(0.1f, -2, 0));
    scene.camera.camera.y_fov = 1.0f;
    reference::PathSettings path;
    path.transport = reference::Transport::full;
    path.bounces = 3;
    path.spp = 400;
    ScatteredCaustics result;
    for (const bool caustics : {true, false}) {
        for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
            Bench bench;
            bench.settings = settings_of(caustics ? 60'000 : 0, final_stage);
            bench.settings.bounces = path.bounces;
            double& sum = final_stage == EmcFinal::gather ? result.gather : result.splat;
            for (const float lux : bench.frame(scene, size).pixels) {
                sum += (caustics ? 1 : -1) * static_cast<double>(lux);
            }
        }
        path.caustics = caustics;
        for (const float lux : path_picture(scene, size, path)) {
            result.wanted += (caustics ? 1 : -1) * static_cast<double>(lux);
        }
    }
    return result;
}

TEST_F(Caustics, LightThatWallsReflectFirstIsFollowed) {
    for (const Material& material : {metal(vec3(1), 0), glass(1.5f)}) {
        const ScatteredCaustics found = scattered_caustics(material);
        std::printf("%s: gather %.4f, splat %.4f of the path tracer's\n",
                    material.metallic > 0 ? "mirror" : "glass", found.gather / found.wanted,
                    found.splat / found.wanted);
        EXPECT_GT(found.wanted, 0);
        EXPECT_NEAR(found.gather / found.wanted, 1, 0.1);
        EXPECT_NEAR(found.splat / found.wanted, 1, 0.1);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
