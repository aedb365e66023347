// Caustic photons against closed forms: a plane mirror is an image source, a ball of glass has its focus.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/reference/path_tracer.h"
#include "tests/gpu/gi/caustics_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

TEST_F(Caustics, APlaneMirrorIsAnImageSource) {
    // An upright mirror at x = 0.9, its front towards -x; the lamp's image stands behind it.
    Floor floor;
    floor.meshes.push_back(quad(vec3(0.9f, 0.1f, -0.3f), vec3(0, 0, 0.6f), vec3(0, 0.3f, 0), 1));
    floor.materials.push_back(metal(vec3(1), 0));
    const vec3 lamp(0.4f, 0.8f, 0);
    const vec3 image(1.4f, 0.8f, 0);
    floor.lights = {point_light(lamp, 100)};
    for (const auto& [final_stage, rays] :
         {std::pair(EmcFinal::gather, EmcRays::bvh), std::pair(EmcFinal::splat, EmcRays::bvh),
          std::pair(EmcFinal::splat, EmcRays::maps)}) {
        const ImageF seen = caustics_of(floor.scene(), 60'000, final_stage, rays);
        double sum = 0, wanted = 0, difference = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                float lux = 0;
                for (int i = 0; i < 16; ++i) {
                    const vec3 p = place(x, y, {0.125f + 0.25f * (i % 4), 0.125f + 0.25f * (i / 4)});
                    const vec3 d = p - image;
                    const vec3 through = image + d * ((0.9f - image.x) / d.x);
                    const bool lit =
                        p.x < 0.9f && std::abs(through.z) < 0.3f && through.y > 0.1f && through.y < 0.4f;
                    const float r2 = glm::dot(d, d);
                    lux += lit ? 100 * image.y / (r2 * std::sqrt(r2)) / 16 : 0;
                }
                const float got = seen.pixels[3 * static_cast<std::size_t>(y * kSize.x + x)];
                ASSERT_TRUE(std::isfinite(got));
                sum += got;
                wanted += lux;
                difference += std::abs(got - lux);
            }
        }
        std::printf("mirror%s: flux %.4f of the image source's, mean difference %.4f\n",
                    rays == EmcRays::maps ? ", through maps" : "", sum / wanted, difference / wanted);
        // Maps know the mirror's rim to a texel.
        EXPECT_NEAR(sum / wanted, 1, rays == EmcRays::maps ? 0.06 : 0.02);
        EXPECT_LT(difference / wanted, 0.12);
    }
}

