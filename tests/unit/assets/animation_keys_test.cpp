// Keys that are not as glTF wants them: a bad key costs the key, and the channel is played.
#include <cmath>
#include <limits>

#include "tests/unit/assets/animation_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;
using Floats = std::vector<float>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();

class AnimationKeys : public AnimationImport {
  protected:
    // A translation along x.
    void add_path(const Floats& times, const Floats& xs, const char* interpolation = nullptr) {
        builder.json.erase("animations");
        input_ = builder.add_scalars<float>(times);
        Floats values;
        for (const float x : xs) {
            values.insert(values.end(), {x, 0, 0});
        }
        output_ = builder.add_vec3(values);
        add_channel("translation", input_, output_, interpolation);
    }
    // The channel's x at its keys, after a warning at `place`, if one is given, and no other.
    Floats path(const std::string& place, const std::string& part) {
        scene_ = import();
        expect_warning(scene_, place, part);
        Floats xs;
        for (std::size_t k = 0; k < channel().times.size(); ++k) {
            xs.push_back(channel().values[k * channel().values.size() / channel().times.size()]);
        }
        return xs;
    }
    const AnimationChannel& channel() const { return scene_.animations.at(0).channels.at(0); }
    std::string times_place() const { return accessor(input_); }
    std::string values_place() const { return accessor(output_); }

    SceneData scene_;
    int input_ = 0, output_ = 0;
};

TEST_F(AnimationKeys, BeforeZeroTheyStay) {
    add_path({-0.5f, 0.5f, 1.5f}, {-1, 0, 1});
    EXPECT_EQ(path(times_place(), "1 key before 0 s"), (Floats{-1, 0, 1}));
    EXPECT_EQ(channel().times, (Floats{-0.5f, 0.5f, 1.5f}));
    EXPECT_EQ(scene_.animations[0].duration, 1.5f);
    add_path({-3, -2, -1}, {4, 5, 6});
    EXPECT_EQ(path(times_place(), "3 keys before 0 s"), (Floats{4, 5, 6}));
    EXPECT_EQ(scene_.animations[0].duration, 0);
}

TEST_F(AnimationKeys, OfOneTimeAreALeap) {
    add_path({0, 1, 1, 2}, {-1.5f, -1, 0, 1});
    EXPECT_EQ(path(times_place(), "1 key at the time of one before"), (Floats{-1.5f, -1, 0, 1}));
    EXPECT_EQ(channel().times[1], 1);
    EXPECT_EQ(channel().times[2], std::nextafter(1.0f, 2.0f));
    add_path({0, 1, 1, 1, 2}, {0, 1, 77, 2, 3});
    EXPECT_EQ(path(times_place(), "2 keys at the time of one before"), (Floats{0, 1, 2, 3}));
    add_path({0, 0, 1}, {9, 1, 2});  // what is before the start is never seen
    EXPECT_EQ(path(times_place(), "1 key at the time of one before"), (Floats{1, 2}));
    add_path({0, 2, 2}, {0, 1, 5}, "STEP");
    EXPECT_EQ(path(times_place(), "1 key at the time of one before"), (Floats{0, 1, 5}));
    add_path({-1, -1, 1}, {0, 1, 2});
    scene_ = import();
    EXPECT_EQ(scene_.warnings.size(), 2u);
    EXPECT_EQ(channel().times.size(), 3u);
}

TEST_F(AnimationKeys, OutOfOrderAreSorted) {
    add_path({0, 2, 1, 3}, {0, 20, 10, 30});
    EXPECT_EQ(path(times_place(), "1 key earlier than one before"), (Floats{0, 10, 20, 30}));
    EXPECT_EQ(channel().times, (Floats{0, 1, 2, 3}));
    add_path({3, 2, 1, 0}, {30, 20, 10, 0}, "STEP");
    EXPECT_EQ(path(times_place(), "3 keys earlier than one before"), (Floats{0, 10, 20, 30}));
    // Splines take their tangents with them.
    add_path({1, 0}, {11, 1, 12, 21, 2, 22}, "CUBICSPLINE");
    EXPECT_EQ(path(times_place(), "1 key earlier"), (Floats{21, 11}));
    EXPECT_EQ(channel().values[3], 2);
}

