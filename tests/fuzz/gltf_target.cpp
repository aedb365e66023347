#include "tests/fuzz/gltf_target.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "lanthorn/assets/gltf_import.h"
#include "tests/fuzz/gltf_seeds.h"
#include "tests/fuzz/played_scene.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/target.h"
#include "tests/unit/assets/scene_invariants.h"

namespace lanthorn::fuzz {

namespace {

constexpr std::string_view kGlbMark = "glTF";
constexpr std::size_t kGlbHead = 20;  // mark, version, length; length and kind of the first chunk

// Throws Finding for the first expectation that fails in `check`.
template <class Check>
void expect_all(Check check) {
    testing::TestPartResultArray results;
    {
        const testing::ScopedFakeTestPartResultReporter reporter(
            testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
        check();
    }
    for (int i = 0; i < results.size(); ++i) {
        if (results.GetTestPartResult(i).failed()) {
            throw Finding(results.GetTestPartResult(i).message());
        }
    }
}

// The JSON chunk of a .glb; of anything else, everything.
std::pair<std::size_t, std::size_t> json_place(const std::string& input) {
    if (!input.starts_with(kGlbMark) || input.size() < kGlbHead) {
        return {0, input.size()};
    }
    std::uint32_t length = 0;
    std::memcpy(&length, &input[12], sizeof length);
    return {kGlbHead, std::min<std::size_t>(length, input.size() - kGlbHead)};
}

}  // namespace

void read_gltf(std::string_view input) {
    const auto path = write_input(input.starts_with(kGlbMark) ? "scene.glb" : "scene.gltf", input);
    expect_refused_or_read([&] {
        SceneData scene = import_gltf(path);
        for (const std::string& warning : scene.warnings) {
            if (warning.size() > 500) {
                throw Finding("a warning of " + std::to_string(warning.size()) + " characters");
            }
        }
        expect_all([&] { expect_scene_invariants(scene); });
        expect_all([&] { expect_plays(std::move(scene)); });
    });
}

std::vector<std::string> gltf_inputs() {
    std::vector<std::string> inputs;
    for (const GltfBuilder& seed : {furnished(), encoded(), moving()}) {
        inputs.push_back(seed.glb());
        inputs.push_back(seed.gltf());
    }
    return inputs;
}

std::string damage_gltf(const std::string& input, Mutator& mutator) {
    const auto [begin, length] = json_place(input);
    nlohmann::json root =
        nlohmann::json::parse(input.begin() + static_cast<std::ptrdiff_t>(begin),
                              input.begin() + static_cast<std::ptrdiff_t>(begin + length), nullptr, false);
    if (root.is_discarded()) {
        return {};
    }
    mutator.damage_json(root);
    std::string text = root.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (begin == 0) {
        return text;
    }
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string whole = input.substr(0, begin) + text + input.substr(begin + length);
    const auto all = static_cast<std::uint32_t>(whole.size()),
               chunk = static_cast<std::uint32_t>(text.size());
    std::memcpy(&whole[8], &all, sizeof all);
    std::memcpy(&whole[12], &chunk, sizeof chunk);
    return whole;
}

}  // namespace lanthorn::fuzz