// Upright light on a slab of glass above the floor: the mean irradiance in its middle, over what falls in.
double slab_share(Material glass, float thickness, EmcRays rays = EmcRays::bvh) {
    Floor floor;
    floor.meshes.push_back(box(vec3(-0.6f, 0.6f, -0.6f), vec3(0.6f, 0.6f + thickness, 0.6f), false, 1));
    floor.materials.push_back(glass);
    floor.lights = {support::directional_light(vec3(0, -1, 0), 100)};
    Bench bench;
    bench.settings = settings_of(40'000, EmcFinal::gather, rays);
    FrameScene scene = floor.scene();
    look_closely(scene, vec3(0, 0.5f, 0), vec3(0), 0.4f);
    const ImageF image = bench.frame(scene, kSize);
    double sum = 0;
    for (const float lux : image.pixels) {
        sum += lux;
    }
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
    return sum / static_cast<double>(image.pixels.size()) / 100;
}

TEST_F(Caustics, ASlabOfGlassLetsItsShareThrough) {
    for (const double ior : {1.0, 1.5, 3.0}) {
        const double r = std::pow((ior - 1) / (ior + 1), 2);
        const double share = slab_share(glass(static_cast<float>(ior)), 0.1f);
        std::printf("slab of ior %.2f: %.4f goes through, %.4f by Fresnel\n", ior, share, (1 - r) / (1 + r));
        EXPECT_NEAR(share, (1 - r) / (1 + r), 0.015);
    }
    const double through_maps = slab_share(glass(1.5f), 0.1f, EmcRays::maps);
    std::printf("through maps: slab of ior 1.5: %.4f goes through\n", through_maps);
    EXPECT_NEAR(through_maps, 0.96 / 1.04, 0.015);
    // With Beer's law: all orders of reflection within.
    Material dark = glass(1.5f);
    dark.attenuation_distance = 0.1f;
    dark.attenuation_colour = vec3(0.5f);
    const double share = slab_share(dark, 0.1f);
    EXPECT_NEAR(share, 0.96 * 0.96 * 0.5 / (1 - 0.04 * 0.04 * 0.25), 0.01);
    // A thin wall: each of its two sides by Schlick's f0, as the reference has it.
    Material thin = glass(1.5f);
    thin.thickness = 0;
    EXPECT_NEAR(slab_share(thin, 0.02f), 0.96 * 0.96, 0.015);
}

class CausticsBy : public Caustics, public testing::WithParamInterface<EmcRays> {};

INSTANTIATE_TEST_SUITE_P(Rays, CausticsBy, testing::Values(EmcRays::bvh, EmcRays::maps),
                         [](const testing::TestParamInfo<EmcRays>& info) {
                             return info.param == EmcRays::maps ? "maps" : "bvh";
                         });

// Beams of parallel light through a ball of glass: exactly where each meets the floor.
TEST_P(CausticsBy, ABallOfGlassHasItsFocus) {
    const float radius = 0.25f, ior = 1.5f, height = 0.55f;
    const vec3 direction = glm::normalize(vec3(0.4f, -1, 0.1f));
    Floor floor;
    floor.meshes.push_back(support::sphere(vec3(0, height, 0), radius, 5, false, 1));
    floor.materials.push_back(glass(ior));
    floor.lights = {support::directional_light(direction, 100)};
    FrameScene scene = floor.scene();
    const ImageF seen = caustics_of(scene, 100'000, EmcFinal::gather, GetParam());
    // Rays by their distance b from the axis: bent twice in their plane.
    const vec3 side = glm::normalize(glm::cross(direction, vec3(0, 0, 1)));
    const vec3 other = glm::cross(direction, side);
    std::vector<double> lux(seen.pixels.size() / 3, 0);
    const int rings = 400, turns = 400;
    const float pixel = 2 * Floor::kHalf / kSize.x;
    for (int i = 0; i < rings; ++i) {
        const float b = radius * (static_cast<float>(i) + 0.5f) / rings;
        const float in = std::asin(b / radius), inside = std::asin(b / radius / ior);
        const float deviation = 2 * (in - inside), leaves = in - 2 * inside;  // at this angle beyond the axis
        const float rs = std::pow(std::sin(in - inside) / std::sin(in + inside), 2.0f);
        const float rp = std::pow(std::tan(in - inside) / std::tan(in + inside), 2.0f);
        const float through = 0.5f * ((1 - rs) * (1 - rs) + (1 - rp) * (1 - rp));
        const double flux = 100.0 * 2 * kPi * b * (radius / rings) / turns * through;
        for (int k = 0; k < turns; ++k) {
            const float phi = 2 * kPi * (static_cast<float>(k) + 0.5f) / turns;
            const vec3 out = side * std::cos(phi) + other * std::sin(phi);
            const vec3 start =
                vec3(0, height, 0) + radius * (direction * std::cos(leaves) - out * std::sin(leaves));
            const vec3 d = direction * std::cos(deviation) - out * std::sin(deviation);
            const vec3 p = start - d * (start.y / d.y);
            const int x = static_cast<int>(std::floor((Floor::kHalf - p.x) / pixel));
            const int y = static_cast<int>(std::floor((Floor::kHalf - p.z) / pixel));
            if (d.y < 0 && x >= 0 && y >= 0 && x < kSize.x && y < kSize.y) {
                lux[static_cast<std::size_t>(y * kSize.x + x)] += flux / (pixel * pixel);
            }
        }
    }
    const auto brightest = std::ranges::max_element(lux) - lux.begin();
    std::vector<float> got;
    double sum = 0, wanted = 0, near = 0, near_wanted = 0;
    const vec3 peak = place(static_cast<int>(brightest) % kSize.x, static_cast<int>(brightest) / kSize.x);
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const float here = seen.pixels[3 * i];
        got.push_back(here);
        const vec3 p = place(static_cast<int>(i) % kSize.x, static_cast<int>(i) / kSize.x);
        if (glm::distance(p, peak) < 0.35f) {
            sum += here;
            wanted += lux[i];
        }
        if (glm::distance(p, peak) < 0.06f) {
            near += here;
            near_wanted += lux[i];
        }
    }
    const auto peak_seen = std::ranges::max_element(got) - got.begin();
    const float off = glm::distance(
        peak, place(static_cast<int>(peak_seen) % kSize.x, static_cast<int>(peak_seen) / kSize.x));
    std::printf(
        "ball: flux %.4f of Snell's and Fresnel's, %.4f of it within 6 cm of the focus; peak off by %.4f of "
        "the "
        "diagonal\n",
        sum / wanted, near / near_wanted, off / scene.diagonal());
    EXPECT_NEAR(sum / wanted, 1, 0.05);
    EXPECT_NEAR(near / near_wanted, 1, 0.05);
    EXPECT_LT(off / scene.diagonal(), 0.02);
}

// A ball of glass on a floor under a sky with a small bright sun in it: what the ball gathers, and where.
TEST_F(Caustics, ASkysSunIsGatheredByABallOfGlass) {
    constexpr ivec2 kPicture(48);
    Floor floor;
    floor.meshes.push_back(support::sphere(vec3(0, 0.42f, 0), 0.28f, 5, false, 1));
    floor.materials.push_back(glass(1.5f));
    FrameScene scene = floor.scene();
    SkyImage image;
    image.width = 64;
    image.height = 32;
    image.radiance.assign(std::size_t{64} * 32, vec3(50));
    image.radiance[6 * 64 + 40] = vec3(2e5f);
    scene.sky.emplace();
    scene.sky->sky.image = std::make_shared<const SkyImage>(std::move(image));

    const auto by_path = [&](bool caustics) {
        reference::PathSettings path;
        path.transport = reference::Transport::full;
        path.caustics = caustics;
        path.bounces = 1;
        path.spp = 500;
        return path_picture(scene, kPicture, path);
    };
    const std::vector<float> whole = by_path(true), rest = by_path(false);
    for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
        Bench with, without;
        with.settings = with_usual_maps(settings_of(60'000, final_stage));
        without.settings = with_usual_maps(settings_of(0, final_stage));
        with.settings.bounces = without.settings.bounces = 1;
        const ImageF seen = with.frame(scene, kPicture);
        const ImageF base = without.frame(scene, kPicture);
        double sum = 0, wanted = 0, all = 0, all_wanted = 0;
        glm::dvec2 centre(0), right(0);
        for (std::size_t i = 0; i < whole.size() / 3; ++i) {
            const double got = seen.pixels[3 * i + 1] - base.pixels[3 * i + 1];
            const double there = whole[3 * i + 1] - rest[3 * i + 1];
            ASSERT_TRUE(std::isfinite(got));
            sum += got;
            wanted += there;
            all += seen.pixels[3 * i + 1];
            all_wanted += whole[3 * i + 1];
            const glm::dvec2 at(static_cast<double>(i % 48), static_cast<double>(i / 48));
            centre += got * at;
            right += there * at;
        }
        const double off = glm::length(centre / sum - right / wanted) / 48;
        std::printf(
            "a sky through a ball: flux %.4f of the path tracer's, centre off by %.4f of the width; all "
            "%.4f\n",
            sum / wanted, off, all / all_wanted);
        EXPECT_NEAR(sum / wanted, 1, 0.1);
        EXPECT_NEAR(all / all_wanted, 1, 0.05);
        EXPECT_LT(off, 0.02);
    }
}

// Through a window of no thickness the floor has its caustic as without it, though the picture shows no
// floor.
TEST_F(Caustics, AreSeenThroughGlass) {
    const auto radiance = [](bool window, int photons, EmcFinal final_stage) {
        Floor floor;
        floor.materials[0] = lambertian(vec3(0.5f));
        floor.meshes.push_back(quad(vec3(0.9f, 0.1f, -0.3f), vec3(0, 0, 0.6f), vec3(0, 0.3f, 0), 1));
        floor.materials.push_back(metal(vec3(1), 0));
        if (window) {
            Material pane = glass(1.5f);
            pane.thickness = 0;
            pane.specular = 0;
            floor.meshes.push_back(quad(vec3(-1.2f, 1.4f, -1.2f), vec3(0, 0, 2.4f), vec3(2.4f, 0, 0), 2));
            floor.materials.push_back(pane);
        }
        floor.lights = {point_light(vec3(0.4f, 0.8f, 0), 100)};
        FrameScene scene = floor.scene();
        look_closely(scene, vec3(0.3f, 1.5f, 0), vec3(0.3f, 0, 0), 0.5f);
        Bench bench;
        bench.settings = settings_of(photons, final_stage);
        bench.frame(scene, kSize);
        return bench.renderer().read(render::Aov::radiance);
    };
    for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
        double sum[2] = {0, 0}, difference = 0;
        const ImageF seen = radiance(true, 60'000, final_stage), dark = radiance(true, 0, final_stage);
        const ImageF open = radiance(false, 60'000, final_stage), plain = radiance(false, 0, final_stage);
        for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
            const double through = static_cast<double>(seen.pixels[i] - dark.pixels[i]);
            const double right = static_cast<double>(open.pixels[i] - plain.pixels[i]);
            sum[0] += through;
            sum[1] += right;
            difference += std::abs(through - right);
        }
        std::printf("through a window: %.4f of the caustic, mean difference %.4f\n", sum[0] / sum[1],
                    difference / sum[1]);
        EXPECT_GT(sum[1], 0);
        EXPECT_NEAR(sum[0] / sum[1], 1, 0.06);
        EXPECT_LT(difference / sum[1], 0.2);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