TEST_F(AnimationKeys, WithoutATimeAreLeftOut) {
    for (const float time : {kNan, kEndless, -kEndless, 1e10f, -1e10f}) {
        add_path({0, time, 2}, {0, 99, 20});
        EXPECT_EQ(path(times_place(), "1 key at a time that is no number or beyond 1e9 s"), (Floats{0, 20}));
        EXPECT_EQ(channel().times, (Floats{0, 2}));
    }
}

TEST_F(AnimationKeys, WithoutAValueAreLeftOut) {
    for (const float value : {kNan, kEndless, 1e19f}) {
        add_path({0, 1, 2}, {0, value, 20});
        EXPECT_EQ(path(values_place(), "1 key no number"), (Floats{0, 20}));
        EXPECT_EQ(channel().times, (Floats{0, 2}));
    }
    add_path({0, 1, 2}, {0, 1, 0, 0, 2, kNan, 0, 3, 0}, "CUBICSPLINE");
    EXPECT_EQ(path(values_place(), "1 key no number").size(), 2u);
    EXPECT_EQ(channel().times, (Floats{0, 2}));
}

// Exporters leave what is before the first key and behind the last one to chance.
TEST_F(AnimationKeys, TangentsThatNothingUsesNeedBeNoNumbers) {
    add_path({0, 1}, {kNan, 1, 0, 0, 2, kEndless}, "CUBICSPLINE");
    scene_ = import();
    EXPECT_TRUE(scene_.warnings.empty()) << scene_.warnings[0];
    EXPECT_EQ(channel().values, (Floats{0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0}));
}

TEST_F(AnimationKeys, WithoutAnyTheChannelIsLeftOut) {
    add_path({kNan, kNan}, {0, 1});
    const SceneData scene = import();
    EXPECT_TRUE(scene.animations.empty());
    ASSERT_EQ(scene.warnings.size(), 3u);
    EXPECT_EQ(scene.warnings[1], "/animations/0/samplers/0: no key can be used; the channel is left out");
}

TEST_F(AnimationKeys, AllFaultsAtOnce) {
    add_path({2, kNan, -1, 1, 1, 0}, {20, 99, -10, 10, 11, kNan});
    scene_ = import();
    EXPECT_EQ(scene_.warnings.size(), 5u) << testing::PrintToString(scene_.warnings);
    EXPECT_EQ(channel().times, (Floats{-1, 1, std::nextafter(1.0f, 2.0f), 2}));
    EXPECT_EQ(channel().values, (Floats{-10, 0, 0, 10, 0, 0, 11, 0, 0, 20, 0, 0}));
}

TEST_F(AnimationKeys, AsManyAsHaveTimeAndValue) {
    const std::string place = "/animations/0/samplers/0/output";
    add_path({0, 1, 2}, {0, 10});
    EXPECT_EQ(path(place, "2 elements for 3 keys, expected 3; the first 2 keys are used"), (Floats{0, 10}));
    add_path({0, 1}, {0, 10, 20});
    EXPECT_EQ(path(place, "3 elements for 2 keys, expected 2"), (Floats{0, 10}));
    add_path({0, 1}, {5});
    EXPECT_EQ(path(place, "1 elements for 2 keys, expected 2; the first key is used"), (Floats{5}));
    add_path({0, 1}, {5}, "CUBICSPLINE");
    expect_left_out(place, "1 elements for 2 keys, expected 6");
}

TEST_F(AnimationKeys, TangentsTellTheInterpolation) {
    const std::string place = "/animations/0/samplers/0/output";
    add_path({0, 1}, {3, 4}, "CUBICSPLINE");
    EXPECT_EQ(path(place, "read as LINEAR"), (Floats{3, 4}));
    EXPECT_EQ(channel().interpolation, Interpolation::linear);
    add_path({0, 1}, {0, 3, 0, 0, 4, 0});
    path(place, "read as CUBICSPLINE");
    EXPECT_EQ(channel().interpolation, Interpolation::cubic_spline);
    EXPECT_EQ(channel().values[3], 3);
    add_path({0, 1}, {0, 3, 0, 0, 4, 0}, "STEP");
    EXPECT_EQ(path(place, "6 elements for 2 keys, expected 2"), (Floats{0, 3}));
    EXPECT_EQ(channel().interpolation, Interpolation::step);
}

