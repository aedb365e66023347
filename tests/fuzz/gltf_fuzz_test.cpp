// Damaged glTF files: whatever is in them, the importer refuses with an InputError or yields a sound scene,
// which can be played and deformed without a number that is none. LANTHORN_FUZZ_ROUNDS (default 4000) and
// LANTHORN_FUZZ_SEED (default 1) make it longer and different. A crash leaves its file as fuzz.glb or
// fuzz.gltf in the temporary folder; a failed expectation copies it to the working directory.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "lanthorn/animation/animator.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tests/fuzz/mutation.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/scene_invariants.h"

namespace lanthorn {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::uint64_t setting(const char* name, std::uint64_t fallback) {
    const char* text = std::getenv(name);
    return text == nullptr ? fallback : std::strtoull(text, nullptr, 10);
}

// Everything that materials, cameras, lights and nodes can say.
GltfBuilder furnished() {
    GltfBuilder b;
    const int texture = b.add_texture(make_png(8, 8, std::vector<std::uint8_t>(8 * 8 * 4, 100), 4));
    b.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9987}, {"wrapS", 33071}}};
    b.json["textures"][0]["sampler"] = 0;
    const json info = {
        {"index", texture},
        {"extensions",
         {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"rotation", 0.1}, {"scale", {2, 2}}}}}}};
    b.add_material(
        {{"name", "m"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 0.5, 0.25, 1}}, {"metallicFactor", 0}, {"baseColorTexture", info}}},
         {"normalTexture", {{"index", texture}, {"scale", 0.5}}},
         {"emissiveFactor", {1, 1, 0}},
         {"alphaMode", "MASK"},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}},
           {"KHR_materials_ior", {{"ior", 1.4}}},
           {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularTexture", info}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}});
    const int positions = b.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const int normals = b.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int uvs = b.add<float>({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 2);
    const int indices = b.add_scalars<std::uint16_t>({0, 1, 2, 2, 1, 3});
    b.add_primitive({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}},
                    indices)["material"] = 0;
    b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"intensity", 5}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}}};
    b.json["nodes"][0]["children"] = {1, 2};
    b.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 1, 2}}, {"rotation", {0, 0, 0, 1}}});
    b.json["nodes"].push_back({{"matrix", {1, 0, 0, 0, 0, 2, 0, 0, 0, 1, 1, 0, 3, 4, 5, 1}},
                               {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                               {"extras", {{"door", 1}}}});
    b.json["scenes"] = {{{"nodes", {0}}}};
    b.json["scene"] = 0;
    return b;
}

// Every way to lay out and encode vertices.
GltfBuilder encoded() {
    GltfBuilder b;
    const int interleaved = b.add_view(GltfBuilder::bytes_of<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1,
                                                                     0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1}),
                                       24);
    const int positions = b.add_accessor(interleaved, 5126, "VEC3", 4);
    const int normals = b.add_accessor(interleaved, 5126, "VEC3", 4);
    b.json["accessors"][normals]["byteOffset"] = 12;
    const int colours =
        b.add<std::uint8_t>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, "VEC4", 4);
    b.json["accessors"][colours]["normalized"] = true;
    const int tangents = b.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 1}, "VEC4", 4);
    b.add_primitive(
        {{"POSITION", positions}, {"NORMAL", normals}, {"COLOR_0", colours}, {"TANGENT", tangents}})["mode"] =
        5;
    const int sparse = b.add_accessor(-1, 5126, "VEC3", 5);
    b.json["accessors"][sparse]["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", b.add_view(GltfBuilder::bytes_of<std::uint16_t>({1, 4}))}, {"componentType", 5123}}},
        {"values", {{"bufferView", b.add_view(GltfBuilder::bytes_of<float>({1, 0, 0, 0, 3, 0}))}}}};
    b.add_primitive({{"POSITION", sparse}}, b.add_scalars<std::uint8_t>({0, 1, 4, 4, 1, 0}))["mode"] = 4;
    const int quantised = b.add_accessor(
        b.add_view(GltfBuilder::bytes_of<std::int16_t>({0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0}), 8), 5122,
        "VEC3", 3);
    b.add_primitive({{"POSITION", quantised}});
    return b;
}

