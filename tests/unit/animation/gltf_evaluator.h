// An evaluator of glTF animations of the tests' own, in double precision, written from the specification
// alone: it reads the files itself and shares nothing with the engine.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace animation_test {

// What a node has at some moment.
struct NodePose {
    std::array<double, 3> translation{0, 0, 0};
    std::array<double, 4> rotation{0, 0, 0, 1};  // x y z w
    std::array<double, 3> scale{1, 1, 1};
    std::vector<double> weights;
    bool moved = false;  // by the animation
};

class GltfEvaluator {
  public:
    // Throws for what it cannot read.
    explicit GltfEvaluator(const std::filesystem::path& file);

    const nlohmann::json& document() const { return json_; }
    // glTF node indices in the order of a walk through the scene: parents first, children in their order.
    std::vector<std::size_t> walk() const;
    // The nodes at `seconds` of the animation, by glTF index. Only nodes that are `moved` are filled in, and
    // only what the animation moves of them.
    std::vector<NodePose> evaluate(std::size_t animation, double seconds) const;
    // The key times of all channels.
    std::vector<double> key_times(std::size_t animation) const;

  private:
    std::vector<double> accessor(std::size_t index) const;
    std::vector<double> value(const nlohmann::json& sampler, std::size_t width, bool rotation,
                              double seconds) const;

    nlohmann::json json_;
    std::vector<std::vector<unsigned char>> buffers_;
};

}  // namespace animation_test
