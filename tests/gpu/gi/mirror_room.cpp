#include "tests/gpu/gi/mirror_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/reference/path_tracer.h"

namespace lanthorn::gi::test {

namespace {

constexpr float kMirror = 3.99f;  // x

FrameScene room(const Material& mirror, const vec3& eye, const vec3& target, bool lamp_above) {
    std::vector<Mesh> meshes{
        quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0),    quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),
        quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 1),  quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 2),
        quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0), box({0.5f, 0, 0.5f}, {1.1f, 0.9f, 1.1f}, false, 2),
        quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0),  quad({kMirror, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 3)};
    std::vector<LightInstance> lights;
    if (lamp_above) {
        meshes.push_back(quad({1.5f, 2.55f, 1}, {1, 0, 0}, {0, 0, 1}, 4));
    } else {
        lights.push_back(point_light(vec3(2, 2.1f, 0.6f), 60));
    }
    FrameScene scene = scene_of(std::move(meshes),
                                {lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)),
                                 lambertian(vec3(0.7f, 0.3f, 0.2f)), mirror, lamp(vec3(60))},
                                std::move(lights), eye, target);
    scene.camera.camera.y_fov = 0.6f;
    return scene;
}

const vec3 kEye(2, 1.3f, 2), kTarget(4, 1, 1.2f);

vec3 mirrored(const vec3& p) {
    return {2 * kMirror - p.x, p.y, p.z};
}

}  // namespace

FrameScene mirror_room(const Material& mirror) {
    return room(mirror, kEye, kTarget, false);
}

FrameScene behind_the_mirror(const Material& mirror) {
    return room(mirror, mirrored(kEye), mirrored(kTarget), false);
}

FrameScene mirror_room_with_a_lamp(const Material& mirror) {
    return room(mirror, kEye, kTarget, true);
}

Deviation against_flipped(const ImageF& shown, const ImageF& seen) {
    double squares = 0;
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const auto at = [&](const ImageF& image, int column) {
                    return static_cast<double>(
                        image.pixels[static_cast<std::size_t>(3 * (y * image.width + column) + c)]);
                };
                squares += std::pow(at(shown, x) - at(seen, seen.width - 1 - x), 2);
            }
        }
    }
    return {mean_of(shown) / mean_of(seen),
            std::sqrt(squares / static_cast<double>(seen.pixels.size())) / mean_of(seen)};
}

Deviation against_path(const ImageF& shown, const FrameScene& scene, int bounces, int spp) {
    std::vector<float> halves[2];
    reference::PathSettings settings;
    settings.spp = spp / 2;
    settings.bounces = bounces;
    settings.transport = reference::Transport::full;
    for (std::vector<float>& half : halves) {
        reference::PathTracer tracer(scene, {shown.width, shown.height}, settings, {.radiance = true});
        tracer.render({});
        half = tracer.image(reference::PathAov::radiance);
        ++settings.seed;
    }
    double squares = 0, wanted = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        const auto got = static_cast<double>(shown.pixels[i]), a = static_cast<double>(halves[0][i]),
                   b = static_cast<double>(halves[1][i]);
        squares += (got - a) * (got - b);
        wanted += 0.5 * (a + b);
    }
    const auto n = static_cast<double>(shown.pixels.size());
    return {mean_of(shown) / (wanted / n), std::sqrt(std::max(squares, 0.0) / n) / (wanted / n)};
}

void expect_the_view_from_behind(const char* name, Bench& before, Bench& behind, ivec2 size) {
    const Deviation d = against_flipped(radiance_of(before, mirror_room(metal(vec3(1), 0)), size),
                                        radiance_of(behind, behind_the_mirror(metal(vec3(1), 0)), size));
    std::printf("%s, mirror: mean %.4f of what a camera behind it sees, relRMSE %.4f\n", name, d.mean,
                d.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.01);
    EXPECT_LT(d.rel_rmse, 0.08);
}

void expect_the_walls_that_the_path_tracer_finds(const char* name, Bench& bench, ivec2 size, int frames) {
    const FrameScene scene = mirror_room_with_a_lamp(metal(vec3(1), 0));
    const auto of_path = [&] {
        return against_path(radiance_of(bench, scene, size, frames), scene, bench.settings.bounces + 1, 256);
    };
    const Deviation d = of_path();
    bench.settings.specular_roughness = 0;
    const Deviation without = of_path();
    EXPECT_EQ(bench.technique().traced_lobes().roughness, 0);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("mirrors"));
    std::printf("%s, mirror and path: flux %.4f, relRMSE %.4f; without rays %.4f, %.4f\n", name, d.mean,
                d.rel_rmse, without.mean, without.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.03);
    EXPECT_LT(d.rel_rmse, 0.06);
    EXPECT_GT(without.rel_rmse, 5 * d.rel_rmse);
}

void expect_a_lamp_to_be_followed(Bench& kept, Bench& fresh, ivec2 size,
                                  const std::function<void()>& after_the_move) {
    FrameScene scene = mirror_room(metal(vec3(1), 0));
    radiance_of(kept, scene, size);
    hold_still(scene);
    scene.lights[0].position = vec3(1.2f, 1.9f, 2);
    scene.changes.lights = true;
    const ImageF followed = radiance_of(kept, scene, size);
    EXPECT_TRUE(kept.technique().statistics(false).plan.on("mirrors"));
    after_the_move();
    FrameScene anew = mirror_room(metal(vec3(1), 0));
    anew.lights[0].position = scene.lights[0].position;
    EXPECT_EQ(followed.pixels, radiance_of(fresh, anew, size).pixels);
    hold_still(scene);
    kept.show(scene, size);
    for (const PlanEntry& entry : kept.technique().statistics(false).plan.entries) {
        EXPECT_FALSE(entry.on) << entry.pass;
    }
}

}  // namespace lanthorn::gi::test
