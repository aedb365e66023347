// The figures of `lanthorn measure motions` on pictures whose errors and changes are known.
#include "tools/workbench/measure/image_changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "gi_module/reference/camera_rays.h"
#include "lanthorn/core/error.h"

namespace lanthorn::workbench {
namespace image_changes_test {

constexpr ivec2 kSize(40, 30);
constexpr auto kPixels = static_cast<std::size_t>(kSize.x) * static_cast<std::size_t>(kSize.y);

// A wall 2 m in front of a camera that stands at `eye` and looks along -Z; another, 1 m behind it, right of x
// = 0.3 m.
FrameScene seen_from(const vec3& eye, float turned = 0) {
    FrameScene frame;
    frame.bounds.add(vec3(-2));
    frame.bounds.add(vec3(2));
    frame.camera.position = eye;
    frame.camera.view = glm::rotate(mat4(1), turned, vec3(0, 1, 0)) * glm::translate(mat4(1), -eye);
    return frame;
}

ImageF image_of(const std::function<vec3(std::size_t)>& colour) {
    ImageF image{kSize.x, kSize.y, 3, {}, {}};
    for (std::size_t p = 0; p < kPixels; ++p) {
        const vec3 c = colour(p);
        image.pixels.insert(image.pixels.end(), {c.x, c.y, c.z});
    }
    return image;
}

Surfaces walls(const FrameScene& frame) {
    const reference::CameraRays rays(frame.camera, kSize);
    ImageF depth{kSize.x, kSize.y, 1, {}, {}};
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const auto ray = rays.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            float t = (-2 - ray.origin.z) / ray.direction.z;
            if (ray.origin.x + t * ray.direction.x > 0.3f) {
                t = (-3 - ray.origin.z) / ray.direction.z;
            }
            depth.pixels.push_back(t);
        }
    }
    return surfaces_of(frame, depth, image_of([](std::size_t) { return vec3(0, 0, 1); }));
}

// Light that depends on the place alone.
ImageF lit(const Surfaces& surfaces) {
    return image_of([&](std::size_t p) {
        const vec3& x = surfaces.positions[p];
        return vec3(3 + x.x, 2 + x.y, 1);
    });
}

class Errors : public testing::Test {
  protected:
    Errors()
        : surfaces_(walls(seen_from(vec3(0)))),
          truth_image_(lit(surfaces_)),
          pair_{truth_image_, truth_image_} {}

    Truth truth() const { return truth_at(pair_, surfaces_, surfaces_.seen()); }

    Surfaces surfaces_;
    ImageF truth_image_;
    ReferencePair pair_;
};

TEST_F(Errors, OfTheReferenceItselfAreNone) {
    const ImageError error = image_error(truth_image_, truth());
    EXPECT_EQ(error.relrmse, 0);
    EXPECT_EQ(error.local, 0);
    EXPECT_DOUBLE_EQ(error.flux, 1);
    EXPECT_EQ(unlit_pixels(image_of([](auto) { return vec3(0); }), truth_image_, truth()), 0u);
}

TEST_F(Errors, OfAKnownDifferenceAreKnown) {
    ImageF brighter = truth_image_;
    double squares = 0, sum = 0;
    for (float& v : brighter.pixels) {
        squares += static_cast<double>(v) * v;
        sum += v;
        v *= 1.2f;
    }
    const double n = static_cast<double>(brighter.pixels.size());
    const ImageError error = image_error(brighter, truth());
    EXPECT_NEAR(error.relrmse, 0.2 * std::sqrt(squares / n) / (sum / n), 1e-6);
    EXPECT_NEAR(error.flux, 1.2, 1e-6);
    EXPECT_NEAR(error.reference_mean, sum / n, 1e-6);
    EXPECT_NEAR(error.relrmse_sigma, 0, 1e-9) << "the references agree";
    // (0.2 r)^2 / (r^2 + 0.01 mean^2): a little less than 0.2 where r is about the mean.
    EXPECT_NEAR(error.local, 0.2 / std::sqrt(1.01), 2e-3);
}

TEST_F(Errors, InTheDarkAreRelativeToATenthOfTheMean) {
    // All of the light on one pixel in a hundred, black elsewhere: the picture has 0.001 everywhere.
    for (ImageF* image : {&pair_.a, &pair_.b}) {
        *image = image_of([](std::size_t p) { return vec3(p % 100 == 0 ? 1.0f : 0.0f); });
    }
    Truth dark = truth();
    for (std::size_t p = 0; p < kPixels; ++p) {
        dark.brightness[p] = p % 100 == 0 ? 1.0f : 0.0f;
    }
    const ImageF picture = image_of([](std::size_t p) { return vec3(p % 100 == 0 ? 1.0f : 0.001f); });
    EXPECT_NEAR(image_error(picture, dark).local, std::sqrt(0.99), 1e-4)
        << "0.001 over 0.1 of a mean of 0.01";
}

