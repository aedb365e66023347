#include "tests/fuzz/gltf_seeds.h"

#include <cstdint>
#include <vector>

namespace lanthorn {

using nlohmann::json;

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

}  // namespace lanthorn
