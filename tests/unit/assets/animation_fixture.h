// Animations of a file with one node that moves.
#pragma once

#include <string>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {

class AnimationImport : public ImportTest {
  protected:
    AnimationImport() { builder.json["nodes"] = {{{"name", "still"}}, {{"name", "mover"}}}; }

    // Another channel of animation 0, for node 1.
    nlohmann::json& add_channel(const std::string& path, int input, int output,
                                const char* interpolation = nullptr) {
        nlohmann::json& animation = builder.json["animations"][0];
        nlohmann::json sampler = {{"input", input}, {"output", output}};
        if (interpolation) {
            sampler["interpolation"] = interpolation;
        }
        animation["samplers"].push_back(sampler);
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", 1}, {"path", path}}}});
        return animation["channels"].back();
    }
    // A translation of two keys at 0 and 2 s.
    nlohmann::json& add_good_channel() {
        return add_channel("translation", builder.add_scalars<float>({0, 2}),
                           builder.add_vec3({0, 0, 0, 1, 2, 3}));
    }
    // The first channel's damage is told of, and the second stays.
    void expect_left_out(const std::string& place, const std::string& part) {
        add_channel("scale", builder.add_scalars<float>({0}), builder.add_vec3({1, 1, 1}));
        const SceneData scene = import();
        expect_warning(scene, place, part);
        EXPECT_NE(scene.warnings.at(0).find("; the channel is left out"), std::string::npos);
        ASSERT_EQ(scene.animations.size(), 1u);
        ASSERT_EQ(scene.animations[0].channels.size(), 1u);
        EXPECT_EQ(scene.animations[0].channels[0].path, AnimationPath::scale);
    }
    static std::string accessor(int index) { return "/accessors/" + std::to_string(index); }
};

}  // namespace lanthorn