TEST_F(AnimationKeys, RotationsAreMadeUnit) {
    const int values = builder.add(Floats{0, 0, 0, 1, 0, 3, 4, 0}, "VEC4", 4);
    add_channel("rotation", builder.add_scalars<float>({0, 1}), values);
    scene_ = import();
    expect_warning(scene_, accessor(values), "1 rotations");
    EXPECT_EQ(channel().values, (Floats{0, 0, 0, 1, 0, 0.6f, 0.8f, 0}));
}

TEST_F(AnimationKeys, ARotationOfZeroIsLeftOut) {
    const int values = builder.add(Floats{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4);
    add_channel("rotation", builder.add_scalars<float>({0, 1, 2}), values);
    scene_ = import();
    expect_warning(scene_, accessor(values), "a rotation of zero");
    EXPECT_EQ(channel().times, (Floats{0, 2}));
    EXPECT_EQ(channel().values, (Floats{0, 0, 0, 1, 0, 1, 0, 0}));
}

TEST_F(AnimationKeys, IntegersOfRotationsAreFractions) {
    const std::vector<std::int16_t> shorts = {0, 0, 0, 32767, 0, -32767, 0, 0};
    add_channel("rotation", builder.add_scalars<float>({0, 1}), builder.add(shorts, "VEC4", 4));
    scene_ = import();
    expect_warning(scene_, "/animations/0/samplers/0/output", "read as fractions");
    EXPECT_EQ(channel().values, (Floats{0, 0, 0, 1, 0, -1, 0, 0}));
    builder.json.erase("animations");
    const std::vector<std::int8_t> ones = {0, 0, 0, 1, 0, -1, 0, 0};  // numbers, and unit as such
    add_channel("rotation", builder.add_scalars<float>({0, 1}), builder.add(ones, "VEC4", 4));
    scene_ = import();
    EXPECT_TRUE(scene_.warnings.empty()) << scene_.warnings[0];
    EXPECT_EQ(channel().values, (Floats{0, 0, 0, 1, 0, -1, 0, 0}));
}

class WeightKeys : public AnimationKeys {
  protected:
    // Weights of a triangle with two morph targets.
    void add_weights(const Floats& times, int output) {
        json& primitive = builder.add_triangle();
        const int up = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
        primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", up}}};
        add_channel("weights", builder.add_scalars<float>(times), output)["target"]["node"] = 2;
        scene_ = import();
    }
};

TEST_F(WeightKeys, IntegersBeyondWhatWeightsAreAreFractions) {
    add_weights({0, 1}, builder.add_scalars<std::uint8_t>({0, 255, 51, 0}));
    expect_warning(scene_, "/animations/0/samplers/0/output", "read as fractions");
    EXPECT_EQ(channel().values, (Floats{0, 1, 0.2f, 0}));
}

TEST_F(WeightKeys, SmallIntegersAreNumbers) {
    add_weights({0, 1}, builder.add_scalars<std::uint8_t>({0, 1, 2, 0}));
    EXPECT_TRUE(scene_.warnings.empty()) << scene_.warnings[0];
    EXPECT_EQ(channel().values, (Floats{0, 1, 2, 0}));
}

TEST_F(WeightKeys, OfMoreTargetsThanTheMeshHas) {
    add_weights({0, 1}, builder.add_scalars<float>({1, 2, 3, 4, 5, 6, 7, 8}));
    expect_warning(scene_, "/animations/0/samplers/0/output", "4 weights a key, expected 2");
    EXPECT_EQ(channel().values, (Floats{1, 2, 5, 6}));
}

TEST_F(WeightKeys, OfFewerTargetsThanTheMeshHas) {
    add_weights({0, 1, 2}, builder.add_scalars<float>({1, 2, 3}));
    expect_warning(scene_, "/animations/0/samplers/0/output", "1 weights a key, expected 2");
    EXPECT_EQ(channel().values, (Floats{1, 0, 2, 0, 3, 0}));
}

TEST_F(WeightKeys, OfNoWholeNumberAreLeftOut) {
    add_weights({0, 1}, builder.add_scalars<float>({1, 2, 3}));
    EXPECT_TRUE(scene_.animations.empty());
    EXPECT_NE(scene_.warnings.at(0).find("3 elements for 2 keys, expected 4; the channel is left out"),
              std::string::npos);
}

}  // namespace
}  // namespace lanthorn