TEST_F(Errors, AreFreeOfTheReferencesNoise) {
    std::mt19937 random(1);
    std::exponential_distribution<float> strength(1);  // mean 1, deviation 1
    const auto noisy = [&] {
        ImageF image = truth_image_;
        for (std::size_t p = 0; p < kPixels; ++p) {
            const float factor = strength(random);
            for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) {
                image.pixels[c] *= factor;
            }
        }
        return image;
    };
    pair_ = {noisy(), noisy()};
    ImageF darker = truth_image_;
    for (float& v : darker.pixels) {
        v *= 0.5f;
    }
    const ImageError error = image_error(darker, truth());
    const double exact = 0.5 * noise_of(truth()).relrmse * std::sqrt(2.0);  // deviation 1 by two
    EXPECT_NEAR(noise_of(truth()).relrmse, 0.83, 0.06) << "of the mean of two";
    EXPECT_NEAR(error.relrmse, exact, 3 * error.relrmse_sigma);
    EXPECT_GT(error.relrmse_sigma, 0.01);
    EXPECT_LT(error.relrmse_sigma, 0.1);
    EXPECT_NEAR(error.local, 0.5, 0.06);
}

TEST_F(Errors, WithoutLightAreCounted) {
    const ImageF direct = image_of([](std::size_t p) { return vec3(p == 7 ? 1.0f : 0.0f); });
    ImageF picture = truth_image_;
    for (const std::size_t p : {5u, 7u, 9u, 11u}) {
        for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) {
            picture.pixels[c] *= p == 11 ? 0.02f : 0.005f;
        }
    }
    for (std::size_t c = 39; c < 42; ++c) {
        pair_.a.pixels[c] *= 400;  // one bright path by chance
    }
    EXPECT_EQ(unlit_pixels(direct, picture, truth()), 2u)
        << "7 has direct light, 11 is merely dark, 13 is lit as its neighbours are";
}

TEST_F(Errors, NearABoxAreOfItsSurroundings) {
    Aabb box;
    box.add(vec3(-0.1f, -0.1f, -1.9f));
    box.add(vec3(0.1f, 0.1f, -1.8f));
    const PixelMask mask = near_box(surfaces_, box, 0.4f);
    std::size_t count = 0;
    for (std::size_t p = 0; p < kPixels; ++p) {
        const vec2 beyond = glm::max(glm::abs(vec2(surfaces_.positions[p])) - 0.1f, vec2(0));
        const bool front = surfaces_.positions[p].z > -2.5f;
        EXPECT_EQ(mask[p] != 0, front && glm::dot(beyond, beyond) + 0.01f <= 0.16f) << p;
        count += mask[p];
    }
    EXPECT_GT(count, 100u);
}

class Changes : public testing::TestWithParam<float> {};  // radians that the camera turns

TEST_P(Changes, OfLightThatStaysAreNoneWhereverTheCameraGoes) {
    const Surfaces before = walls(seen_from(vec3(0)));
    const Surfaces now = walls(seen_from(vec3(0.02f, 0.01f, -0.03f), GetParam()));
    const SamePoints same(before, now);
    const ImageF found = same.seen_from_before(lit(now));
    const double change = mean_product(found, lit(before), found, lit(before), same.mask()).mean;
    EXPECT_LT(std::sqrt(change), 1e-3) << "light that is linear in place is interpolated exactly on a plane";
    std::size_t lost = 0;
    for (std::size_t p = 0; p < kPixels; ++p) {
        lost += same.mask()[p] != 0 ? 0 : 1;
    }
    EXPECT_GT(lost, 20u) << "what has left the picture, and the edge of the nearer wall";
    EXPECT_LT(lost, kPixels / 4);
}
INSTANTIATE_TEST_SUITE_P(Turns, Changes, testing::Values(0.0f, 0.02f, -0.03f));

TEST(SamePoints, SeeLightThatChanges) {
    const Surfaces before = walls(seen_from(vec3(0))), now = walls(seen_from(vec3(0.02f, 0, 0)));
    const SamePoints same(before, now);
    ImageF brighter = lit(now);
    for (float& v : brighter.pixels) {
        v += 0.25f;
    }
    const ImageF found = same.seen_from_before(brighter);
    EXPECT_NEAR(std::sqrt(mean_product(found, lit(before), found, lit(before), same.mask()).mean), 0.25,
                2e-3);
}

TEST(SamePoints, OfACameraThatStandsAreItsPixels) {
    const Surfaces surfaces = walls(seen_from(vec3(0)));
    const SamePoints same(surfaces, surfaces);
    EXPECT_EQ(same.mask(), surfaces.seen());
    const ImageF light = lit(surfaces), found = same.seen_from_before(light);
    for (std::size_t i = 0; i < light.pixels.size(); ++i) {
        ASSERT_NEAR(found.pixels[i], light.pixels[i], 1e-3f);
    }
}

TEST(SurfacesOf, RefusesAnOrthographicCamera) {
    FrameScene frame = seen_from(vec3(0));
    frame.camera.camera.orthographic = true;
    EXPECT_THROW(surfaces_of(frame, {}, {}), InputError);
}

}  // namespace image_changes_test
}  // namespace lanthorn::workbench
