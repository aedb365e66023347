// Animations: channels of every path and encoding, and what is wrong with them.
#include "tests/unit/assets/animation_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

TEST_F(AnimationImport, EveryPathAndInterpolation) {
    const int times = builder.add_scalars<float>({0.5f, 2.0f});
    add_channel("translation", times, builder.add_vec3({0, 0, 0, 1, 2, 3}));
    add_channel("rotation", times, builder.add(std::vector<float>{0, 0, 0, 1, 0, 1, 0, 0}, "VEC4", 4),
                "STEP");
    add_channel("scale", times, builder.add_vec3(std::vector<float>(18, 2)), "CUBICSPLINE");
    builder.json["animations"][0]["name"] = "walk";
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    ASSERT_EQ(scene.animations.size(), 1u);
    const AnimationClip& clip = scene.animations[0];
    EXPECT_EQ(clip.name, "walk");
    EXPECT_EQ(clip.duration, 2);
    ASSERT_EQ(clip.channels.size(), 3u);
    EXPECT_EQ(scene.nodes[clip.channels[0].node].name, "mover");
    EXPECT_EQ(clip.channels[0].path, AnimationPath::translation);
    EXPECT_EQ(clip.channels[0].interpolation, Interpolation::linear);
    EXPECT_EQ(clip.channels[0].values, (std::vector<float>{0, 0, 0, 1, 2, 3}));
    EXPECT_EQ(clip.channels[0].times, (std::vector<float>{0.5f, 2.0f}));
    EXPECT_EQ(clip.channels[1].path, AnimationPath::rotation);
    EXPECT_EQ(clip.channels[1].interpolation, Interpolation::step);
    EXPECT_EQ(clip.channels[1].width, 4u);
    EXPECT_EQ(clip.channels[2].interpolation, Interpolation::cubic_spline);
    EXPECT_EQ(clip.channels[2].values.size(), 18u);
}

TEST_F(AnimationImport, WeightsHaveTheWidthOfTheMesh) {
    json& primitive = builder.add_triangle();
    const int up = builder.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", up}}};
    json& channel = add_channel("weights", builder.add_scalars<float>({0, 1, 2}),
                                builder.add_scalars<float>({0, 1, 2, 3, 4, 5}));
    channel["target"]["node"] = 2;
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_EQ(scene.animations.at(0).channels.at(0).width, 2u);
    EXPECT_EQ(scene.animations[0].channels[0].values, (std::vector<float>{0, 1, 2, 3, 4, 5}));
}

TEST_F(AnimationImport, QuantisedRotations) {
    const std::vector<std::int16_t> values = {0, 0, 0, 32767, 0, -32768, 0, 0};
    const int output = builder.add(values, "VEC4", 4);
    builder.json["accessors"].back()["normalized"] = true;
    add_channel("rotation", builder.add_scalars<float>({0, 1}), output);
    const SceneData scene = import();
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    EXPECT_EQ(scene.animations.at(0).channels.at(0).values, (std::vector<float>{0, 0, 0, 1, 0, -1, 0, 0}));
}

TEST_F(AnimationImport, SparseKeys) {
    const int output = builder.add_accessor(-1, 5126, "VEC3", 3);
    const int where = builder.add_view(GltfBuilder::bytes_of(std::vector<std::uint8_t>{1}));
    const int what = builder.add_view(GltfBuilder::bytes_of(std::vector<float>{7, 8, 9}));
    builder.json["accessors"][static_cast<std::size_t>(output)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", where}, {"componentType", 5121}}},
        {"values", {{"bufferView", what}}}};
    add_channel("translation", builder.add_scalars<float>({0, 1, 2}), output);
    const SceneData scene = import();
    EXPECT_EQ(scene.animations.at(0).channels.at(0).values, (std::vector<float>{0, 0, 0, 7, 8, 9, 0, 0, 0}));
}

TEST_F(AnimationImport, WrongTypes) {
    const int times = builder.add_scalars<float>({0, 1});
    add_channel("rotation", times, builder.add_vec3({0, 0, 0, 0, 0, 0}));
    expect_left_out("/animations/0/samplers/0/output", "no VEC4");
    builder.json.erase("animations");
    add_channel("translation", builder.add_scalars<std::uint16_t>({0, 1}),
                builder.add_vec3({0, 0, 0, 0, 0, 0}));
    expect_left_out("/animations/0/samplers/0/input", "no SCALAR of floats");
}

TEST_F(AnimationImport, TargetOutsideTheScene) {
    add_good_channel()["target"]["node"] = 0;
    builder.json["scenes"] = {{{"nodes", {1}}}};
    expect_left_out("/animations/0/channels/0/target/node", "node 0 is not in the scene");
}

TEST_F(AnimationImport, ChannelsWithoutANodeAndOfOtherPaths) {
    add_good_channel()["target"].erase("node");
    expect_left_out("/animations/0/channels/0/target", "found no node");
    builder.json.erase("animations");
    add_good_channel()["target"]["path"] = "pointer";
    expect_left_out("/animations/0/channels/0/target/path", "'pointer'");
    builder.json.erase("animations");
    add_good_channel()["target"]["path"] = "weights";
    expect_left_out("/animations/0/channels/0/target/node", "node 1 has no morph targets");
    builder.json.erase("animations");
    add_good_channel();
    builder.json["animations"][0]["samplers"][0]["interpolation"] = "BEZIER";
    expect_left_out("/animations/0/samplers/0/interpolation", "'BEZIER'");
}

TEST_F(AnimationImport, TheSecondChannelOfOneTarget) {
    add_channel("scale", builder.add_scalars<float>({0}), builder.add_vec3({2, 2, 2}));
    add_channel("scale", builder.add_scalars<float>({0}), builder.add_vec3({3, 3, 3}));
    const SceneData scene = import();
    expect_warning(scene, "/animations/0/channels/1/target", "left out");
    EXPECT_EQ(scene.animations.at(0).channels.at(0).values.at(0), 2);
}

TEST_F(AnimationImport, AnAnimationOfNothingIsLeftOut) {
    add_good_channel()["target"].erase("node");
    const SceneData scene = import();
    EXPECT_TRUE(scene.animations.empty());
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_EQ(scene.warnings[1], "/animations/0: no channel can be played; left out");
}

TEST_F(AnimationImport, BrokenStructureIsRefused) {
    add_good_channel();
    const json good = builder.json;
    builder.json["animations"][0]["channels"][0]["target"]["node"] = 5;
    expect_refused("/animations/0/channels/0/target/node", "expected an index below 2");
    builder.json = good;
    builder.json["animations"][0]["channels"][0]["sampler"] = 1;
    expect_refused("/animations/0/channels/0/sampler", "expected an index below 1");
    builder.json = good;
    builder.json["animations"][0]["samplers"][0]["input"] = 99;
    expect_refused("/animations/0/samplers/0/input");
    builder.json = good;
    builder.json["animations"][0]["channels"][0].erase("target");
    expect_refused("/animations/0/channels/0/target");
    builder.json = good;
    builder.json["animations"][0].erase("samplers");
    expect_refused("/animations/0/samplers");
    builder.json = good;
    builder.json["animations"] = {7};
    expect_refused("/animations/0", "an object");
}

}  // namespace
}  // namespace lanthorn