// A skinned quad that morphs and is subdivided, and channels of every path and interpolation.
GltfBuilder moving() {
    GltfBuilder b;
    const int positions = b.add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int normals = b.add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int joints = b.add<std::uint8_t>({0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int weights = b.add<float>({0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.7f, 0.3f, 0, 0}, "VEC4", 4);
    json& primitive = b.add_primitive(
        {{"POSITION", positions}, {"NORMAL", normals}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
        b.add_scalars<std::uint16_t>({0, 1, 2, 0, 2, 3}));
    primitive["targets"] = {{{"POSITION", b.add_vec3({0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 2})}},
                            {{"NORMAL", b.add_vec3({0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0})}}};
    primitive["extras"] = {
        {"subdivision",
         {{"scheme", "catmull-clark"}, {"level", 2}, {"faces", {4}}, {"creases", {{0, 1, 3}}}}}};
    b.json["meshes"][0]["weights"] = {0.5, 0};
    b.json["nodes"][0]["skin"] = 0;
    b.json["nodes"].push_back({{"children", {2}}});
    b.json["nodes"].push_back({{"translation", {0, 1, 0}}});
    b.json["skins"] = {
        {{"joints", {1, 2}},
         {"inverseBindMatrices", b.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                              "MAT4", 16)}}};
    const int times = b.add_scalars<float>({0, 0.5f, 1});
    const auto channel = [&](int node, const char* path, int output, const char* interpolation) {
        json& animation = b.json["animations"][0];
        animation["samplers"].push_back(
            {{"input", times}, {"output", output}, {"interpolation", interpolation}});
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    };
    channel(1, "translation", b.add_vec3({0, 0, 0, 1, 0, 0, 0, 0, 1}), "LINEAR");
    channel(2, "rotation", b.add<float>({0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0}, "VEC4", 4), "LINEAR");
    channel(2, "scale", b.add_vec3(std::vector<float>(27, 1)), "CUBICSPLINE");
    channel(0, "weights", b.add_scalars<float>({0, 1, 1, 0, 0.5f, 0.5f}), "STEP");
    return b;
}

bool finite(const vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Plays every clip and looks at every vertex.
void expect_plays(SceneData scene) {
    ecs::World world;
    spawn(world, std::move(scene));
    Animator animator;
    Transforms transforms;
    Deformation deformation;
    const auto show = [&] {
        animator.animate(world, 0.37);
        transforms.update(world);
        deformation.update(world);
        world.query<ecs::Read<LocalTransform>>().each([](const LocalTransform& local) {
            ASSERT_TRUE(finite(local.value.translation) && finite(local.value.scale));
            ASSERT_NEAR(glm::length(local.value.rotation), 1, 1e-4);
        });
        world.query<ecs::Read<DeformedMeshes>>().each([](const DeformedMeshes& meshes) {
            for (const DeformedMesh& mesh : meshes.meshes) {
                for (std::size_t v = 0; mesh.vertices && v < mesh.vertices->size(); ++v) {
                    ASSERT_TRUE(finite((*mesh.vertices)[v].position) && finite((*mesh.vertices)[v].normal));
                }
            }
        });
    };
    show();
    for (const ecs::Entity holder : world.query<ecs::With<AnimationSet>>().entities()) {
        const AnimationSet set = world.get<AnimationSet>(holder);
        world.add(holder, AnimationPlayer{});
        for (std::uint32_t clip = 0; clip < set.clips->size(); ++clip) {
            play(world.get_mut<AnimationPlayer>(holder), set, clip);
            show();
            show();
        }
    }
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
