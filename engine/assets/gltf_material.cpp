#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "engine/assets/gltf_context.h"
#include "engine/assets/gltf_material_layers.h"

namespace lanthorn {

namespace {

constexpr double kIorOfZero = 1e3;  // KHR_materials_ior: 0 stands for an infinite index

// The numbers of an extension object, which check_gltf() has checked.
double number(const tinygltf::Value& object, const char* key, double fallback) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

double element(const tinygltf::Value& object, const char* key, int index, double fallback) {
    return object.Has(key) ? object.Get(key).Get(index).GetNumberAsDouble() : fallback;
}

const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

class MaterialImport {
  public:
    MaterialImport(const GltfContext& context, std::size_t index)
        : context_(context),
          source_(context.model.materials[index]),
          place_(fmt::format("/materials/{}", index)) {}

    Material run();
    UvSets uv_sets() const { return uv_sets_; }  // after run()

  private:
    void place_uv_sets();
    void read_metallic_roughness();
    void read_emission();
    void read_alpha();
    void read_specular();
    void read_transmission();
    void read_volume();
    void read_ior();
    void read_clearcoat();
    void read_sheen();
    void tell_textures_unread(const tinygltf::Value& owner, std::initializer_list<const char*> keys,
                              const std::string& place) const;
    float clamped(double value, double low, double high, const std::string& place) const {
        return context_.clamped(value, low, high, place_ + place);
    }
    // Their uv_set is the file's until place_uv_sets().
    static TextureRef texture(int index, int uv_set, const tinygltf::Value* transform);
    static TextureRef texture(const tinygltf::Value& owner, const char* key);
    template <typename Info>
    static TextureRef texture(const Info& info) {
        return texture(info.index, info.texCoord, extension(info.extensions, "KHR_texture_transform"));
    }

