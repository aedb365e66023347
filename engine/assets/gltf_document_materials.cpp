// Changing and adding a document's materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/assets/gltf_document_state.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

constexpr float kIorOfZero = 1e3f;  // KHR_materials_ior: 0 stands for an infinite index
constexpr const char* kAlphaModes[] = {"OPAQUE", "MASK", "BLEND"};

double number_or(const Json& value, double fallback) {
    return value.is_number() ? value.get<double>() : fallback;
}

Json extension_member(const JsonText& owner, const char* extension, const char* key) {
    const JsonText* extensions = owner.find("extensions");
    const JsonText* found = extensions == nullptr ? nullptr : extensions->find(extension);
    return found == nullptr ? Json() : parsed(*found, key);
}

// As the importer multiplies them: 32-bit numbers, in double precision.
vec3 product(const Json& factor, double strength) {
    vec3 result(0);
    for (int i = 0; i < 3 && factor.is_array(); ++i) {
        result[i] = static_cast<float>(double(factor[static_cast<std::size_t>(i)].get<float>()) *
                                       static_cast<float>(strength));
    }
    return result;
}

struct Emission {
    Json factor;  // 0..1
    float strength = 1;
};

// Of the strengths that keep the factor within 0..1: the one that the file has, then the brightest channel,
// then a power of two, which always gives `emissive` back exactly.
Emission split(const vec3& emissive, double known_strength) {
    const float brightest = std::max({emissive.x, emissive.y, emissive.z, 1.0f});
    for (const float strength : {static_cast<float>(known_strength), brightest}) {
        Emission emission{plain_numbers(emissive / strength), strength};
        if (strength >= brightest && product(emission.factor, plain_number(strength)) == emissive) {
            return emission;
        }
    }
    const float power = std::exp2(std::ceil(std::log2(brightest)));
    return {plain_numbers(emissive / power), power};
}

Json texture_json(const TextureRef& ref) {
    Json info = {{"index", ref.texture}};
    if (ref.uv_set != 0) {
        info["texCoord"] = ref.uv_set;
    }
    const vec3& u = ref.uv_transform[0];
    const vec3& v = ref.uv_transform[1];
    if (u != vec3(1, 0, 0) || v != vec3(0, 1, 0)) {
        const double rotation = std::atan2(-double(v.x), double(u.x));
        const double x = std::hypot(double(u.x), double(v.x));
        const double y = u.y * std::sin(rotation) + v.y * std::cos(rotation);
        info["extensions"]["KHR_texture_transform"] = {{"offset", plain_numbers(vec2(u.z, v.z))},
                                                       {"rotation", plain_number(float(rotation))},
                                                       {"scale", plain_numbers(vec2(x, y))}};
    }
    return info;
}

}  // namespace

void GltfDocument::State::patch_extension(JsonText& owner, const char* extension, const char* key,
                                          const Json& value, const Json& fallback) {
    JsonText* extensions = owner.find("extensions");
    JsonText* known = extensions == nullptr ? nullptr : extensions->find(extension);
    JsonText none("{}");
    JsonText& target = known == nullptr ? none : *known;
    patch(target, key, value, fallback);
    if (known == nullptr && none.size() > 0) {
        object_at(owner, "extensions").set(extension, std::move(none));
        use_extension(extension);
    }
}

