// How much of the light each reflection is taken to carry, against closed forms.
#include "gi_module/carried_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lanthorn::gi {
namespace carried_light_test {

// A scene of boxes, of which only bounds and albedo count.
class Boxes {
  public:
    Boxes() { scene_.assets = assets_; }
    Boxes& box(const vec3& lower, const vec3& upper, float albedo) {
        Material material;
        material.base_colour = vec4(vec3(albedo), 1);
        material.metallic = 0;
        material.specular = 0;
        assets_->materials.push_back(material);
        Mesh mesh;
        mesh.material = static_cast<std::uint32_t>(scene_.instances.size());
        assets_->meshes.push_back(mesh);
        Instance instance;
        instance.mesh = mesh.material;
        instance.bounds = {lower, upper};
        scene_.instances.push_back(instance);
        scene_.bounds.add(instance.bounds);
        return *this;
    }
    Boxes& lamp(const vec3& position) {
        LightInstance light;
        light.position = position;
        light.light.intensity = 100;
        scene_.lights.push_back(light);
        return *this;
    }
    CarriedLight carried() const { return light_bounds(scene_).carried; }
    FrameScene& scene() { return scene_; }

  private:
    std::shared_ptr<SceneAssets> assets_ = std::make_shared<SceneAssets>();
    FrameScene scene_;
};

TEST(CarriedLight, OfAClosedRoomIsAPowerOfItsAlbedo) {
    for (const float albedo : {0.03f, 0.5f, 0.9f}) {
        const CarriedLight carried =
            Boxes().box(vec3(0), vec3(4, 3, 5), albedo).lamp(vec3(2, 2, 2)).carried();
        for (std::size_t b = 0; b < carried.size(); ++b) {
            EXPECT_NEAR(carried[b], std::pow(albedo, static_cast<float>(b + 1)), 1e-6f) << albedo << ' ' << b;
        }
    }
}

// What the brightest surface alone would tell: 0.9, 0.81, ...
TEST(CarriedLight, AWhiteThingInADarkHallDoesNotBrightenIt) {
    const CarriedLight carried = Boxes()
                                     .box(vec3(0), vec3(12, 6, 20), 0.03f)
                                     .box(vec3(5, 1, 12), vec3(5.3f, 1.3f, 12.3f), 0.9f)
                                     .lamp(vec3(6, 5, 4))
                                     .carried();
    EXPECT_LT(carried[0], 0.035f);
    EXPECT_GT(carried[0], 0.03f);
    EXPECT_LT(carried[1], 1.0f / 500);
    EXPECT_EQ(useful_bounces(carried, 4), 1);
}

TEST(CarriedLight, AWhiteNookWithTheLampInItKeepsItsReflections) {
    const CarriedLight carried = Boxes()
                                     .box(vec3(0), vec3(12, 6, 20), 0.03f)
                                     .box(vec3(5, 0, 12), vec3(6, 1, 13), 0.9f)
                                     .lamp(vec3(5.5f, 0.5f, 12.5f))
                                     .carried();
    // By hand: A / d^2, d at least half the diagonal. The lamp is at the nook's centre.
    const float nook = 6 / 0.75f, hall = 864 / 145.0f, from_hall = 6 / 12.75f;
    const float w = nook / (nook + hall), v = from_hall / (from_hall + hall);
    const float from_nook = w * 0.9f + (1 - w) * 0.03f, of_hall = v * 0.9f + (1 - v) * 0.03f;
    EXPECT_NEAR(carried[0], from_nook, 1e-5f);
    EXPECT_NEAR(carried[1], w * 0.9f * from_nook + (1 - w) * 0.03f * of_hall, 1e-5f);
    EXPECT_EQ(useful_bounces(carried, 4), 4);
}

TEST(CarriedLight, IsNeverMoreThanTheBrightestSurfaceAllows) {
    for (int seed = 1; seed <= 50; ++seed) {
        std::uint32_t state = static_cast<std::uint32_t>(seed) * 2654435761u;
        const auto number = [&] {
            state = state * 1664525u + 1013904223u;
            return static_cast<float>(state >> 8) / 16777216.0f;
        };
        Boxes boxes;
        float brightest = 0;
        for (int i = 0; i < 3 * seed; ++i) {
            const vec3 lower = 10.0f * vec3(number(), number(), number());
            const float albedo = number();
            brightest = std::max(brightest, albedo);
            boxes.box(lower, lower + 3.0f * vec3(number(), number(), number()), albedo);
        }
        boxes.lamp(10.0f * vec3(number(), number(), number()));
        const CarriedLight carried = boxes.carried();
        for (std::size_t b = 0; b < carried.size(); ++b) {
            EXPECT_LE(carried[b], std::pow(brightest, static_cast<float>(b + 1)) * 1.0001f);
            EXPECT_LE(carried[b], b > 0 ? carried[b - 1] * 1.0001f : 1);
        }
        EXPECT_GT(carried[0], 0);
    }
}

TEST(CarriedLight, WhereNothingCanBeToldTheBrightestSurfaceDecides) {
    const auto bound = [](float albedo, std::size_t b) {
        return std::pow(albedo, static_cast<float>(b + 1));
    };
    const CarriedLight flat = Boxes().box(vec3(1), vec3(1), 0.5f).lamp(vec3(0)).carried();
    EXPECT_FLOAT_EQ(flat[2], bound(0.5f, 2)) << "no area";
    Boxes far = Boxes().box(vec3(0), vec3(1), 0.5f).lamp(vec3(100));
    far.scene().lights[0].light.range = 3;
    EXPECT_FLOAT_EQ(far.carried()[1], bound(0.5f, 1)) << "no lamp reaches it";
    Boxes many;
    for (int i = 0; i < 3000; ++i) {
        many.box(vec3(0), vec3(1), i == 7 ? 0.8f : 0.1f);
    }
    EXPECT_FLOAT_EQ(many.lamp(vec3(2)).carried()[1], bound(0.8f, 1)) << "too many";
    Boxes odd = Boxes().box(vec3(0), vec3(std::numeric_limits<float>::max()), 0.5f).lamp(vec3(0));
    EXPECT_FLOAT_EQ(odd.carried()[1], bound(0.5f, 1)) << "areas that are no numbers";
}

TEST(CarriedLight, OfManyPiecesTheWeakAreOne) {
    Boxes boxes;
    boxes.box(vec3(0), vec3(10, 4, 10), 0.2f);
    for (int i = 0; i < 500; ++i) {
        const auto x = static_cast<float>(i % 25), z = static_cast<float>(i / 25);
        boxes.box(vec3(0.4f * x, 0, 0.4f * z), vec3(0.4f * x + 0.2f, 0.1f, 0.4f * z + 0.2f), 0.2f);
    }
    const CarriedLight carried = boxes.lamp(vec3(5, 3, 5)).carried();
    EXPECT_NEAR(carried[1], 0.04f, 1e-5f);
}

TEST(UsefulBounces, AreThoseThatCarryA500thAndGivenUpBelowHalfOfThat) {
    CarriedLight carried{0.5f, 0.1f, 0.003f, 0.0015f, 0.0005f};
    EXPECT_EQ(useful_bounces(carried, 8), 3);
    EXPECT_EQ(useful_bounces(carried, 2), 2);
    EXPECT_EQ(useful_bounces(carried, 8, 3), 3);
    EXPECT_EQ(useful_bounces(carried, 8, 4), 4) << "the fourth was there, and carries more than a 1000th";
    EXPECT_EQ(useful_bounces(carried, 8, 8), 4);
    EXPECT_EQ(useful_bounces({}, 8, 8), 1);
    carried.fill(1);
    EXPECT_EQ(useful_bounces(carried, 64), 8);
}

}  // namespace carried_light_test
}  // namespace lanthorn::gi