    const GltfContext& context_;
    const tinygltf::Material& source_;
    std::string place_;
    Material result_;
    UvSets uv_sets_ = kPlainUvSets;
};

TextureRef MaterialImport::texture(int index, int uv_set, const tinygltf::Value* transform) {
    TextureRef ref;
    if (index < 0) {
        return ref;
    }
    if (transform != nullptr) {
        uv_set = static_cast<int>(number(*transform, "texCoord", uv_set));
        const double angle = number(*transform, "rotation", 0);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double x = element(*transform, "scale", 0, 1);
        const double y = element(*transform, "scale", 1, 1);
        // Counter-clockwise for V pointing down.
        ref.uv_transform[0] = vec3(c * x, s * y, element(*transform, "offset", 0, 0));
        ref.uv_transform[1] = vec3(-s * x, c * y, element(*transform, "offset", 1, 0));
    }
    ref.texture = static_cast<std::uint32_t>(index);
    ref.uv_set = static_cast<std::uint32_t>(uv_set);
    return ref;
}

TextureRef MaterialImport::texture(const tinygltf::Value& owner, const char* key) {
    if (!owner.Has(key)) {
        return {};
    }
    const tinygltf::Value& info = owner.Get(key);
    const tinygltf::Value& extensions = info.Get("extensions");
    const bool transformed = extensions.IsObject() && extensions.Has("KHR_texture_transform");
    return texture(static_cast<int>(number(info, "index", -1)), static_cast<int>(number(info, "texCoord", 0)),
                   transformed ? &extensions.Get("KHR_texture_transform") : nullptr);
}

void MaterialImport::read_metallic_roughness() {
    const tinygltf::PbrMetallicRoughness& pbr = source_.pbrMetallicRoughness;
    const std::string place = "/pbrMetallicRoughness";
    for (int i = 0; i < 4; ++i) {
        result_.base_colour[i] = clamped(pbr.baseColorFactor[static_cast<std::size_t>(i)], 0, 1,
                                         fmt::format("{}/baseColorFactor/{}", place, i));
    }
    result_.metallic = clamped(pbr.metallicFactor, 0, 1, place + "/metallicFactor");
    result_.roughness = clamped(pbr.roughnessFactor, 0, 1, place + "/roughnessFactor");
    result_.base_colour_texture = texture(pbr.baseColorTexture);
    result_.metallic_roughness_texture = texture(pbr.metallicRoughnessTexture);
}

void MaterialImport::read_emission() {
    double strength = 1;
    if (const auto* e = extension(source_.extensions, "KHR_materials_emissive_strength")) {
        strength = clamped(number(*e, "emissiveStrength", 1), 0, kNoLimit,
                           "/extensions/KHR_materials_emissive_strength/emissiveStrength");
    }
    for (int i = 0; i < 3; ++i) {
        const double factor = clamped(source_.emissiveFactor[static_cast<std::size_t>(i)], 0, 1,
                                      fmt::format("/emissiveFactor/{}", i));
        result_.emissive[i] = static_cast<float>(factor * strength);
    }
    result_.emissive_texture = texture(source_.emissiveTexture);
}

void MaterialImport::read_alpha() {
    if (source_.alphaMode != "OPAQUE" && source_.alphaMode != "MASK" && source_.alphaMode != "BLEND") {
        context_.warn(place_ + "/alphaMode",
                      fmt::format("'{}' is unknown; OPAQUE is used", source_.alphaMode));
    }
    result_.alpha_mode = source_.alphaMode == "MASK"    ? AlphaMode::mask
                         : source_.alphaMode == "BLEND" ? AlphaMode::blend
                                                        : AlphaMode::opaque;
    result_.alpha_cutoff = clamped(source_.alphaCutoff, 0, kNoLimit, "/alphaCutoff");
}

void MaterialImport::read_ior() {
    if (const auto* e = extension(source_.extensions, "KHR_materials_ior")) {
        const double ior = number(*e, "ior", 1.5);
        result_.ior = ior == 0 ? static_cast<float>(kIorOfZero)
                               : clamped(ior, 1, kIorOfZero, "/extensions/KHR_materials_ior/ior");
    }
}

void MaterialImport::read_specular() {
    const auto* e = extension(source_.extensions, "KHR_materials_specular");
    if (e == nullptr) {
        return;
    }
    const std::string place = "/extensions/KHR_materials_specular";
    result_.specular = clamped(number(*e, "specularFactor", 1), 0, 1, place + "/specularFactor");
    for (int i = 0; i < 3; ++i) {
        result_.specular_colour[i] = clamped(element(*e, "specularColorFactor", i, 1), 0, kNoLimit,
                                             fmt::format("{}/specularColorFactor/{}", place, i));
    }
    result_.specular_texture = texture(*e, "specularTexture");
    result_.specular_colour_texture = texture(*e, "specularColorTexture");
}

void MaterialImport::read_transmission() {
    const auto* e = extension(source_.extensions, "KHR_materials_transmission");
    if (e == nullptr) {
        return;
    }
    const std::string place = "/extensions/KHR_materials_transmission";
    result_.transmission = clamped(number(*e, "transmissionFactor", 0), 0, 1, place + "/transmissionFactor");
    result_.transmission_texture = texture(*e, "transmissionTexture");
}

// The thickness texture is for renderers that do not trace light through the volume.
void MaterialImport::read_volume() {
    const auto* e = extension(source_.extensions, "KHR_materials_volume");
    if (e == nullptr) {
        return;
    }
    const std::string place = "/extensions/KHR_materials_volume";
    result_.thickness = clamped(number(*e, "thicknessFactor", 0), 0, kNoLimit, place + "/thicknessFactor");
    result_.attenuation_distance =
        clamped(number(*e, "attenuationDistance", 0), 0, kNoLimit, place + "/attenuationDistance");
    for (int i = 0; i < 3; ++i) {
        result_.attenuation_colour[i] = clamped(element(*e, "attenuationColor", i, 1), 0, 1,
                                                fmt::format("{}/attenuationColor/{}", place, i));
    }
}

void MaterialImport::tell_textures_unread(const tinygltf::Value& owner,
                                          std::initializer_list<const char*> keys,
                                          const std::string& place) const {
    for (const char* key : keys) {
        if (owner.Has(key)) {
            context_.warn(fmt::format("{}{}/{}", place_, place, key), "is not read; the factor alone counts");
        }
    }
}

void MaterialImport::read_clearcoat() {
    const auto* e = extension(source_.extensions, "KHR_materials_clearcoat");
    if (e == nullptr) {
        return;
    }
    const std::string place = "/extensions/KHR_materials_clearcoat";
    const float factor = clamped(number(*e, "clearcoatFactor", 0), 0, 1, place + "/clearcoatFactor");
    if (factor > 0) {
        add_clearcoat(result_, factor);
        tell_textures_unread(*e, {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"},
                             place);
        context_.warn(place_ + place,
                      "the coat has no highlight of its own; what it reflects is added to the surface's");
    }
}

void MaterialImport::read_sheen() {
    const auto* e = extension(source_.extensions, "KHR_materials_sheen");
    if (e == nullptr) {
        return;
    }
    const std::string place = "/extensions/KHR_materials_sheen";
    vec3 colour{0};
    for (int i = 0; i < 3; ++i) {
        colour[i] = clamped(element(*e, "sheenColorFactor", i, 0), 0, 1,
                            fmt::format("{}/sheenColorFactor/{}", place, i));
    }
    if (colour != vec3(0)) {
        add_sheen(result_, colour,
                  clamped(number(*e, "sheenRoughnessFactor", 0), 0, 1, place + "/sheenRoughnessFactor"));
        tell_textures_unread(*e, {"sheenColorTexture", "sheenRoughnessTexture"}, place);
        context_.warn(place_ + place,
                      "the sheen has no angle; what it reflects is added to the diffuse colour");
    }
}

void MaterialImport::place_uv_sets() {
    std::set<std::uint32_t> used;
    for (const TextureRef* ref : result_.textures()) {
        if (ref->present()) {
            used.insert(ref->uv_set);
        }
    }
    uv_sets_ = choose_uv_sets(used);
    for (TextureRef* ref : result_.textures()) {
        const auto place = std::ranges::find(uv_sets_, ref->uv_set);
        *ref = place == uv_sets_.end() ? TextureRef{} : *ref;
        ref->uv_set = place == uv_sets_.end() ? 0 : static_cast<std::uint32_t>(place - uv_sets_.begin());
    }
    for (const std::uint32_t set : used) {
        if (std::ranges::find(uv_sets_, set) == uv_sets_.end()) {
            context_.warn(place_, fmt::format("its textures use more than two sets of texture coordinates; "
                                              "those that use TEXCOORD_{} are left out",
                                              set));
        }
    }
}

Material MaterialImport::run() {
    result_.name = source_.name;
    result_.double_sided = source_.doubleSided;
    result_.unlit = source_.extensions.contains("KHR_materials_unlit");
    result_.normal_scale = static_cast<float>(source_.normalTexture.scale);
    result_.occlusion_strength =
        clamped(source_.occlusionTexture.strength, 0, 1, "/occlusionTexture/strength");
    result_.normal_texture = texture(source_.normalTexture);
    result_.occlusion_texture = texture(source_.occlusionTexture);
    read_metallic_roughness();
    read_emission();
    read_alpha();
    read_ior();
    read_specular();
    read_transmission();
    read_volume();
    read_clearcoat();
    read_sheen();
    place_uv_sets();
    return result_;
}

}  // namespace

void import_materials(const GltfContext& context) {
    for (std::size_t i = 0; i < context.model.materials.size(); ++i) {
        MaterialImport material(context, i);
        context.scene.materials.push_back(material.run());
        context.uv_sets.push_back(material.uv_sets());
    }
}

}  // namespace lanthorn