void GltfDocument::State::patch_material(JsonText& target, const Material& m, const std::string& place) {
    expect_all_in(m.base_colour, 0, 1, place + "/pbrMetallicRoughness/baseColorFactor");
    expect_in(m.metallic, 0, 1, place + "/pbrMetallicRoughness/metallicFactor");
    expect_in(m.roughness, 0, 1, place + "/pbrMetallicRoughness/roughnessFactor");
    expect_all_in(m.emissive, 0, kNoLimit, place + "/emissiveFactor");
    expect_in(m.normal_scale, -kNoLimit, kNoLimit, place + "/normalTexture/scale");
    expect_in(m.occlusion_strength, 0, 1, place + "/occlusionTexture/strength");
    expect_in(m.alpha_cutoff, 0, kNoLimit, place + "/alphaCutoff");
    expect_in(m.ior, 1, kIorOfZero, place + "/extensions/KHR_materials_ior/ior");
    expect_in(m.specular, 0, 1, place + "/extensions/KHR_materials_specular/specularFactor");
    expect_all_in(m.specular_colour, 0, kNoLimit,
                  place + "/extensions/KHR_materials_specular/specularColorFactor");
    expect_in(m.transmission, 0, 1, place + "/extensions/KHR_materials_transmission/transmissionFactor");
    const std::string volume = place + "/extensions/KHR_materials_volume";
    expect_in(m.thickness, 0, kNoLimit, volume + "/thicknessFactor");
    expect_in(m.attenuation_distance, 0, kNoLimit, volume + "/attenuationDistance");
    expect_all_in(m.attenuation_colour, 0, 1, volume + "/attenuationColor");

    JsonText none("{}");
    JsonText* known = target.find("pbrMetallicRoughness");
    JsonText& pbr = known == nullptr ? none : *known;
    patch(pbr, "baseColorFactor", plain_numbers(m.base_colour), Json{1, 1, 1, 1});
    patch(pbr, "metallicFactor", plain_number(m.metallic), 1);
    patch(pbr, "roughnessFactor", plain_number(m.roughness), 1);
    if (known == nullptr && none.size() > 0) {
        target.set("pbrMetallicRoughness", std::move(none));
    }
    if (JsonText* texture = target.find("normalTexture")) {
        patch(*texture, "scale", plain_number(m.normal_scale), 1);
    }
    if (JsonText* texture = target.find("occlusionTexture")) {
        patch(*texture, "strength", plain_number(m.occlusion_strength), 1);
    }
    constexpr const char* kStrength = "KHR_materials_emissive_strength";
    const double strength = number_or(extension_member(target, kStrength, "emissiveStrength"), 1);
    if (product(parsed(target, "emissiveFactor"), strength) != m.emissive) {
        const Emission emission = split(m.emissive, strength);
        patch(target, "emissiveFactor", emission.factor, Json{0, 0, 0});
        patch_extension(target, kStrength, "emissiveStrength", plain_number(emission.strength), 1);
    }
    patch(target, "alphaMode", kAlphaModes[static_cast<int>(m.alpha_mode)], "OPAQUE");
    patch(target, "alphaCutoff", plain_number(m.alpha_cutoff), 0.5);
    patch(target, "doubleSided", m.double_sided, false);
    const Json ior = extension_member(target, "KHR_materials_ior", "ior");
    if ((ior == 0 ? kIorOfZero : static_cast<float>(number_or(ior, 1.5))) != m.ior) {
        patch_extension(target, "KHR_materials_ior", "ior", m.ior == kIorOfZero ? 0 : plain_number(m.ior),
                        1.5);
    }
    patch_extension(target, "KHR_materials_specular", "specularFactor", plain_number(m.specular), 1);
    patch_extension(target, "KHR_materials_specular", "specularColorFactor", plain_numbers(m.specular_colour),
                    Json{1, 1, 1});
    patch_extension(target, "KHR_materials_transmission", "transmissionFactor", plain_number(m.transmission),
                    0);
    patch_extension(target, "KHR_materials_volume", "thicknessFactor", plain_number(m.thickness), 0);
    patch_extension(target, "KHR_materials_volume", "attenuationDistance",
                    m.attenuation_distance > 0 ? Json(plain_number(m.attenuation_distance)) : Json(), Json());
    patch_extension(target, "KHR_materials_volume", "attenuationColor", plain_numbers(m.attenuation_colour),
                    Json{1, 1, 1});
    const JsonText* extensions = target.find("extensions");
    if (m.unlit != (extensions != nullptr && extensions->find("KHR_materials_unlit") != nullptr)) {
        if (m.unlit) {
            object_at(target, "extensions").set("KHR_materials_unlit", JsonText("{}"));
            use_extension("KHR_materials_unlit");
        } else {
            target.find("extensions")->erase("KHR_materials_unlit");
        }
    }
}

void GltfDocument::set_material(std::size_t index, const Material& material) {
    JsonText patched = state_->element("materials", index);
    state_->patch_material(patched, material, fmt::format("/materials/{}", index));
    // The importer has put what these say into the material's own members.
    state_->restate_glossiness(patched);
    if (JsonText* extensions = patched.find("extensions")) {
        for (const char* restated : {"KHR_materials_clearcoat", "KHR_materials_sheen"}) {
            extensions->erase(restated);
        }
    }
    state_->element("materials", index) = std::move(patched);
}

std::size_t GltfDocument::add_material(const Material& m) {
    const std::size_t textures = state_->count("textures");
    const std::string place = fmt::format("/materials/{}", material_count());
    JsonText target("{\"name\":" + json_quoted(m.name) + ",\"pbrMetallicRoughness\":{}}");
    JsonText& pbr = *target.find("pbrMetallicRoughness");
    pbr.set("baseColorFactor", JsonText(plain_numbers(m.base_colour).dump()));
    pbr.set("metallicFactor", JsonText(Json(plain_number(m.metallic)).dump()));
    pbr.set("roughnessFactor", JsonText(Json(plain_number(m.roughness)).dump()));
    const auto info = [&](const TextureRef& ref, const char* key) {
        if (ref.texture >= textures) {
            state_->refuse(fmt::format("{}/{}/index", place, key),
                           fmt::format("found {}, expected an index below {} (the number of textures)",
                                       ref.texture, textures));
        }
        Json result = texture_json(ref);
        if (result.contains("extensions")) {
            state_->use_extension("KHR_texture_transform");
        }
        return result;
    };
    for (const auto& [owner, key, ref] : {std::tuple(&pbr, "baseColorTexture", &m.base_colour_texture),
                                          {&pbr, "metallicRoughnessTexture", &m.metallic_roughness_texture},
                                          {&target, "normalTexture", &m.normal_texture},
                                          {&target, "occlusionTexture", &m.occlusion_texture},
                                          {&target, "emissiveTexture", &m.emissive_texture}}) {
        if (ref->present()) {
            owner->set(key, JsonText(info(*ref, key).dump()));
        }
    }
    for (const auto& [extension, key, ref] :
         {std::tuple("KHR_materials_specular", "specularTexture", &m.specular_texture),
          {"KHR_materials_specular", "specularColorTexture", &m.specular_colour_texture},
          {"KHR_materials_transmission", "transmissionTexture", &m.transmission_texture}}) {
        if (ref->present()) {
            state_->patch_extension(target, extension, key, info(*ref, key), Json());
        }
    }
    state_->patch_material(target, m, place);
    return state_->append("materials", std::move(target));
}

}  // namespace lanthorn
