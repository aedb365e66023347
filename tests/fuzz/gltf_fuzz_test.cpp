// Damaged glTF files: whatever is in them, the importer refuses with an InputError or yields a sound scene,
// which can be played and deformed without a number that is none. LANTHORN_FUZZ_ROUNDS (default 4000) and
// LANTHORN_FUZZ_SEED (default 1) make it longer and different. A crash leaves its file as fuzz.glb or
// fuzz.gltf in the temporary folder; a failed expectation copies it to the working directory.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/fuzz/gltf_seeds.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/played_scene.h"
#include "tests/unit/assets/scene_invariants.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

std::uint64_t setting(const char* name, std::uint64_t fallback) {
    const char* text = std::getenv(name);
    return text == nullptr ? fallback : std::strtoull(text, nullptr, 10);
}

class GltfFuzz : public testing::Test {
  protected:
    // Imports `bytes`; counts what became of them.
    void expect_harmless(const std::string& name, const std::string& bytes) {
        const fs::path file = folder_.write(name, bytes);
        try {
            SceneData scene = import_gltf(file);
            expect_scene_invariants(scene);
            if (!HasFailure()) {
                expect_plays(std::move(scene));
            }
            ++loaded_;
        } catch (const InputError& error) {
            expect_places_in(error, file);
            ++refused_;
        }
        if (HasFailure()) {
            fs::copy_file(file, name, fs::copy_options::overwrite_existing);
            FAIL() << "the file is now " << fs::absolute(name);
        }
    }

    void TearDown() override { std::cout << loaded_ << " loaded, " << refused_ << " refused\n"; }

    const std::uint64_t rounds_ = setting("LANTHORN_FUZZ_ROUNDS", 4000);
    const std::uint64_t seed_ = setting("LANTHORN_FUZZ_SEED", 1);
    const std::vector<GltfBuilder> seeds_ = {furnished(), encoded(), moving()};
    TemporaryFolder folder_;
    std::uint64_t loaded_ = 0;
    std::uint64_t refused_ = 0;
};

TEST_F(GltfFuzz, TheSeedsAreSound) {
    for (const GltfBuilder& seed : seeds_) {
        for (const auto& [name, bytes] :
             {std::pair("fuzz.glb", seed.glb()), std::pair("fuzz.gltf", seed.gltf())}) {
            const SceneData scene = import_gltf(folder_.write(name, bytes));
            expect_scene_invariants(scene);
            EXPECT_TRUE(scene.warnings.empty()) << testing::PrintToString(scene.warnings);
            EXPECT_GE(scene.triangle_count(), 2u);
        }
    }
}

TEST_F(GltfFuzz, DamagedBytes) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {"fuzz.glb", seeds_[0].glb()},   {"fuzz.glb", seeds_[1].glb()},   {"fuzz.glb", seeds_[2].glb()},
        {"fuzz.gltf", seeds_[0].gltf()}, {"fuzz.gltf", seeds_[1].gltf()}, {"fuzz.gltf", seeds_[2].gltf()}};
    for (std::uint64_t round = 0; round < rounds_ && !HasFailure(); ++round) {
        SCOPED_TRACE(round);
        Mutator mutator(seed_ * 1000003 + round);
        auto [name, bytes] = files[round % files.size()];
        mutator.damage_bytes(bytes);
        expect_harmless(name, bytes);
    }
    EXPECT_GT(loaded_, 0u);
    EXPECT_GT(refused_, 0u);
}

TEST_F(GltfFuzz, DamagedBuffers) {
    for (std::uint64_t round = 0; round < rounds_ && !HasFailure(); ++round) {
        SCOPED_TRACE(round);
        Mutator mutator(seed_ * 1000033 + round);
        GltfBuilder builder = seeds_[round % seeds_.size()];
        const std::size_t size = builder.buffer.size();
        mutator.damage_bytes(builder.buffer);
        builder.buffer.resize(size);  // so that the damage is in the values, not in the size
        expect_harmless("fuzz.glb", builder.glb());
    }
    EXPECT_GT(loaded_, 0u);
    EXPECT_GT(refused_, 0u);
}

TEST_F(GltfFuzz, DamagedJson) {
    for (std::uint64_t round = 0; round < rounds_ && !HasFailure(); ++round) {
        SCOPED_TRACE(round);
        Mutator mutator(seed_ * 1000037 + round);
        GltfBuilder builder = seeds_[round % seeds_.size()];
        builder.json["buffers"] = {{{"byteLength", builder.buffer.size()}}};
        mutator.damage_json(builder.json);
        expect_harmless("fuzz.glb", builder.glb());
    }
    EXPECT_GT(loaded_, 0u);
    EXPECT_GT(refused_, 0u);
}

}  // namespace
}  // namespace lanthorn
